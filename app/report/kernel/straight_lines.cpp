/// @file The search for straight lines in a page: four-bars of which a point goes nearly straight
/// over a length.
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/report/kernel/sketched.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/straight_line/keys.hpp"
#include "problems/straight_line/normalised.hpp"
#include "problems/straight_line/read_ends.hpp"
#include "problems/straight_line/search.hpp"

namespace cognate::page {
namespace {

using problems::Design;
using problems::LinkageSegment;
using problems::StraightLineProblem;

/// A place of the crank at either end of the line, and one between.
constexpr std::size_t kPlacesOfLine = 3;

/// Both ends, with what the file format has for limits.
std::size_t read_line(problems::reading::LinkageTables& tables, StraightLineProblem& problem) {
  using namespace problems::reading;
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  require_target(target, "ends");
  problem.goal.emplace();
  read_keys(target, kGoalKeys, *problem.goal);
  read_ends(target, *problem.goal);
  read_link_constraints(constraints, length_limits({}, {}), problem.constraints);
  read_pivot_region(constraints, {}, problem.constraints);
  read_keys(constraints, kSegmentKeys, problem.segment);
  problem.solve = read_solve(solve, problem.constraints, false);
  return kPlacesOfLine;
}

/// The segment of a design whose crank stands at its ends as `read_known` says.
LinkageSegment segment_of(const Design& design) {
  const FourBar& linkage = four_bar(design);
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  const double from = design.crank_angles.front(), to = design.crank_angles.back();
  LinkageSegment segment;
  segment.assembly = linkage.assembly;
  segment.dimensions = {{linkage.crank, linkage.coupler, linkage.rocker, norm(frame)},
                        linkage.coupler_point.value_or(Vec2d{})};
  segment.frame_angle = std::atan2(frame.y, frame.x);
  segment.centre = (from + to) / 2 - segment.frame_angle;
  segment.reach = (to - from) / 2;
  return segment;
}

std::vector<LinkageSegment> known_segments(const std::vector<Design>& known, double unit) {
  std::vector<LinkageSegment> segments;
  for (const Design& design : known) {
    LinkageSegment segment = enlarged(segment_of(design), 1 / unit);
    if (segment.reach > 0 && fit_line(segment)) segments.push_back(std::move(segment));
  }
  return segments;
}

/// With the deviation as its error and the crank at the places of the line.
Design line_design(const StraightLineProblem& problem, problems::SegmentDesign found, double unit) {
  found.segment = in_file_unit(std::move(found.segment), unit);
  Design design = searched_design(problem, found);
  design.error.rms = design.error.max = problems::measures_of(design).deviation;
  const double from = *find_quantity(design.metrics.quantities, problems::kSegmentFromKey),
               to = *find_quantity(design.metrics.quantities, problems::kSegmentToKey);
  design.crank_angles = {from, (from + to) / 2, to};
  return design;
}

std::vector<Design> solved(const StraightLineProblem& problem, const problems::Run& run) {
  const problems::Deadline none(run);
  problems::Work work;
  const double unit = *problem.goal->length;
  const auto found =
      search_segments(in_unit(problem, unit), known_segments(run.known, unit), {}, run, none, work);
  std::vector<Design> designs;
  for (const problems::SegmentDesign& one : found.found) {
    Design design = line_design(problem, one, unit);
    if (all_satisfied(design.constraints)) designs.push_back(std::move(design));
    if (std::ssize(designs) == problem.solve.designs) break;
  }
  return designs;
}

}  // namespace

nlohmann::ordered_json sketched_lines(const SketchQuestion& question) {
  return answered<StraightLineProblem>(
      question, read_line,
      [](const auto& problem, const auto& run) { return solved(problem, run); });
}

}  // namespace cognate::page
