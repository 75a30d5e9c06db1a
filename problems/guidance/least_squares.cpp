#include "problems/guidance/least_squares.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/parallel.hpp"
#include "problems/guidance/designs.hpp"
#include "problems/guidance/dyads.hpp"
#include "problems/guidance/fit.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/raster.hpp"
#include "problems/guidance/robust.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/report.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/search/infeasibility.hpp"
#include "problems/search/objectives.hpp"
#include "problems/search/solver_origin.hpp"
#include "synthesis/fit/body_motion.hpp"

namespace cognate::problems {

// What error_limit.hpp and objectives.hpp ask of a kind, found by the type of its problem.

/// What the error of a problem is: the root mean square distance,
/// angles by their weight. A smaller one means a smaller objective.
ErrorMeasure error_measure(const MotionProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

/// Errors up to this are rounding: the target is met.
double met_error(const MotionProblem& problem) {
  return kMetError * MotionScale(problem).size();
}

namespace {

using synthesis::Pose;

Status status_of(const Deadline& deadline, bool ended_early, const MotionDesigns& designs,
                 const Result& result) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return designs.any_feasible() ? Status::solved : Status::infeasible;
}

/// What is special about the motion as a whole, for the user; empty for most.
std::string degeneracy(const MotionProblem& problem) {
  constexpr double kNothing = 1e-12;
  const auto& poses = problem.poses;
  const double size = std::max(synthesis::extent(poses), problem.angle_weight);
  const bool is_turned = std::ranges::any_of(poses, [&](const Pose& pose) {
    return std::abs(std::sin(0.5 * (pose.angle - poses.front().angle))) > kNothing;
  });
  if (!is_turned && !(synthesis::extent(poses) > kNothing * size)) {
    return "All poses coincide: there is no motion to generate.";
  }
  const auto note = [](synthesis::GuidanceStatus status) {
    return fmt::format("A special motion: {}.", sentence(status));
  };
  if (!is_turned) return note(synthesis::GuidanceStatus::translation);
  const bool rests = synthesis::resting_point(poses).travel <= kNothing * size;
  return rests ? note(synthesis::GuidanceStatus::rotation) : "";
}

Result search(const MotionProblem& problem, const Run& run, const Deadline& deadline) {
  Result result;
  MotionDesigns designs(problem, MotionScale(problem).size());
  const auto drives = drives_of(problem);
  const auto starts = starts_of(problem, drives.size());
  SearchStatistics statistics;
  for (const MotionProblem& drive : drives) {
    statistics =
        together(statistics, add_minima(drive, starts, run, deadline, designs, result.work));
  }
  result.quantities = quantities(statistics);
  const bool ended_early = deadline.reached();
  if (const std::string note = degeneracy(problem); !note.empty()) result.notes.push_back(note);
  result.designs = designs.take();
  result.status = status_of(deadline, ended_early, designs, result);
  if (result.status == Status::no_solution) {
    result.notes.push_back(
        "No mechanism was found that closes at every pose; wider bounds or more starts may help.");
  }
  return result;
}

/// The raster of one drive, from the minima that a search without it finds.
RasterMotionResult search_one_raster(const MotionProblem& problem, const Run& run,
                                     const Deadline& deadline, SearchStatistics& statistics,
                                     Work& work) {
  const MotionScale scale(problem);
  const MotionProblem scaled = scale.into(problem);
  const double tolerance = problem.solve.tolerance.value_or(kMotionTolerance);
  const auto found =
      search_motions(scaled, {}, problem.solve.starts, synthesis::chosen(problem.solve.solver),
                     tolerance, between_values(run), deadline, work);
  statistics = together(statistics, found.statistics);
  const auto accepts = [&](const RasterMotion& motion) {
    const auto design = verified_design(problem, {motion.pair, motion.reached}, "raster");
    return design && all_satisfied(design->constraints);
  };
  return search_motion_raster(problem, scaled, scale, found.minima, accepts, on_values(run),
                              deadline, work);
}

/// The rasters of several drives as one: either has what the other lacks.
void add_other_drive(RasterMotionResult& all, RasterMotionResult other) {
  std::ranges::move(other.designs, std::back_inserter(all.designs));
  std::ranges::stable_sort(all.designs, {}, &RasterMotion::objective);
  all.search = synthesis::together(std::move(all.search), std::move(other.search));
}

/// The continuous optimum and other minima, then the raster.
Result solve_motion_on_raster(const MotionProblem& problem, const Run& run,
                              const Deadline& deadline) {
  constexpr int kMinima = 6;
  Result result;
  SearchStatistics statistics;
  std::optional<RasterMotionResult> found;
  auto drives = drives_of(problem);
  const double share = 1.0 / double(drives.size());
  for (std::size_t i = 0; i < drives.size(); ++i) {
    MotionProblem& drive = drives[i];
    const Run part = part_of(run, share * double(i), share * double(i + 1));
    drive.solve.designs = std::max(drive.solve.designs, kMinima);
    auto one = search_one_raster(drive, part, deadline, statistics, result.work);
    if (found) {
      add_other_drive(*found, std::move(one));
    } else {
      found = std::move(one);
    }
  }
  for (const RasterMotion& motion : found->designs) {
    if (std::ssize(result.designs) == problem.solve.designs) break;
    auto design = verified_design(problem, {motion.pair, motion.reached}, "raster");
    if (design) result.designs.push_back(*std::move(design));
  }
  result.quantities = quantities(statistics);
  const double size = MotionScale(problem).size(), count = double(problem.poses.size());
  const auto error = [&](double objective) { return size * std::sqrt(objective / count); };
  std::ranges::move(raster_quantities(found->search, error), std::back_inserter(result.quantities));
  result.notes = raster_notes(found->search, error);
  if (deadline.reached()) {
    result.status = deadline.interrupted() ? Status::interrupted : Status::time_limit;
  } else {
    result.status = result.designs.empty() ? Status::no_solution : Status::solved;
  }
  result.work.skipped = skipped_evaluations(problem.constraints);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace

Result solve_by_least_squares(const MotionProblem& problem, const Run& run) {
  const Deadline deadline(run);
  if (problem.raster) return solve_motion_on_raster(problem, run, deadline);
  if (problem.solve.robust) return solve_motion_robustly(problem, run, deadline);
  Result result = solve_objectives(
      problem, run, deadline,
      [&](const MotionProblem& one, const Run& own) { return search(one, own, deadline); });
  const Run unseen = silent(run);
  const auto solve_once = [&](const MotionProblem& other) {
    return search(other, unseen, deadline);
  };
  add_infeasibility(problem, run, deadline, solve_once, result);
  result.work.skipped = skipped_evaluations(problem.constraints);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
