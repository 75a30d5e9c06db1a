#include "app/export/export_options.hpp"

#include "app/option_text.hpp"

namespace cognate::app {

tl::expected<ExportFormat, std::string> parse_format(std::string_view text) {
  if (text == "dxf") return ExportFormat::dxf;
  if (text == "svg") return ExportFormat::svg;
  if (text == "csv") return ExportFormat::csv;
  return refusal("--format", text, "dxf, svg or csv");
}

tl::expected<ExportedCurve, std::string> parse_curve(std::string_view text) {
  if (text == "profile") return ExportedCurve::profile;
  if (text == "pitch") return ExportedCurve::pitch;
  if (text == "cutter") return ExportedCurve::cutter;
  return refusal("--curve", text, "profile, pitch or cutter");
}

tl::expected<int, std::string> parse_design(std::string_view text) {
  constexpr int kMost = 1'000'000;
  const auto number = parse_all<int>(text);
  if (number && *number >= 1 && *number <= kMost) return *number;
  return refusal("--design", text, fmt::format("a whole number from 1 to {}", kMost));
}

tl::expected<std::int64_t, std::string> parse_row(std::string_view text) {
  const auto number = parse_all<std::int64_t>(text);
  if (number && *number >= 0) return *number;
  return refusal("--row", text, "the id of a row, a whole number from 0 on");
}

tl::expected<double, std::string> parse_length(std::string_view option, std::string_view text) {
  const auto length = parse_all<double>(text);
  if (length && *length >= 1e-30 && *length <= 1e30) return *length;
  return refusal(option, text, "a length from 1e-30 to 1e30");
}

}  // namespace cognate::app
