#include "problems/linkage/read_constraints.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/keys.hpp"
#include "problems/linkage/linkage_keys.hpp"
#include "problems/linkage/read_linkage.hpp"

namespace cognate::problems::reading {
namespace {

// The four lengths, for a message: "crank 2, coupler 1 to 3, …".
std::string in_words(const LengthLimits& limits) {
  std::string text;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto& [min, max] = limits[i];
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", kLinkKeys.at(i).key, min);
    if (max != min) text += fmt::format(" to {}", max);
  }
  return text;
}

void check_class(TableReader& table, const LengthLimits& limits, const Constraints& constraints) {
  if (!constraints.required_class || class_is_possible(limits, *constraints.required_class)) return;
  table.fault("class", fmt::format("is \"{}\", which the lengths exclude ({}); widen [bounds] or "
                                   "give fewer lengths",
                                   to_string(*constraints.required_class), in_words(limits)));
}

void check_transmission_angle(TableReader& table, Constraints& constraints) {
  const auto range = constraints.transmission_angle;
  if (!range || range->min != range->max) return;
  constraints.transmission_angle.reset();
  table.fault("transmission_angle_deg",
              fmt::format("allows only {} degrees, and no linkage keeps one transmission "
                          "angle; expected [min, max] with min < max",
                          degrees(range->min)));
}

void check_link_ratio(TableReader& table, const LengthLimits& limits,
                      const Constraints& constraints) {
  if (!constraints.link_ratio_max) return;
  const double longest = std::ranges::max(limits, {}, &Range::min).min;
  const double shortest = std::ranges::min(limits, {}, &Range::max).max;
  if (longest > shortest * *constraints.link_ratio_max) {
    table.fault("link_ratio_max",
                fmt::format("is {}, which the lengths exclude ({}); at least {} "
                            "is possible",
                            *constraints.link_ratio_max, in_words(limits), longest / shortest));
  }
}

// The limits of a crank-rocker's stroke are what a time ratio is about.
void check_time_ratio(TableReader& table, const Constraints& constraints) {
  if (constraints.time_ratio && constraints.required_class != RequiredClass::crank_rocker) {
    table.fault("time_ratio",
                "is that of a crank-rocker; expected class = \"crank-rocker\" as well");
  }
}

// The constraints that are more than bounds of variables, as a key; empty where there are none.
std::string_view beyond_bounds(const Constraints& constraints) {
  if (constraints.required_class) return "constraints.class";
  if (constraints.transmission_angle) return "constraints.transmission_angle_deg";
  if (constraints.link_ratio_max) return "constraints.link_ratio_max";
  if (constraints.time_ratio) return "constraints.time_ratio";
  if (constraints.pivot_region) return "constraints.pivot_region";
  if (limits_turn(constraints)) return "limits over the full turn";
  return {};
}

void check_solver(TableReader& table, synthesis::Solver solver, const Constraints& constraints,
                  bool minimax) {
  constexpr std::string_view kOthers = "every other solver can";
  if (minimax && !can_solve(solver, {.objective = synthesis::Objective::max_abs})) {
    table.fault("solver", fmt::format("is \"{}\", which minimises sums of squares, but the "
                                      "objective is \"minimax\"; {}",
                                      to_string(solver), kOthers));
  }
  const std::string_view constraint = beyond_bounds(constraints);
  if (!constraint.empty() && !can_solve(solver, {.constraints = true})) {
    table.fault("solver", fmt::format("is \"{}\", which honours bounds but not {}; {}",
                                      to_string(solver), constraint, kOthers));
  }
}

}  // namespace

void read_link_constraints(TableReader& table, const LengthLimits& limits,
                           Constraints& constraints) {
  read_keys(table, kMobilityKeys, constraints);
  check_class(table, limits, constraints);
  check_transmission_angle(table, constraints);
  check_link_ratio(table, limits, constraints);
  check_time_ratio(table, constraints);
  read_keys(table, kDefectKeys, constraints);
}

void read_pivot_region(TableReader& table, const Given& given, Constraints& constraints) {
  constexpr std::string_view kKey = "pivot_region";
  constraints.pivot_region = table.box(kKey);
  if (!constraints.pivot_region) return;
  for (const auto& pivot : {given.pivot_a, given.pivot_d}) {
    if (pivot && !contains(*constraints.pivot_region, *pivot)) {
      table.fault(kKey,
                  fmt::format("does not contain the given pivot [{}, {}]; expected a region that "
                              "contains every given pivot",
                              pivot->x, pivot->y));
    }
  }
}

void read_design_count(TableReader& table, int most_designs, Solve& solve) {
  solve.designs = table.integer("designs", 1, most_designs).value_or(solve.designs);
}

Solve read_solve(TableReader& table, const Constraints& constraints, bool minimax,
                 int most_designs) {
  Solve solve;
  read_keys(table, kSearchKeys, solve);
  read_design_count(table, most_designs, solve);
  read_keys(table, kStoppingKeys, solve);
  check_solver(table, solve.solver, constraints, minimax);
  return solve;
}

void check_unknown_count(TableReader& table, synthesis::Solver solver, int count) {
  if (eliminates_locals(solver)) return;
  constexpr std::int64_t kMostInFullMatrices = 2000;
  const auto most = std::min(kMostInFullMatrices, synthesis::most_unknowns(solver));
  if (count <= most) return;
  table.fault("solver",
              fmt::format("is \"{}\", which takes {} unknowns at most, and there are {} (with a "
                          "crank angle for each point or pose); \"auto\" takes any number",
                          to_string(solver), most, count));
}

void read_loss(TableReader& table, std::string_view other, Solve& solve) {
  constexpr std::string_view kLoss = "loss", kScale = "loss_scale";
  read_keys(table, kLossKeys, solve);
  for (const std::string_view key : {kLoss, kScale}) {
    if (other.empty() || !table.has(key)) continue;
    table.fault(key, fmt::format("is given with {}, but a loss belongs to least squares; remove "
                                 "it",
                                 other));
  }
  if (!other.empty()) return;
  const bool robust = solve.loss != synthesis::Loss::none;
  if (robust && !table.has(kScale)) {
    table.fault(kLoss,
                fmt::format("is \"{}\" without a scale; expected loss_scale, the error from "
                            "which it differs from least squares: a length for paths, radians "
                            "for functions",
                            to_string(solve.loss)));
  }
  if (!robust && table.has(kScale) && !table.has(kLoss)) {
    table.fault(kScale, "is given without a loss; add loss = \"huber\" or another, or remove it");
  }
}

void read_certificate(TableReader& table, std::string_view refusal, Solve& solve) {
  read_keys(table, kCertificateKeys, solve);
  if (table.has("certify_gap") && !solve.certify) {
    table.fault("certify_gap", "is given without certify; add certify = true or remove it");
  }
  if (solve.certify && !refusal.empty()) table.fault("certify", std::string(refusal));
  if (solve.certify && solve.loss != synthesis::Loss::none) {
    table.fault("certify",
                "is true with a loss, but only sums of squares can be certified; leave "
                "one of them out");
  }
}

void read_robust(TableReader& table, std::string_view refusal, Solve& solve) {
  const std::string_view key = kRobustKeys[0].name;
  if (table.has_text(key) && table.text(key) == kRobustWorst) {
    solve.robust = 1;
  } else {
    solve.robust = table.number(key, kRobustShare);
  }
  if (table.has("robust") && !refusal.empty()) table.fault("robust", std::string(refusal));
}

}  // namespace cognate::problems::reading
