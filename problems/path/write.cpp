/// A path problem written down, and checked by reading what was written.
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/path/problem.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

/// Samples of a curve that are no farther from where they belong, of its length, are rounding.
constexpr double kSampleTolerance = 1e-9;

Array written_crank_angles(const PathProblem& problem) {
  Array all;
  for (std::size_t i = 0; i < problem.crank_angles.size(); ++i) {
    const bool timed = problem.timing != Timing::mixed ||
                       (i < problem.has_crank_angle.size() && problem.has_crank_angle[i]);
    all.push_back(timed ? node_deg(problem.crank_angles[i]) : node(kFreeAngle));
  }
  return all;
}

/// `[target]` of a closed curve; of a drawing the path data that it held.
TableWriter written_curve(const PathProblem& problem) {
  const TargetCurve& curve = *problem.curve;
  TableWriter table;
  if (curve.svg_path.empty()) {
    table.set("curve", curve.curve.vertices());
  } else {
    table.set("svg_path", curve.svg_path);
  }
  table.set("samples", static_cast<int>(problem.points.size())).set_name("place", curve.place);
  // What no closed curve has is written for the reader to refuse.
  if (!problem.crank_angles.empty()) table.set("crank_deg", written_crank_angles(problem));
  if (!problem.pose_angles.empty()) table.set("poses", problem.pose_angles);
  if (problem.method != PathMethod::least_squares) table.set_name("method", problem.method);
  if (problem.timing != Timing::free) table.set_name("timing", problem.timing);
  if (problem.order != PointOrder::cyclic) table.set_name("order", problem.order);
  return table.set_name("crank_sense", problem.crank_sense);
}

TableWriter written_target(const PathProblem& problem) {
  if (problem.curve) return written_curve(problem);
  TableWriter table;
  const std::size_t poses = std::min(problem.pose_angles.size(), problem.points.size());
  Array pose_rows, points;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const auto& [x, y] = problem.points[i];
    if (i < poses) {
      pose_rows.push_back(node(Array{node(x), node(y), node_deg(problem.pose_angles[i])}));
    } else {
      points.push_back(node(problem.points[i]));
    }
  }
  if (!pose_rows.empty()) table.set("poses", pose_rows);
  if (pose_rows.empty() || !points.empty()) table.set("points", points);
  if (problem.method != PathMethod::least_squares) table.set_name("method", problem.method);
  table.set_name("timing", problem.timing);
  const bool ordered = problem.timing == Timing::free || problem.order != PointOrder::cyclic;
  if (ordered) table.set_name("order", problem.order);
  if (!problem.crank_angles.empty()) table.set("crank_deg", written_crank_angles(problem));
  if (problem.timing != Timing::free) table.set_name("crank_reference", problem.crank_reference);
  table.set_name("crank_sense", problem.crank_sense);
  const bool weighted = problem.method == PathMethod::least_squares && !problem.weights.empty();
  if (weighted) table.set("weights", problem.weights);
  return table;
}

void check_samples(const PathProblem& problem, std::vector<std::string>& faults) {
  const ClosedCurve& curve = problem.curve->curve;
  const auto samples = curve.equally_spaced(static_cast<int>(problem.points.size()));
  const double tolerance = kSampleTolerance * curve.length();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (norm(problem.points[i] - samples[i]) <= tolerance) continue;
    faults.push_back(
        fmt::format("point {} of a closed curve is not that of equal steps along it; "
                    "expected the points of curve.equally_spaced",
                    i + 1));
    break;
  }
  if (problem.constraints.full_turn) return;
  faults.emplace_back("full_turn is false for a closed curve; expected true");
}

void check_sizes(const PathProblem& problem, std::vector<std::string>& faults) {
  const std::size_t count = problem.points.size();
  if (problem.timing == Timing::mixed && problem.has_crank_angle.size() != count) {
    faults.push_back(
        fmt::format("has_crank_angle has {} entries for {} points; expected one for "
                    "each point",
                    problem.has_crank_angle.size(), count));
  }
  if (problem.pose_angles.size() > count) {
    faults.push_back(
        fmt::format("pose_angles has {} entries for {} points; expected at most as "
                    "many",
                    problem.pose_angles.size(), count));
  }
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<PathProblem>::written(const PathProblem& problem) {
  using namespace reading;
  Written all;
  check_sizes(problem, all.faults);
  TableWriter constraints = constraints_writer(problem.constraints);
  write_design_layers(problem.layers, constraints);
  if (problem.curve) constraints.set("no_extra_loop", problem.constraints.no_extra_loop);
  TableWriter solve = solve_writer(problem.solve);
  if (problem.atlas) solve.set("atlas", problem.atlas->name);
  all.document = document_writer(kWord, problem.title, problem.length_unit)
                     .set("target", written_target(problem))
                     .set("mechanism", given_writer(problem.given))
                     .set("bounds", bounds_writer(problem.bounds))
                     .set("constraints", constraints)
                     .append(operation_tables(problem.constraints, problem.solve, all.faults))
                     .set("solve", solve)
                     .set("warnings", warnings_writer(problem.warnings))
                     .append(raster_table(problem.raster))
                     .append(layers_table(problem.layers))
                     .append(tolerance_table(problem.tolerances, false))
                     .take();
  return all;
}

tl::expected<PathProblem, std::vector<std::string>> KindTraits<PathProblem>::checked(
    const PathProblem& problem) {
  using namespace reading;
  PathProblem without_files = problem;
  without_files.atlas.reset();
  const auto read = read_back(without_files);
  if (!read) return tl::unexpected(read.error());
  if (problem.curve) {
    std::vector<std::string> faults;
    check_samples(problem, faults);
    if (!faults.empty()) return tl::unexpected(faults);
  }
  PathProblem complete = problem;
  const bool weighted = problem.method == PathMethod::least_squares && !problem.curve;
  if (!weighted || problem.weights.empty()) complete.weights = read->weights;
  return complete;
}

}  // namespace cognate::problems
