#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "app/export/exported.hpp"
#include "app/export/toml_text.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

constexpr double kGreatest = 1e100;  // of what a problem file may hold

std::optional<double> number(const ordered_json& value) {
  if (!value.is_number()) return std::nullopt;
  const double x = value.get<double>();
  return std::abs(x) <= kGreatest ? std::optional(x) : std::nullopt;
}

/// What is under `key`; null where there is nothing.
const ordered_json& member(const ordered_json& table, const char* key) {
  static const ordered_json nothing;
  if (!table.is_object()) return nothing;
  const auto found = table.find(key);
  return found == table.end() ? nothing : *found;
}

bool is_analysis(const ResultDesign& given) {
  return text_under(given.problem, "kind") == "analysis";
}

/// The drive coordinates at the targets of a synthesis: radians, or a length.
std::vector<double> stations(const ResultDesign& given, bool slides) {
  const ordered_json& list = member(given.table, slides ? "slide" : "crank_deg");
  std::vector<double> values;
  if (is_analysis(given) || !list.is_array()) return values;
  for (const auto& value : list) {
    if (const auto x = number(value)) values.push_back(slides ? *x : *x * kTurn / 360);
  }
  return values;
}

/// The points and the origins of the poses that the problem's `target` lists.
std::vector<Vec2d> targets(const ordered_json& problem) {
  std::vector<Vec2d> points;
  for (const char* key : {"poses", "points"}) {
    const ordered_json& list = member(member(problem, "target"), key);
    if (!list.is_array()) continue;
    for (const auto& entry : list) {
      if (!entry.is_array() || entry.size() < 2) continue;
      const auto x = number(entry[0]), y = number(entry[1]);
      if (x && y) points.push_back({*x, *y});
    }
  }
  return points;
}

/// `value` with 0 for numbers too small for a file, which are rounding.
ordered_json without_rounding(const ordered_json& value) {
  constexpr double kLeast = 1e-30;
  if (value.is_number()) return std::abs(value.get<double>()) < kLeast ? ordered_json(0) : value;
  if (!value.is_structured()) return value;
  ordered_json clean = value;
  for (auto& part : clean) part = without_rounding(part);
  return clean;
}

/// The analysis of the design's mechanism, as a file would ask for it.
ordered_json analysis_tables(const ResultDesign& given) {
  const ordered_json mechanism = without_rounding(given.table["mechanism"]);
  ordered_json tables = head_of(given, "analysis");
  tables["mechanism"] = mechanism;
  if (is_analysis(given)) {
    tables["drive"] = member(given.problem, "drive");
  } else if (mechanism.contains("slider")) {
    tables["drive"] = {{"end", 1}};  // until the stations tell
  }
  tables["output"] = {{"velocity", false}, {"acceleration", false}, {"transmission", false}};
  return tables;
}

/// The sizes of parts that the file gives, those of the links of `mechanism`.
std::optional<problems::LayerSizes> layer_sizes(const ordered_json& problem,
                                                const problems::NamedMechanism& mechanism) {
  const ordered_json& table = member(problem, "layers");
  const auto width = number(member(table, "link_width")),
             pin = number(member(table, "pin_diameter"));
  if (!width || !pin || !(*pin > 0 && *width > 0)) return std::nullopt;
  problems::LayerSizes sizes{.link_width = *width, .pin_diameter = *pin};
  sizes.clearance = std::max(number(member(table, "clearance")).value_or(0), 0.0);
  sizes.thickness = number(member(table, "thickness"));
  if (sizes.thickness && !(*sizes.thickness > 0)) sizes.thickness.reset();
  for (const std::string& link : mechanism.bodies) {
    const auto own = number(member(member(table, "widths"), link.c_str()));
    if (own && *own > 0) sizes.widths.push_back({link, *own});
  }
  return sizes;
}

/// The same as a table of a file.
ordered_json sizes_table(const problems::LayerSizes& sizes) {
  ordered_json table = {{"link_width", sizes.link_width},
                        {"pin_diameter", sizes.pin_diameter},
                        {"clearance", sizes.clearance}};
  if (sizes.thickness) table["thickness"] = *sizes.thickness;
  for (const auto& [link, width] : sizes.widths) table["widths"][link] = width;
  return table;
}

/// Lets the drive of a synthesised linkage run where it can be assembled; the error says why not.
tl::expected<void, std::string> choose_span(LinkageScene& linkage) {
  const auto span = problems::drive_span(linkage.problem.mechanism.mechanism, linkage.stations);
  if (!span && is_driven_by_slider(linkage)) {
    return tl::unexpected(
        std::string("its slider has no two positions between which it could be shown; expected the "
                    "result of an analysis"));
  }
  if (!span) {
    return tl::unexpected(
        std::string("it can be assembled nowhere; expected a mechanism that can be"));
  }
  linkage.problem.drive.start = span->from;
  linkage.problem.drive.end = span->to;
  linkage.round = span->round;
  linkage.beyond = !span->round;
  return {};
}

}  // namespace

tl::expected<LinkageScene, std::string> result_linkage(const ResultDesign& given) {
  const auto refuse = [&](std::string_view what) {
    return tl::unexpected(fmt::format("{}: designs[{}]: {}", given.name, given.design - 1, what));
  };
  auto problem = problems::parse_task<problems::AnalysisProblem>(toml_text(analysis_tables(given)));
  if (!problem) return refuse(problem.error().front().message);
  LinkageScene linkage{*std::move(problem), false, false, {}, targets(given.problem)};
  const bool slides = is_driven_by_slider(linkage);
  linkage.stations = stations(given, slides);
  linkage.layers = layer_sizes(given.problem, linkage.problem.mechanism);
  const problems::DriveSweep& drive = linkage.problem.drive;
  if (is_analysis(given)) {
    const double turns = std::abs(drive.end - drive.start) / kTurn;
    linkage.round = !slides && turns >= 1 && std::abs(turns - std::round(turns)) < 1e-12;
  } else if (const auto chosen = choose_span(linkage); !chosen) {
    return refuse("mechanism: " + chosen.error());
  }
  return linkage;
}

tl::expected<ordered_json, std::string> analysis_of_design(const ResultDesign& given) {
  const auto linkage = result_linkage(given);
  if (!linkage) return tl::unexpected(linkage.error());
  if (is_analysis(given)) return given.problem;
  ordered_json tables = head_of(given, "analysis");
  tables["mechanism"] = without_rounding(given.table["mechanism"]);
  if (linkage->layers) tables["layers"] = sizes_table(*linkage->layers);
  if (linkage->round) return tables;
  const auto& drive = linkage->problem.drive;
  const auto ranges = follow(linkage->problem.mechanism.mechanism, drive.start, drive.end);
  if (ranges.runs.empty()) return tables;
  const problems::DriveSpan span = inside_longest(ranges);
  const bool slides = is_driven_by_slider(*linkage);
  const double unit = slides ? 1 : 360 / kTurn;
  tables["drive"] = {{slides ? "start" : "start_deg", unit * span.from},
                     {slides ? "end" : "end_deg", unit * span.to}};
  return tables;
}

problems::DriveSpan inside_longest(const AssemblyRanges& ranges) {
  constexpr double kInside = 1e-9;  // of the range
  const auto& longest = *std::ranges::max_element(
      ranges.runs, {}, [](const AssemblyRange& range) { return range.to - range.from; });
  return {std::lerp(longest.from, longest.to, kInside),
          std::lerp(longest.from, longest.to, 1 - kInside)};
}

std::string design_stem(const std::string& stem, int design) {
  return fmt::format("{}.design{}", stem, design);
}

}  // namespace cognate::app
