/// @file The options of `cognate export`, and what each may be.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "app/export/cam_drawing.hpp"

namespace cognate::app {

enum class ExportFormat { dxf, svg, csv };

struct ExportOptions {
  ExportFormat format = ExportFormat::dxf;
  int design = 1;  ///< counted from 1
  DrawingOrder order;
};

/// The errors of these say what is wrong with the text and what is allowed.

tl::expected<ExportFormat, std::string> parse_format(std::string_view text);
tl::expected<ExportedCurve, std::string> parse_curve(std::string_view text);

/// A whole number from 1 to 10⁶.
tl::expected<int, std::string> parse_design(std::string_view text);

/// The number of a design of a study: a whole number from 0 on.
tl::expected<std::int64_t, std::string> parse_row(std::string_view text);

/// A length from 1e-30 to 1e30; `option` is its name.
tl::expected<double, std::string> parse_length(std::string_view option, std::string_view text);

}  // namespace cognate::app
