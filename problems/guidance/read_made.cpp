#include "problems/guidance/read_made.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_raster.hpp"
#include "problems/raster/read.hpp"

namespace cognate::problems::reading {
namespace {

using synthesis::DyadKind;

// What speaks against a raster.
std::string_view motion_raster_refusal(const MotionProblem& problem) {
  if (problem.method == MotionMethod::exact) {
    return "is given with poses that are met exactly, which dimensions on a raster do not do; "
           "expected target.method = \"least-squares\", which takes three poses or more";
  }
  const Constraints& constraints = problem.constraints;
  if (!constraints.no_branch_defect && !constraints.no_circuit_defect) {
    return "is given with no_branch_defect = false and no_circuit_defect = false, by which each "
           "pose may have an assembly of its own; remove one of them";
  }
  return search_raster_refusal(problem.solve);
}

// Faults a raster without a value within the bounds of a dimension.
void check_motion_raster(TableReader& document, const MotionProblem& problem) {
  const Raster& raster = *problem.raster;
  const auto check = [&](std::string_view key, const std::optional<Range>& range,
                         const std::string& name) {
    if (range) check_raster_values(document, raster, key, {}, *range, name);
  };
  const auto check_box = [&](std::string_view key, const std::optional<Box>& box,
                             const std::string& name) {
    if (!box) return;
    check(key, Range{box->min.x, box->max.x}, name);
    check(key, Range{box->min.y, box->max.y}, name);
  };
  const Bounds& bounds = problem.bounds;
  if (!problem.crank) check("crank", bounds.crank, "bounds.crank");
  if (!problem.rocker) check("rocker", bounds.rocker, "bounds.rocker");
  // Which dyad a single pivot belongs to is not known before the search.
  if (problem.fixed_pivots.empty()) {
    check_box("pivots", bounds.pivot_a, "bounds.pivot_a");
    check_box("pivots", bounds.pivot_d, "bounds.pivot_d");
  }
  if (problem.moving_pivots.empty()) {
    check_box("moving_pivots", problem.moving_bounds[0], "bounds.moving_pivot_a");
    check_box("moving_pivots", problem.moving_bounds[1], "bounds.moving_pivot_d");
  }
}

// What speaks against robust designs.
std::string_view motion_robust_refusal(const MotionProblem& problem) {
  if (problem.method == MotionMethod::exact) {
    return "is given with poses that are met exactly; expected target.method = \"least-squares\", "
           "which takes three poses or more";
  }
  if (const auto why = robust_tolerance_refusal(problem.tolerances); !why.empty()) return why;
  if (problem.raster) return "is given with a raster; remove one of them";
  if (problem.tolerances->pivots) {
    return "is given with tolerance.pivots, which it does not take into account: give that of "
           "frame instead, or remove it";
  }
  return robust_search_refusal(problem.solve);
}

}  // namespace

void read_motion_raster(TableReader& document, TableReader& mechanism, MotionProblem& problem) {
  constexpr std::string_view kKeys[] = {"length", "pivots", "moving_pivots", "crank", "rocker"};
  problem.raster = read_raster(document, kKeys, motion_raster_refusal(problem));
  if (!problem.raster) return;
  if (mechanism.has("dyads") && problem.dyads != std::vector{DyadKind::rr}) {
    mechanism.fault("dyads",
                    "are not \"RR\" alone, but a raster is searched for four-bars; expected dyads "
                    "= [\"RR\"]");
  }
  problem.dyads = {DyadKind::rr};
  check_motion_raster(document, problem);
}

void read_motion_robust(TableReader& mechanism, TableReader& solve, MotionProblem& problem) {
  read_robust(solve, motion_robust_refusal(problem), problem.solve);
  if (!problem.solve.robust || problem.method == MotionMethod::exact) return;
  if (mechanism.has("dyads") && problem.dyads != std::vector{DyadKind::rr}) {
    mechanism.fault("dyads",
                    "are not \"RR\" alone, but robust designs are four-bars; expected dyads = "
                    "[\"RR\"]");
  }
  problem.dyads = {DyadKind::rr};
}

}  // namespace cognate::problems::reading
