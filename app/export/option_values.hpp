/// @file What the options of `cognate export` are set to. Errors say what is allowed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/export/export_options.hpp"

namespace cognate::app {

template <class Value>
using OptionValue = tl::expected<Value, std::string>;

OptionValue<ExportFormat> parse_format(std::string_view text);
OptionValue<DxfVersion> parse_version(std::string_view text);
OptionValue<CamCurveKind> parse_curve(std::string_view text);
OptionValue<PartLabels> parse_labels(std::string_view text);
OptionValue<std::optional<Bearing>> parse_bearing(std::string_view text);
OptionValue<std::optional<Screw>> parse_screw(std::string_view text);
OptionValue<double> parse_position(std::string_view text);
OptionValue<double> parse_length(std::string_view option, std::string_view text);
OptionValue<double> parse_length_or_0(std::string_view option, std::string_view text);

/// A whole number from 1 to `most`.
OptionValue<int> parse_count(std::string_view option, std::string_view text, int most);

/// Two lengths as "600x400".
OptionValue<Vec2d> parse_sheet(const std::string& text);
OptionValue<Vec2d> parse_block(const std::string& text);

/// A thickness, or a thickness and an outside diameter as "1x10"; the diameter is 0 without one.
OptionValue<Vec2d> parse_washer(const std::string& text);

/// One length, or two with a comma between: of the pinion and of the wheel.
OptionValue<std::vector<double>> parse_lengths(std::string_view option, const std::string& text);

}  // namespace cognate::app
