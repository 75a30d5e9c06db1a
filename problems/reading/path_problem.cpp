#include "problems/reading/path_problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/reading/constraint_tables.hpp"
#include "problems/reading/linkage_tables.hpp"
#include "problems/reading/path_exact.hpp"
#include "problems/reading/turn_tables.hpp"

namespace cognate::problems::reading {
namespace {

void read_points(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "points";
  if (!target.has(kKey)) {
    target.fault(kKey, "is missing; an array of 3 to 10000 points [x, y] is wanted");
    return;
  }
  const auto points = target.each_two(kKey, kNumber, "[x, y]", {.min = 3, .of = "points"});
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!points[i] || points[i - 1] != points[i]) continue;
    target.faults().add(target.where(kKey, i),
                        fmt::format("point {} of target.points repeats point {}; neighbouring "
                                    "points must differ (only the last may repeat the first)",
                                    i + 1, i));
  }
  for (const Two& point : all_or_none(points).value_or(std::vector<Two>{})) {
    problem.points.push_back({point[0], point[1]});
  }
}

// Equal neighbours would ask one position of the crank for two points.
void check_crank_angles(TableReader& target, const std::vector<std::optional<double>>& degrees) {
  for (std::size_t i = 1; i < degrees.size(); ++i) {
    if (!degrees[i] || !degrees[i - 1]) continue;
    if (std::abs(std::remainder(*degrees[i] - *degrees[i - 1], 360.0)) > 1e-9) continue;
    target.faults().add(target.where("crank_deg", i),
                        fmt::format("entry {} of target.crank_deg, {}, is the same position of the "
                                    "crank as entry {}; neighbouring angles must differ by more "
                                    "than whole turns",
                                    i + 1, *degrees[i], i));
  }
}

void read_crank_angles(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "crank_deg";
  if (!target.has(kKey)) {
    target.fault("timing",
                 "is \"prescribed\" without crank_deg; give one angle for each point in "
                 "target.crank_deg, or timing = \"free\"");
    return;
  }
  const auto degrees = target.each_number(kKey, kAngle, {.min = 1, .of = "angles"});
  if (degrees.empty()) return;
  if (!problem.points.empty() && degrees.size() != problem.points.size()) {
    target.fault(kKey, fmt::format("has {} angles for {} points; one for each point is wanted",
                                   degrees.size(), problem.points.size()));
  }
  check_crank_angles(target, degrees);
  for (const double angle : all_or_none(degrees).value_or(std::vector<double>{})) {
    problem.crank_angles.push_back(radians(angle));
  }
}

void read_timing(TableReader& target, PathProblem& problem) {
  problem.timing = target.choice<Timing>("timing").value_or(Timing::free);
  problem.crank_reference =
      target.choice<CrankReference>("crank_reference").value_or(problem.crank_reference);
  problem.crank_sense = target.choice<CrankSense>("crank_sense").value_or(problem.crank_sense);
  problem.order = target.choice<PointOrder>("order").value_or(problem.order);
  target.know({"crank_deg"});
  if (problem.timing == Timing::prescribed) {
    read_crank_angles(target, problem);
    if (problem.order == PointOrder::any) {
      target.fault("order",
                   "is \"any\" with prescribed timing, whose crank angles are the order; leave it "
                   "out, or use timing = \"free\"");
    }
    return;
  }
  for (const std::string_view key : {"crank_deg", "crank_reference"}) {
    if (!target.has(key)) continue;
    target.fault(key, "is given with free timing; add timing = \"prescribed\" or leave it out");
  }
}

void read_weights(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "weights";
  problem.weights.assign(problem.points.size(), 1.0);
  const auto weights = target.numbers(kKey, kWeight, {.min = 1, .of = "weights"});
  if (!weights) return;
  if (!problem.points.empty() && weights->size() != problem.points.size()) {
    target.fault(kKey, fmt::format("has {} weights for {} points; one for each point is wanted",
                                   weights->size(), problem.points.size()));
  }
  if (std::ranges::all_of(*weights, [](double weight) { return weight == 0; })) {
    target.fault(kKey, "are all 0; at least one positive weight is wanted");
  }
  problem.weights = *weights;
}

// The order in which poses and points alternate is not known.
void read_positions(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kPoses = "poses";
  if (problem.method == PathMethod::exact) {
    read_exact_positions(target, problem);
    const bool mixed =
        !problem.pose_angles.empty() && problem.points.size() > problem.pose_angles.size();
    if (mixed) problem.order = PointOrder::any;
    return;
  }
  read_points(target, problem);
  if (target.has(kPoses)) {
    target.fault(kPoses, "are given without method = \"exact\"; add it, or give points alone");
  }
}

/// Dimensions that the file leaves open, and with free timing a crank angle for each point.
int unknown_count(const PathProblem& problem) {
  const Given& given = problem.given;
  const bool both_pivots = given.pivot_a && given.pivot_d;
  const int lengths = !given.crank + !given.coupler + !given.rocker + !(given.frame || both_pivots);
  const int places = (given.coupler_point ? 0 : 2) + (given.pivot_a || given.pivot_d ? 0 : 2) +
                     !(given.frame_angle || both_pivots);
  if (problem.timing == Timing::free) {
    return lengths + places + static_cast<int>(problem.points.size());
  }
  return lengths + places + (problem.crank_reference == CrankReference::first);
}

// The unknown crank angles of free timing are too many to be divided.
std::string_view certificate_refusal(const PathProblem& problem) {
  if (problem.method == PathMethod::exact) {
    return "is true with method = \"exact\", whose designs meet the points; leave it out";
  }
  if (limits_turn(problem.constraints)) return kTurnNotCertified;
  if (problem.timing == Timing::free) {
    return "is true with free timing; only paths with timing = \"prescribed\" can be certified";
  }
  return {};
}

}  // namespace

PathProblem read_path_problem(TableReader& document) {
  PathProblem problem;
  TableReader target = document.table("target");
  TableReader mechanism = document.table("mechanism");
  TableReader bounds = document.table("bounds");
  TableReader constraints = document.table("constraints");
  TableReader solve = document.table("solve");

  problem.method = holder("method", target, solve)
                       .choice<PathMethod>("method")
                       .value_or(PathMethod::least_squares);
  const bool exact = problem.method == PathMethod::exact;
  read_positions(target, problem);
  read_timing(target, problem);
  read_weights(target, problem);
  read_mechanism_type(mechanism);
  read_given_links(mechanism, problem.given);
  read_given_places(mechanism, problem.given);
  read_length_bounds(bounds, problem.bounds);
  read_place_bounds(bounds, problem.bounds);
  check_given(mechanism, problem.given, problem.bounds);
  read_link_constraints(constraints, length_limits(problem.given, problem.bounds),
                        problem.constraints);
  read_pivot_region(constraints, problem.given, problem.constraints);
  read_turn_limits(document, constraints,
                   {.refusal = exact ? "is given with method = \"exact\", whose designs meet the "
                                       "points whatever they do between; leave it out"
                                     : ""},
                   problem.constraints);
  problem.solve = read_solve(solve, problem.constraints, false,
                             exact ? kMostExactDesigns : kMostSearchedDesigns);
  read_loss(solve, exact ? "method = \"exact\"" : "", problem.solve);
  if (!exact) check_unknown_count(solve, problem.solve.solver, unknown_count(problem));
  read_certificate(solve, certificate_refusal(problem), problem.solve);
  if (exact) {
    if (!solve.has("designs")) problem.solve.designs = default_exact_designs(problem);
    check_exact_path(target, mechanism, solve, problem);
  }

  for (TableReader* table : {&target, &mechanism, &bounds, &constraints, &solve}) table->finish();
  return problem;
}

}  // namespace cognate::problems::reading
