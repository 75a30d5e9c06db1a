/// A motion problem written down, and checked by reading what was written.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

TableWriter written_target(const MotionProblem& problem) {
  TableWriter table;
  table.set_name("method", problem.method);
  if (problem.method == MotionMethod::least_squares) {
    table.set("angle_weight", problem.angle_weight);
  }
  if (!problem.segments.empty()) return table.set("segments", problem.segments);
  Array poses;
  for (const auto& [at, angle] : problem.poses) {
    poses.push_back(node(Array{node(at.x), node(at.y), node_deg(angle)}));
  }
  return table.set("poses", poses);
}

TableWriter written_mechanism(const MotionProblem& problem) {
  TableWriter table;
  if (!problem.fixed_pivots.empty()) table.set("fixed_pivots", problem.fixed_pivots);
  if (!problem.moving_pivots.empty()) table.set("moving_pivots", problem.moving_pivots);
  table.set("fixed_pivot_line", problem.fixed_pivot_line)
      .set("crank", problem.crank)
      .set("rocker", problem.rocker);
  Array dyads;
  for (const synthesis::DyadKind kind : problem.dyads) dyads.push_back(node(to_string(kind)));
  if (!dyads.empty()) table.set("dyads", dyads);
  return table;
}

/// Whether the poses are those that the segments give; angles may be whole turns apart.
bool are_poses_of_segments(const std::vector<synthesis::Pose>& poses,
                           const std::vector<synthesis::Pose>& read) {
  constexpr double kSame = 1e-9;
  if (poses.size() != read.size()) return false;
  double size = 0;
  for (const auto& [at, angle] : read) size = std::max(size, norm(at));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double turned = std::remainder(poses[i].angle - read[i].angle, kTurn);
    const bool same = norm(poses[i].at - read[i].at) <= kSame * size && std::abs(turned) <= kSame;
    if (!same) return false;
  }
  return true;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<MotionProblem>::written(const MotionProblem& problem) {
  using namespace reading;
  Written all;
  TableWriter bounds = bounds_writer(problem.bounds);
  bounds.set("moving_pivot_a", problem.moving_bounds[0])
      .set("moving_pivot_d", problem.moving_bounds[1]);
  TableWriter constraints = constraints_writer(problem.constraints);
  write_design_layers(problem.layers, constraints);
  all.document = document_writer(kWord, problem.title, problem.length_unit)
                     .set("target", written_target(problem))
                     .set("mechanism", written_mechanism(problem))
                     .set("bounds", bounds)
                     .set("constraints", constraints)
                     .append(operation_tables(problem.constraints, problem.solve, all.faults))
                     .set("solve", solve_writer(problem.solve))
                     .set("warnings", warnings_writer(problem.warnings))
                     .append(layers_table(problem.layers))
                     .append(tolerance_table(problem.tolerances, false))
                     .append(raster_table(problem.raster))
                     .take();
  return all;
}

tl::expected<MotionProblem, std::vector<std::string>> KindTraits<MotionProblem>::checked(
    const MotionProblem& problem) {
  using namespace reading;
  const auto read = read_back(problem);
  if (!read) return tl::unexpected(read.error());
  MotionProblem complete = problem;
  if (complete.dyads.empty()) complete.dyads = read->dyads;
  if (complete.moving_pivots.empty()) complete.moving_pivots = read->moving_pivots;
  if (complete.segments.empty()) return complete;
  if (complete.poses.empty()) complete.poses = read->poses;
  if (are_poses_of_segments(complete.poses, read->poses)) return complete;
  return tl::unexpected(std::vector<std::string>{
      "poses are not those of the segments; expected them as synthesis::poses_of_segment gives "
      "them, or none"});
}

}  // namespace cognate::problems
