#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/design.hpp"
#include "problems/guidance/dyad_choices.hpp"
#include "problems/guidance/least_squares.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/search.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/long_links.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidanceStatus;
using synthesis::Pose;

/// Neighbours on a drawn curve are at most so many extents apart; beyond it the curve passes
/// through infinity or out of what is drawn.
constexpr double kSpacing = 0.02;
constexpr double kReach = 8;
constexpr double kBreak = 4;

void add_two_poses(const MotionProblem& problem, Result& result) {
  const std::span<const Pose, 2> poses(problem.poses.data(), 2);
  if (const auto pole = synthesis::pole(synthesis::displacement(poses[0], poses[1]))) {
    result.loci.push_back({"pole", {{*pole}}});
  }
  const double half = kReach / 4 * synthesis::extent(poses);
  for (const Vec2d& pivot : problem.moving_pivots) {
    const auto line = synthesis::fixed_pivots_of(poses, pivot);
    if (!line || half == 0) continue;
    result.loci.push_back(
        {"fixed pivots of a moving pivot",
         {{line->point - half * line->direction, line->point + half * line->direction}}});
  }
}

void add_three_poses(const MotionProblem& problem, Result& result) {
  const auto poles = synthesis::pole_triangle(std::span<const Pose, 3>(problem.poses.data(), 3));
  if (!poles.p12 || !poles.p23 || !poles.p31) return;
  result.loci.push_back({"pole triangle", {{*poles.p12, *poles.p23, *poles.p31, *poles.p12}}});
}

using Points = std::vector<synthesis::BurmesterCurves::Point>;

/// What can be drawn of a branch: both pivots within a few reaches of the poses.
Points drawable(const synthesis::BurmesterCurves& curves, int branch, std::span<const Pose> poses) {
  const double most = 4 * kReach * synthesis::extent(poses);
  Points points;
  for (const auto& point : curves.trace(branch, kSpacing, kReach)) {
    const auto& dyad = point.dyad;
    const bool near = norm(dyad.fixed - poses[0].at) <= most &&
                      norm(dyad.moving - poses[0].at) <= most;  // false for what is no number
    if (dyad.kind == DyadKind::rr && near) points.push_back(point);
  }
  return points;
}

/// The curve of one pivot, broken where it passes through infinity.
std::vector<std::vector<Vec2d>> polylines(const Points& points, double extent,
                                          Vec2d synthesis::GuidingDyad::*pivot) {
  std::vector<std::vector<Vec2d>> lines;
  std::optional<Vec2d> last;
  for (const auto& point : points) {
    const Vec2d at = point.dyad.*pivot;
    if (!last || norm(at - *last) > kBreak * extent) lines.emplace_back();
    lines.back().push_back(at);
    last = at;
  }
  std::erase_if(lines, [](const std::vector<Vec2d>& line) { return line.size() < 2; });
  return lines;
}

Family family(int branch, const Points& points) {
  Family made{fmt::format("Burmester curve, branch {}", branch + 1),
              {{"parameter", {}},
               {"fixed_x", {}},
               {"fixed_y", {}},
               {"moving_x", {}},
               {"moving_y", {}},
               {"length", {}}}};
  for (const auto& point : points) {
    const auto& dyad = point.dyad;
    const double row[] = {point.parameter, dyad.fixed.x,  dyad.fixed.y,
                          dyad.moving.x,   dyad.moving.y, dyad.length};
    for (std::size_t k = 0; k < made.columns.size(); ++k) made.columns[k].values.push_back(row[k]);
  }
  return made;
}

void add_four_poses(const MotionProblem& problem, Result& result) {
  const std::span<const Pose, 4> poses(problem.poses.data(), 4);
  const synthesis::BurmesterCurves curves(poses);
  if (curves.status() != GuidanceStatus::family) return;
  Locus centre{"centre-point curve", {}}, circle{"circle-point curve", {}};
  const double extent = synthesis::extent(poses);
  for (int branch = 0; branch < curves.branch_count(); ++branch) {
    const Points points = drawable(curves, branch, poses);
    if (points.empty()) continue;
    for (auto& line : polylines(points, extent, &synthesis::GuidingDyad::fixed)) {
      centre.branches.push_back(std::move(line));
    }
    for (auto& line : polylines(points, extent, &synthesis::GuidingDyad::moving)) {
      circle.branches.push_back(std::move(line));
    }
    result.families.push_back(family(branch, points));
  }
  result.loci.push_back(std::move(centre));
  result.loci.push_back(std::move(circle));
}

/// Two poses: the pole, and for each moving pivot given the bisector of its positions. Three: the
/// pole triangle. Four: the "centre-point curve" and the "circle-point curve" (at the first pose),
/// and a family for each branch of theirs. Nothing for five.
void add_motion_loci(const MotionProblem& problem, Result& result) {
  switch (problem.poses.size()) {
    case 2:
      return add_two_poses(problem, result);
    case 3:
      return add_three_poses(problem, result);
    case 4:
      return add_four_poses(problem, result);
    default:
      return;
  }
}

using synthesis::Pose;

/// Poses closer than this, relative to the extent and in radians, are one.
constexpr double kOnePose = 1e-12;

/// Where every solution is in a list, so many are returned unless the file says otherwise.
constexpr int kAll = 100;

bool is_same(const Pose& a, const Pose& b, double extent) {
  const double turn = std::remainder(a.angle - b.angle, kTurn);
  return std::abs(turn) <= kOnePose && norm(a.at - b.at) <= kOnePose * extent;
}

/// The problem without poses that repeat an earlier one, which say nothing new.
MotionProblem without_repeats(const MotionProblem& problem, std::vector<std::string>& notes) {
  MotionProblem reduced = problem;
  reduced.poses.clear();
  const double extent = synthesis::extent(problem.poses);
  for (std::size_t i = 0; i < problem.poses.size(); ++i) {
    const auto same = std::ranges::find_if(
        problem.poses, [&](const Pose& pose) { return is_same(pose, problem.poses[i], extent); });
    const auto earlier = static_cast<std::size_t>(same - problem.poses.begin());
    if (earlier >= i) {
      reduced.poses.push_back(problem.poses[i]);
      continue;
    }
    notes.push_back(
        fmt::format("Pose {} is pose {} again (coincident poses): it adds no condition, "
                    "and the body is guided through the others.",
                    i + 1, earlier + 1));
  }
  return reduced;
}

std::string origin(std::size_t poses) {
  switch (poses) {
    case 2:
      return "exact:two-poses";
    case 3:
      return "exact:three-poses";
    case 4:
      return "exact:burmester-4";
    default:
      return "exact:burmester-5";
  }
}

DyadPairChoices dyads_of(const MotionProblem& problem) {
  switch (problem.poses.size()) {
    case 4:
      return {dyad_of_four_poses(problem), std::nullopt};
    case 5:
      return {dyad_of_five_poses(problem), std::nullopt};
    default:
      return dyads_of_few_poses(problem);
  }
}

void add_note(std::string note, Result& result) {
  if (std::ranges::count(result.notes, note) == 0) result.notes.push_back(std::move(note));
}

/// Why pairs of listed dyads make no mechanism.
void note_faults(const MotionProblem& problem, const DyadPairChoices& options, Result& result) {
  if (options.first.is_family() || (options.second && options.second->is_family())) return;
  const DyadChoices& second = options.second ? *options.second : options.first;
  for (std::size_t i = 0; i < options.first.choices.size(); ++i) {
    for (std::size_t j = options.second ? 0 : i + 1; j < second.choices.size(); ++j) {
      const auto fault = synthesis::guided_mechanism(options.first.choices[i].dyad,
                                                     second.choices[j].dyad, problem.poses)
                             .fault;
      if (fault == synthesis::PairingFault::none) continue;
      add_note(fmt::format("A pair of dyads makes no mechanism: {}.", sentence(fault)), result);
    }
  }
}

void note_count(const MotionProblem& problem, const DyadPairChoices& options, Result& result) {
  const std::size_t count = options.first.choices.size();
  if (problem.poses.size() == 5 && !options.first.is_family()) {
    result.quantities.push_back({"dyads", static_cast<double>(count)});
    if (count < 2 && !options.first.is_degenerate) {
      add_note(fmt::format("{} guides the body through the five poses, and a mechanism needs two; "
                           "move or drop a pose.",
                           count == 0 ? "No real dyad" : "One real dyad only"),
               result);
    }
  } else if (result.designs.empty() && result.notes.empty()) {
    add_note("No two dyads guide the body through the poses.", result);
  }
}

Status status_of(const Result& result, const Deadline& deadline) {
  if (deadline.interrupted()) return Status::interrupted;
  if (deadline.expired()) return Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  const bool solved = std::ranges::any_of(
      result.designs, [](const Design& design) { return all_satisfied(design.constraints); });
  return solved ? Status::solved : Status::infeasible;
}

void find_designs(const MotionProblem& problem, const Deadline& deadline, Result& result) {
  const DyadPairChoices options = dyads_of(problem);
  for (const std::string& note : options.first.notes) add_note(note, result);
  if (options.second) {
    for (const std::string& note : options.second->notes) add_note(note, result);
  }
  const bool is_family =
      options.first.is_family() || (options.second && options.second->is_family());
  const bool all = !is_family && !problem.designs_given;
  const int count = all ? kAll : problem.solve.designs;
  const RankedPairs ranked = ranked_pairs(problem, options, count, deadline);
  for (const RankedPair& pair : ranked.pairs) {
    if (std::ssize(result.designs) == count) break;
    auto design = motion_design(problem, pair.pair, origin(problem.poses.size()));
    if (design) {
      result.designs.push_back(std::move(*design));
    } else {
      add_note(
          "A pair of dyads is left out whose mechanism rounding keeps from the poses: its slides "
          "are nearly parallel, or its links far longer than the way of the body.",
          result);
    }
  }
  result.work.candidates = ranked.judged;
  result.work.positions = problem.poses.size() * result.designs.size();
  note_faults(problem, options, result);
  const bool is_complete = !deadline.interrupted() && !deadline.expired();
  if (is_complete) note_count(problem, options, result);
}

Result solve_exactly(const MotionProblem& problem, const Run& run) {
  const Deadline deadline(run);
  Result result;
  const MotionProblem reduced = without_repeats(problem, result.notes);
  if (reduced.poses.size() < 2) {
    result.notes.push_back(
        "There is one pose only, and nothing to guide the body through; at least "
        "two different poses are needed.");
  } else {
    find_designs(reduced, deadline, result);
    add_motion_loci(reduced, result);
  }
  result.status = status_of(result, deadline);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace

Result solve(const MotionProblem& given, const Run& run) {
  const auto valid = KindTraits<MotionProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const MotionProblem problem = in_joules(*valid);
  const bool exact = problem.method != MotionMethod::least_squares;
  Result result = solve_in_layers(problem, run, exact ? DesignSource::exact : DesignSource::search,
                                  exact ? solve_exactly : solve_by_least_squares);
  std::vector<Vec2d> origins;
  for (const Pose& pose : problem.poses) origins.push_back(pose.at);
  if (!exact && !problem.solve.robust) merge_long_links(result);
  mark_twins(result.designs);
  add_warnings(extent_of(origins), problem.warnings, result);
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) {
        return error_at_targets(design.mechanism, "P", design.crank_angles, origins, true);
      },
      result);
  note_units(problem.constraints.operation, problem.length_unit, result);
  return result;
}

}  // namespace cognate::problems
