#include "problems/tolerance/read.hpp"

#include <fmt/core.h>

#include <optional>
#include <string_view>
#include <vector>

#include "problems/layers/link_names.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/quick_return/read_raster.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

constexpr NumberRule kTimeRatio{[](double x) { return x >= 1 && x <= 1000; },
                                "a ratio from 1 to 1000"};
constexpr NumberRule kSwing{[](double x) { return x >= 1e-3 && x <= 179.999; },
                            "an angle in degrees from 0.001 to 179.999"};
constexpr NumberRule kLimitAngle{[](double x) { return x > 0 && x < 180; },
                                 "an angle in degrees between 0 and 180, of the rocker from the "
                                 "direction from A to D"};
constexpr NumberRule kPressureAngle{[](double x) { return x >= 1e-3 && x <= 89.999; },
                                    "an angle in degrees from 0.001 to 89.999"};

// All solutions, unless the file limits their number.
constexpr int kMostDesigns = 100;

std::optional<double> required(TableReader& table, std::string_view key, const NumberRule& rule) {
  if (!table.has(key)) table.fault(key, fmt::format("is missing; expected {}", rule.allowed));
  return table.number(key, rule);
}

std::optional<double> required_angle(TableReader& table, std::string_view key,
                                     const NumberRule& rule) {
  const auto degrees = required(table, key, rule);
  return degrees ? std::optional(radians(*degrees)) : std::nullopt;
}

// Of keys that each settle the same dimension: all but the first that is given are too many.
void at_most_one(TableReader& table, const std::vector<std::string_view>& keys) {
  std::string_view first;
  for (const std::string_view key : keys) {
    if (!table.has(key)) continue;
    if (first.empty()) {
      first = key;
      continue;
    }
    table.fault(key, fmt::format("is given beside {}, which settles the one dimension that is "
                                 "free; give one of them",
                                 first));
  }
}

void read_pivot_line(TableReader& mechanism, QuickReturnProblem& problem) {
  constexpr std::string_view kKey = "crank_pivot_line";
  const auto line = mechanism.numbers(kKey, kNumber, {3, 3, "numbers, [a, b, c] of a x + b y = c"});
  if (!line) return;
  if ((*line)[0] == 0 && (*line)[1] == 0) {
    mechanism.fault(kKey, "has a = b = 0; expected a x + b y = c with a or b not 0");
    return;
  }
  problem.crank_pivot_line = synthesis::PivotLine{(*line)[0], (*line)[1], (*line)[2]};
}

// Of the two keys the first that is given counts.
void read_limit_angle(TableReader& mechanism, QuickReturnProblem& problem) {
  for (const auto limit : {synthesis::RockerLimit::outer, synthesis::RockerLimit::inner}) {
    const auto angle = mechanism.number(limit_angle_key(limit), kLimitAngle);
    if (angle && !problem.limit_angle) problem.limit_angle = {limit, radians(*angle)};
  }
}

// The swing, which the frame and an angle at a limit may replace.
void read_swing(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  TableReader& mechanism = tables.mechanism;
  TableReader& table = holder("swing_deg", mechanism, tables.target);
  const bool has_angle = mechanism.has("outer_limit_deg") || mechanism.has("inner_limit_deg");
  if (table.has("swing_deg") || on_raster || !has_angle) {
    problem.swing = required_angle(table, "swing_deg", kSwing);
  } else if (!mechanism.has("frame")) {
    mechanism.fault("swing_deg", fmt::format("is missing; expected {}, or mechanism.frame, from "
                                             "which it follows",
                                             kSwing.allowed));
  }
}

void read_four_bar(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  Given& given = problem.given;
  given.rocker =
      on_raster ? mechanism.number("rocker", kLength) : required(mechanism, "rocker", kLength);
  read_swing(tables, on_raster, problem);
  given.crank = mechanism.number("crank", kLength);
  given.coupler = mechanism.number("coupler", kLength);
  given.frame = mechanism.number("frame", kLength);
  read_pivot_line(mechanism, problem);
  read_limit_angle(mechanism, problem);
  std::vector<std::string_view> keys{"crank", "coupler", "crank_pivot_line", "outer_limit_deg",
                                     "inner_limit_deg"};
  if (problem.swing || !problem.limit_angle) keys.insert(keys.begin() + 2, "frame");
  if (!on_raster) at_most_one(mechanism, keys);
  read_length_bounds(bounds, problem.bounds);
  check_given(mechanism, given, problem.bounds);
  read_link_constraints(constraints, length_limits(given, problem.bounds), problem.constraints);
}

void read_pressure_angle(TableReader& constraints, QuickReturnProblem& problem) {
  const auto degrees = constraints.number("pressure_angle_deg_max", kPressureAngle);
  if (degrees) problem.pressure_angle_max = radians(*degrees);
}

void read_slider_crank(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  TableReader& mechanism = tables.mechanism;
  problem.stroke = required(holder("stroke", mechanism, tables.target), "stroke", kLength);
  problem.offset = mechanism.number("offset", kNumber);
  problem.given.crank = mechanism.number("crank", kLength);
  problem.given.coupler = mechanism.number("coupler", kLength);
  read_pressure_angle(tables.constraints, problem);
  if (on_raster) return read_return_bounds(tables.bounds, problem);
  // Without quick return the coupler is free beside offset = 0.
  const bool centred = problem.time_ratio == 1 && problem.offset == 0.0;
  at_most_one(mechanism, centred ? std::vector<std::string_view>{"crank", "coupler"}
                                 : std::vector<std::string_view>{"offset", "crank", "coupler"});
  if (centred && mechanism.has("coupler")) problem.offset.reset();
}

// The frame of a guide, or its crank; with a raster both or none.
void read_guide(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  TableReader& mechanism = tables.mechanism;
  if (!on_raster && !mechanism.has("frame") && !mechanism.has("crank")) {
    mechanism.fault("frame",
                    fmt::format("is missing; expected {}, or that of the crank", kLength.allowed));
  }
  problem.given.frame = mechanism.number("frame", kLength);
  problem.given.crank = mechanism.number("crank", kLength);
  if (on_raster) return read_return_bounds(tables.bounds, problem);
  at_most_one(mechanism, {"frame", "crank"});
}

void read_guide_bar(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  read_guide(tables, on_raster, problem);
  problem.offset = tables.mechanism.number("offset", kNumber);
}

void read_shaper(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  TableReader& mechanism = tables.mechanism;
  problem.stroke = required(holder("stroke", mechanism, tables.target), "stroke", kLength);
  read_guide(tables, on_raster, problem);
  problem.rod = mechanism.number("rod", kLength);
  problem.ram_height = mechanism.number("ram_height", kLength);
  read_pressure_angle(tables.constraints, problem);
  const bool has_rod = mechanism.has("rod") || tables.constraints.has("pressure_angle_deg_max");
  if (has_rod || on_raster) return;
  mechanism.fault(
      "rod", fmt::format("is missing; expected {}, or constraints.pressure_angle_deg_max, from "
                         "which it follows",
                         kLength.allowed));
}

void read_mechanism(LinkageTables& tables, bool on_raster, QuickReturnProblem& problem) {
  switch (problem.type) {
    case QuickReturnType::four_bar:
      return read_four_bar(tables, on_raster, problem);
    case QuickReturnType::slider_crank:
      return read_slider_crank(tables, on_raster, problem);
    case QuickReturnType::guide_bar:
      return read_guide_bar(tables, on_raster, problem);
    case QuickReturnType::shaper:
      return read_shaper(tables, on_raster, problem);
  }
}

// Without a type nothing can be said of the other keys.
void know_all(LinkageTables& tables) {
  tables.target.know({"swing_deg", "stroke"});
  tables.mechanism.know({"crank", "coupler", "rocker", "frame", "swing_deg", "stroke", "offset",
                         "rod", "ram_height", "crank_pivot_line", "outer_limit_deg",
                         "inner_limit_deg"});
  tables.bounds.know(
      {"crank", "coupler", "rocker", "frame", "length", "offset", "bar", "rod", "ram_height"});
  tables.constraints.know({"class", "transmission_angle_deg", "link_ratio_max", "no_branch_defect",
                           "no_order_defect", "no_circuit_defect", "pressure_angle_deg_max"});
}

ToleranceScope quick_return_scope(QuickReturnType type) {
  ToleranceScope scope;
  switch (type) {
    case QuickReturnType::four_bar:
      scope = four_bar_scope();
      std::erase(scope.dimensions, "coupler_point");
      scope.unit = "deg";
      break;
    case QuickReturnType::slider_crank:
      return slider_crank_scope();
    case QuickReturnType::guide_bar:
      scope = guide_bar_scope();
      scope.unit = "deg";
      break;
    case QuickReturnType::shaper:
      scope.dimensions = {"crank", "bar", "rod", "ram", "D"};
      break;
  }
  return scope;
}

LinkNames return_links(QuickReturnType type) {
  switch (type) {
    case QuickReturnType::four_bar:
      return links_of<FourBar>();
    case QuickReturnType::slider_crank:
      return links_of<SliderCrank>();
    case QuickReturnType::guide_bar:
      return links_of<GuideBar>();
    case QuickReturnType::shaper:
      break;
  }
  return {{"crank", "block", "bar", "rod", "ram"}};
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

QuickReturnProblem KindTraits<QuickReturnProblem>::read(reading::TableReader& document,
                                                        const std::filesystem::path& /*folder*/) {
  using namespace reading;
  QuickReturnProblem problem;
  LinkageTables tables(document);
  problem.time_ratio = required(tables.target, "time_ratio", kTimeRatio).value_or(1);
  const auto type = tables.mechanism.choice<QuickReturnType>("type");
  problem.type = type.value_or(QuickReturnType::four_bar);
  if (type || !tables.mechanism.has("type")) {
    read_mechanism(tables, has_raster(document), problem);
  } else {
    know_all(tables);
  }
  problem.solve = read_solve(tables.solve, problem.constraints, false);
  if (!tables.solve.has("designs") && !has_raster(document)) problem.solve.designs = kMostDesigns;
  problem.layers = read_design_layers(document, tables.constraints, return_links(problem.type));
  problem.tolerances = read_tolerances(document, quick_return_scope(problem.type));
  tables.finish();
  if (type || !tables.mechanism.has("type")) {
    read_return_raster(document, problem);
  } else {
    document.know({"raster"});
  }
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
