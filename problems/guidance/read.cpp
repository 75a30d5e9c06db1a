#include "problems/tolerance/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/guidance/problem.hpp"
#include "problems/guidance/read_made.hpp"
#include "problems/guidance/read_poses.hpp"
#include "problems/layers/link_names.hpp"
#include "problems/linkage/cycle/read_cycle.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/search/read_objectives.hpp"
#include "problems/toml/nearest.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

using synthesis::DyadKind;

constexpr std::size_t kMostExact = 5;
constexpr std::size_t kLeast = 2;
constexpr std::size_t kLeastNearby = 3;  // two poses leave circles undetermined

void read_target(TableReader& target, MotionProblem& problem) {
  GivenPoses given = read_poses(target, kLeast);
  problem.poses = std::move(given.poses);
  problem.segments = std::move(given.segments);
}

void read_method(TableReader& target, MotionProblem& problem) {
  constexpr std::string_view kMethod = "method", kWeight = "angle_weight";
  const std::size_t count = problem.poses.size();
  const auto asked = target.choice<MotionMethod>(kMethod);
  problem.method =
      asked.value_or(count > kMostExact ? MotionMethod::least_squares : MotionMethod::exact);
  const auto weight = target.number(kWeight, kLinkLength);
  if (count == 0) return;
  problem.angle_weight = weight.value_or(natural_angle_weight(problem.poses));
  if (problem.method == MotionMethod::exact) {
    if (count > kMostExact) {
      target.fault(kMethod,
                   fmt::format("is \"exact\" with {} poses; at most five can be met; expected "
                               "\"least-squares\", or fewer poses",
                               count));
    }
    if (weight) {
      target.fault(kWeight,
                   "is given, but the poses are met exactly; it goes with method = "
                   "\"least-squares\"");
    }
  } else if (count < kLeastNearby) {
    target.fault(kMethod,
                 fmt::format("is \"least-squares\" with {} poses; expected at least three", count));
  }
}

std::vector<Vec2d> read_pivots(TableReader& mechanism, std::string_view key,
                               std::string_view form) {
  std::vector<Vec2d> pivots;
  const auto read = mechanism.twos(key, kQuantity, form, {1, 2, "pivots"});
  for (const Two& pivot : read.value_or(std::vector<Two>{})) {
    pivots.push_back({pivot[0], pivot[1]});
  }
  if (pivots.size() == 2 && pivots[0] == pivots[1]) {
    mechanism.fault(key, "gives one pivot twice; expected two different pivots");
  }
  return pivots;
}

void read_line(TableReader& mechanism, MotionProblem& problem) {
  constexpr std::string_view kKey = "fixed_pivot_line";
  const auto line = mechanism.numbers(kKey, kQuantity, {3, 3, "numbers [a, b, c]"});
  if (!line) return;
  problem.fixed_pivot_line = {(*line)[0], (*line)[1], (*line)[2]};
  if ((*line)[0] == 0 && (*line)[1] == 0) {
    mechanism.fault(kKey, "has a = b = 0; the line is a x + b y = c with a or b not 0");
  }
}

void read_dyads(TableReader& mechanism, MotionProblem& problem) {
  constexpr std::string_view kKey = "dyads";
  std::vector<std::string_view> allowed;
  for (const auto& named : names<DyadKind>()) {
    allowed.push_back(named.name);
    problem.dyads.push_back(named.value);
  }
  const auto words = mechanism.texts(kKey, {1, 3, "kinds of dyads"});
  if (!words) return;
  problem.dyads.clear();
  for (std::size_t i = 0; i < words->size(); ++i) {
    const auto kind = from_string<DyadKind>((*words)[i]);
    if (!kind) {
      mechanism.faults().add(mechanism.where(kKey, i),
                             fmt::format("mechanism.dyads has {}; allowed are {}",
                                         in_quotes((*words)[i]), quoted_list(allowed)));
    } else if (std::ranges::count(problem.dyads, *kind) == 0) {
      problem.dyads.push_back(*kind);
    }
  }
  std::ranges::sort(problem.dyads);
}

// What the number of poses leaves free to be given.
void check_freedom(TableReader& mechanism, const MotionProblem& problem) {
  const std::size_t count = problem.poses.size();
  if (count == 0) return;
  const auto refuse = [&](std::string_view key, std::string_view why) {
    if (mechanism.has(key)) mechanism.fault(key, why);
  };
  if (problem.method == MotionMethod::least_squares) {
    refuse("fixed_pivot_line", "goes with two poses only; remove it, or bound the pivots");
    if (std::ranges::count(problem.dyads, DyadKind::rr) == 0) {
      mechanism.fault("dyads",
                      "leaves \"RR\" out; by least squares one of the two dyads is a link");
    }
    return;
  }
  if (count > 3) {
    const auto why = fmt::format(
        "is given with {} poses, which determine the pivots; remove it, or give two or three poses",
        count);
    for (const std::string_view key : {"fixed_pivots", "moving_pivots"}) refuse(key, why);
  } else if (problem.fixed_pivots.size() + problem.moving_pivots.size() > 2) {
    mechanism.fault(
        "moving_pivots",
        "and mechanism.fixed_pivots give more than two pivots; expected each pivot makes one of "
        "the two dyads, so two in all");
  }
  if (count > 2) {
    const auto why = fmt::format(
        "is given with {} poses; only two poses leave it free, so remove "
        "it",
        count);
    for (const std::string_view key : {"fixed_pivot_line", "crank", "rocker"}) refuse(key, why);
  } else if (problem.fixed_pivot_line && (problem.crank || problem.rocker)) {
    mechanism.fault("fixed_pivot_line",
                    "is given beside a link's length; expected the line or the lengths");
  } else if (problem.fixed_pivot_line && problem.moving_pivots.empty()) {
    mechanism.fault("fixed_pivot_line",
                    "is given without mechanism.moving_pivots, whose fixed pivots are to lie on "
                    "it; give one or two moving pivots");
  }
  const std::size_t pivots = problem.fixed_pivots.size() + problem.moving_pivots.size();
  for (const auto& [key, least] : {std::pair{"crank", 1U}, std::pair{"rocker", 2U}}) {
    if (count != 2 || !mechanism.has(key) || pivots >= least) continue;
    mechanism.fault(key,
                    fmt::format("is given without {}; lengths go with fixed or moving pivots, in "
                                "their order",
                                least == 1 ? "a pivot" : "a second pivot"));
  }
}

void use_points_of_segments(MotionProblem& problem) {
  const bool few = problem.method == MotionMethod::exact && problem.poses.size() <= 3;
  if (!few || problem.segments.empty()) return;
  if (!problem.moving_pivots.empty() || !problem.fixed_pivots.empty()) return;
  const auto& [first, second] = problem.segments.front();
  problem.moving_pivots = {{0, 0}, {norm(second - first), 0}};
}

// Where moving pivots may lie. Poses to be met exactly determine them or leave them to the search.
void read_moving_bounds(TableReader& bounds, MotionProblem& problem) {
  constexpr std::string_view kKeys[] = {"moving_pivot_a", "moving_pivot_d"};
  for (std::size_t i = 0; i < std::size(kKeys); ++i) {
    problem.moving_bounds.at(i) = bounds.box(kKeys[i]);
    if (!problem.moving_bounds.at(i)) continue;
    if (problem.method == MotionMethod::exact && !problem.poses.empty()) {
      bounds.fault(kKeys[i],
                   "is given, but the poses are met exactly; it goes with method = "
                   "\"least-squares\"");
    } else if (i < problem.moving_pivots.size() &&
               !contains(*problem.moving_bounds.at(i), problem.moving_pivots[i])) {
      bounds.fault(kKeys[i],
                   "does not contain the moving pivot that [mechanism] gives; give one of the two");
    }
  }
}

// What is given by least squares satisfies its bounds.
void check_given_bounds(TableReader& bounds, const MotionProblem& problem) {
  if (problem.method == MotionMethod::exact) return;
  const auto check_length = [&](std::string_view key, const std::optional<double>& length,
                                const std::optional<Range>& range) {
    if (!length || !range || (*length >= range->min && *length <= range->max)) return;
    bounds.fault(
        key, fmt::format("does not allow the {} of {} that [mechanism] gives; give one of the two",
                         key, *length));
  };
  check_length("crank", problem.crank, problem.bounds.crank);
  check_length("rocker", problem.rocker, problem.bounds.rocker);
  const std::optional<Box>* boxes[] = {&problem.bounds.pivot_a, &problem.bounds.pivot_d};
  constexpr std::string_view kKeys[] = {"pivot_a", "pivot_d"};
  for (std::size_t i = 0; i < problem.fixed_pivots.size() && i < 2; ++i) {
    if (!*boxes[i] || contains(**boxes[i], problem.fixed_pivots[i])) continue;
    bounds.fault(kKeys[i],
                 "does not contain the fixed pivot that [mechanism] gives; give one of the two");
  }
}

// The pivots are the variables, so that limits of their distances are more than bounds.
void check_solver(TableReader& solve, const MotionProblem& problem) {
  if (problem.method == MotionMethod::exact) return;
  constexpr int kDyads = 10;
  check_unknown_count(solve, problem.solve.solver, kDyads + static_cast<int>(problem.poses.size()));
  const bool bounded = problem.bounds.coupler || problem.bounds.frame;
  const synthesis::Solver solver = problem.solve.solver;
  if (!bounded || can_solve(solver, {.constraints = true})) return;
  solve.fault("solver", fmt::format("is \"{}\", which does not honour bounds of coupler and frame, "
                                    "distances of pivots; every other solver can",
                                    to_string(solver)));
}

// What holds over the full turn is known of four-bars alone.
void keep_to_links(TableReader& mechanism, MotionProblem& problem) {
  if (!limits_turn(problem.constraints)) return;
  if (mechanism.has("dyads") && problem.dyads != std::vector{DyadKind::rr}) {
    mechanism.fault("dyads",
                    "are not \"RR\" alone, but limits over the full turn of the crank are "
                    "for four-bars; expected dyads = [\"RR\"]");
  }
  problem.dyads = {DyadKind::rr};
}

/// The names of the links of every mechanism that guides a body.
LinkNames guiding_links(bool four_bars) {
  if (four_bars) return links_of<FourBar>();
  LinkNames names = links_of<FourBar, SliderCrank, OscillatingBlock, EllipticTrammel>();
  names.push_back({"slider", "block", "bar"});
  return names;
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

MotionProblem KindTraits<MotionProblem>::read(reading::TableReader& document,
                                              const std::filesystem::path& /*folder*/) {
  using namespace reading;
  MotionProblem problem;
  LinkageTables tables(document);
  auto& [target, mechanism, bounds, constraints, solve] = tables;

  read_target(target, problem);
  read_method(target, problem);
  problem.fixed_pivots = read_pivots(mechanism, "fixed_pivots", "[x, y]");
  problem.moving_pivots = read_pivots(mechanism, "moving_pivots", "[u, v]");
  use_points_of_segments(problem);
  read_line(mechanism, problem);
  problem.crank = mechanism.number("crank", kLinkLength);
  problem.rocker = mechanism.number("rocker", kLinkLength);
  read_dyads(mechanism, problem);
  check_freedom(mechanism, problem);
  read_length_bounds(bounds, problem.bounds);
  problem.bounds.pivot_a = bounds.box("pivot_a");
  problem.bounds.pivot_d = bounds.box("pivot_d");
  read_moving_bounds(bounds, problem);
  check_given_bounds(bounds, problem);
  Given given;
  given.crank = problem.crank;
  given.rocker = problem.rocker;
  read_link_constraints(constraints, length_limits(given, problem.bounds), problem.constraints);
  read_pivot_region(constraints, given, problem.constraints);
  for (const Vec2d& pivot : problem.fixed_pivots) {
    if (!problem.constraints.pivot_region || contains(*problem.constraints.pivot_region, pivot)) {
      continue;
    }
    constraints.fault(
        "pivot_region",
        fmt::format("does not contain the given pivot [{}, {}]; expected a region that "
                    "contains every given pivot",
                    pivot.x, pivot.y));
  }
  const bool exact = problem.method == MotionMethod::exact;
  read_cycle_limits(
      document, constraints, solve,
      {.refusal = exact
                      ? "is given with exact synthesis, whose designs meet the poses regardless of "
                        "what they do between; expected method = \"least-squares\""
                      : ""},
      problem.constraints);
  keep_to_links(mechanism, problem);
  problem.designs_given = solve.has("designs");
  problem.solve = read_solve(solve, problem.constraints, false);
  check_solver(solve, problem);
  const bool four_bars = problem.dyads == std::vector{DyadKind::rr};
  read_objectives(
      constraints, solve,
      {.error = ErrorMeasure::rms_length,
       .exact = exact ? "is given, but the poses are met exactly; it goes with method "
                        "= \"least-squares\""
                      : "",
       .refusal = four_bars ? ""
                            : "has a measure of four-bars alone; expected mechanism.dyads = "
                              "[\"RR\"] as well"},
      problem.constraints, problem.solve);

  read_motion_raster(document, mechanism, problem);
  const bool has_links = four_bars || solve.has("robust");
  problem.tolerances = read_tolerances(document, has_links ? four_bar_scope() : ToleranceScope{});
  read_motion_robust(mechanism, solve, problem);
  problem.layers = read_design_layers(document, constraints, guiding_links(four_bars),
                                      layers_max_refusal(problem.solve));
  tables.finish();
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
