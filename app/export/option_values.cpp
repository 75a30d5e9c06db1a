#include "app/export/option_values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/console/option_text.hpp"

namespace cognate::app {
namespace {

/// Two lengths with an x between; empty where the text is none.
std::optional<Vec2d> two_lengths(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto first = parse_length("", text.substr(0, cross));
  const auto second = parse_length("", text.substr(cross + 1));
  return first && second ? std::optional(Vec2d{*first, *second}) : std::nullopt;
}

}  // namespace

tl::expected<ExportFormat, std::string> parse_format(std::string_view text) {
  const auto found = std::ranges::find(kExportFormats, text, &FormatDeclaration::word);
  if (found != kExportFormats.end()) return found->id;
  const auto of_cams = [](const auto& format) { return format.of_cams; };
  const auto of_no_cams = [](const auto& format) { return format.of_gears && !format.of_cams; };
  const auto of_linkages = [](const auto& format) { return !format.of_gears && !format.of_cams; };
  return refusal("--format", text,
                 fmt::format("{}, of gears and linkages also {}, of linkages also {}",
                             format_words(of_cams, " or "), format_words(of_no_cams, " and "),
                             format_words(of_linkages, " and ")));
}

tl::expected<DxfVersion, std::string> parse_version(std::string_view text) {
  if (text == "r12") return DxfVersion::r12;
  if (text == "2000") return DxfVersion::r2000;
  return refusal("--dxf-version", text, "r12 or 2000");
}

tl::expected<CamCurveKind, std::string> parse_curve(std::string_view text) {
  if (text == "profile") return CamCurveKind::profile;
  if (text == "pitch") return CamCurveKind::pitch;
  if (text == "cutter") return CamCurveKind::cutter;
  return refusal("--curve", text, "profile, pitch or cutter");
}

tl::expected<int, std::string> parse_count(std::string_view option, std::string_view text,
                                           int most) {
  const auto number = parse_all<int>(text);
  if (number && *number >= 1 && *number <= most) return *number;
  return refusal(option, text, fmt::format("a whole number from 1 to {}", most));
}

tl::expected<double, std::string> parse_position(std::string_view text) {
  constexpr double kMost = 1e9;
  const auto number = parse_all<double>(text);
  if (number && std::abs(*number) <= kMost) return *number;
  return refusal("--position", text, "degrees, or of a driving slider a length, up to 1e9");
}

tl::expected<double, std::string> parse_length(std::string_view option, std::string_view text) {
  const auto length = parse_all<double>(text);
  if (length && *length >= 1e-30 && *length <= 1e30) return *length;
  return refusal(option, text, "a length from 1e-30 to 1e30");
}

tl::expected<double, std::string> parse_length_or_0(std::string_view option,
                                                    std::string_view text) {
  const auto length = parse_all<double>(text);
  if (length && (*length == 0 || (*length >= 1e-30 && *length <= 1e30))) return *length;
  return refusal(option, text, "0 or a length from 1e-30 to 1e30");
}

tl::expected<Vec2d, std::string> parse_sheet(const std::string& text) {
  if (const auto sizes = two_lengths(text)) return *sizes;
  return refusal("--sheet", text, "a width and a height such as 600x400");
}

tl::expected<Vec2d, std::string> parse_block(const std::string& text) {
  if (const auto sizes = two_lengths(text)) return *sizes;
  return refusal("--block", text, "a length along the slot and a width such as 20x12");
}

tl::expected<Vec2d, std::string> parse_washer(const std::string& text) {
  if (const auto thickness = parse_length("--washer", text)) return Vec2d{*thickness, 0};
  if (const auto sizes = two_lengths(text)) return *sizes;
  return refusal("--washer", text, "a thickness, or one with an outside diameter such as 1x10");
}

tl::expected<std::optional<Screw>, std::string> parse_screw(std::string_view text) {
  if (const auto screw = screw_called(text)) return screw;
  return refusal("--screw", text, screw_designations());
}

tl::expected<PartLabels, std::string> parse_labels(std::string_view text) {
  if (text == "none") return PartLabels::none;
  if (text == "text") return PartLabels::text;
  if (text == "stroke") return PartLabels::stroke;
  return refusal("--labels", text, "none, text or stroke");
}

tl::expected<std::optional<Bearing>, std::string> parse_bearing(std::string_view text) {
  if (const auto bearing = bearing_called(text)) return bearing;
  return refusal("--bearing", text, bearing_designations());
}

tl::expected<std::vector<double>, std::string> parse_lengths(std::string_view option,
                                                             const std::string& text) {
  const std::size_t comma = text.find(',');
  std::vector<double> lengths;
  for (const std::string& part : comma == std::string::npos
                                     ? std::vector{text}
                                     : std::vector{text.substr(0, comma), text.substr(comma + 1)}) {
    const auto length = parse_length(option, part);
    if (!length) {
      return refusal(option, text, "a length from 1e-30 to 1e30, or two as 10,20 of a pair");
    }
    lengths.push_back(*length);
  }
  return lengths;
}

tl::expected<int, std::string> parse_design(std::string_view text) {
  constexpr int kMostDesigns = 1'000'000;
  return parse_count("--design", text, kMostDesigns);
}

tl::expected<std::int64_t, std::string> parse_row(std::string_view text) {
  const auto number = parse_all<std::int64_t>(text);
  if (number && *number >= 0) return *number;
  return refusal("--row", text, "the id of a row, a whole number from 0 on");
}

}  // namespace cognate::app
