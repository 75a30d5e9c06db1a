#include "problems/guidance/least_squares.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/parallel.hpp"
#include "problems/guidance/dyads.hpp"
#include "problems/guidance/fit.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/raster.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/report.hpp"
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

/// That error of a design, a length.
double error_of(const MotionProblem& /*problem*/, const Design& design) {
  return design.error.rms;
}

/// Errors up to this are rounding: the target is met.
double met_error(const MotionProblem& problem) {
  return kMetError * MotionScale(problem).size();
}

namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

/// Starts with limits over the turn, of whose minima half as many were seen to miss the best.
constexpr int kLimitedStarts = 1600;
constexpr double kDefaultTolerance = 1e-13;
/// Designs closer than this, relative to their size, are one: no use is made of a thousandth.
constexpr double kSameWithin = 1e-3;

bool is_same(const GuidingDyad& a, const GuidingDyad& b, double size) {
  if (a.kind != b.kind) return false;
  const double turned = a.kind == DyadKind::rr ? 0 : std::abs(cross(a.direction, b.direction));
  const double apart = std::max(
      {norm(a.in_body - b.in_body), norm(a.fixed - b.fixed), std::abs(a.length - b.length)});
  return turned <= kSameWithin && apart <= kSameWithin * (size + std::max(a.length, b.length));
}

/// Whichever dyad drives.
bool is_same(const DyadPair& a, const DyadPair& b, double size) {
  return (is_same(a.first, b.first, size) && is_same(a.second, b.second, size)) ||
         (is_same(a.first, b.second, size) && is_same(a.second, b.first, size));
}

struct StartDesign {
  DyadPair pair;
  Design design;
  double violation = 0;
};

class Designs {
 public:
  Designs(const MotionProblem& problem, double size) : problem_(problem), size_(size) {}

  void add(const DyadPair& pair, const std::vector<Pose>& reached, const std::string& origin) {
    auto best = candidate(pair, reached, origin);
    // The rocker may drive as well, if that mends what is wrong with the crank's driving.
    if (pair.second.kind == DyadKind::rr && roles_are_alike(problem_) &&
        (!best || best->violation > 0 || !problem_.constraints.required_class)) {
      auto turned = candidate({pair.second, pair.first}, reached, origin);
      if (turned && (!best || is_better(*turned, *best))) best = std::move(turned);
    }
    if (!best) return;
    auto& list = best->violation > 0 ? violating_ : feasible_;
    const bool known = std::ranges::any_of(
        list, [&](const StartDesign& other) { return is_same(other.pair, best->pair, size_); });
    if (!known) list.push_back(std::move(*best));
  }

  bool any_feasible() const { return !feasible_.empty(); }

  /// The best designs: feasible ones if there are any.
  std::vector<Design> take() {
    auto& all = feasible_.empty() ? violating_ : feasible_;
    // Several searches may have added to them.
    std::ranges::stable_sort(all, {}, [](const StartDesign& c) {
      return std::pair(c.violation, c.design.error.sum_of_squares);
    });
    const auto exact = std::stable_partition(all.begin(), all.end(), [&](const StartDesign& c) {
      return c.design.error.sum_of_squares <= kMetExactly * size_ * size_;
    });
    std::stable_sort(all.begin(), exact, [](const StartDesign& a, const StartDesign& b) {
      return a.design.metrics.transmission_acute_min > b.design.metrics.transmission_acute_min;
    });
    std::vector<Design> designs;
    for (StartDesign& candidate : all) {
      if (std::ssize(designs) == problem_.solve.designs) break;
      designs.push_back(std::move(candidate.design));
    }
    return designs;
  }

 private:
  static bool is_better(const StartDesign& a, const StartDesign& b) {
    if (a.violation != b.violation) return a.violation < b.violation;
    return a.design.metrics.transmission_acute_min > b.design.metrics.transmission_acute_min;
  }

  std::optional<StartDesign> candidate(const DyadPair& pair, const std::vector<Pose>& reached,
                                       const std::string& origin) const {
    auto design = nearest_design(problem_, pair, reached, origin);
    if (!design || !std::isfinite(design->error.sum_of_squares)) return std::nullopt;
    check_error(problem_, *design);
    const double amount = violation(design->constraints);
    return StartDesign{pair, std::move(*design), amount};
  }

  const MotionProblem& problem_;
  double size_;
  std::vector<StartDesign> feasible_, violating_;
};

Status status_of(const Deadline& deadline, bool ended_early, const Designs& designs,
                 const Result& result) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return designs.any_feasible() ? Status::solved : Status::infeasible;
}

/// The searches of the problem: pivots that are given do not say which dyad is driven.
std::vector<MotionProblem> drives_of(const MotionProblem& problem) {
  std::vector<MotionProblem> drives{problem};
  MotionProblem without = problem;
  without.fixed_pivots.clear();
  without.moving_pivots.clear();
  if (roles_are_alike(problem) || !roles_are_alike(without)) return drives;
  drives.push_back(problem);
  drives.back().first_is_driven = false;
  return drives;
}

SearchStatistics add_designs(const MotionProblem& problem, std::optional<int> starts,
                             const Run& run, const Deadline& deadline, Designs& designs,
                             Work& work) {
  const MotionScale scale(problem);
  const MotionProblem scaled = scale.into(problem);
  const synthesis::Solver solver = synthesis::chosen(problem.solve.solver);
  const double tolerance = problem.solve.tolerance.value_or(kDefaultTolerance);
  std::vector<DyadPair> known;
  for (const Design& design : run.known) {
    if (const auto pair = pair_of(problem, design)) known.push_back(scale.into(*pair));
  }
  const auto found = search_motions(scaled, known, starts, solver, tolerance, run, deadline, work);
  for (const MotionMinimum& minimum : found.minima) {
    const MotionModel model(scaled, minimum.form);
    std::vector<Pose> reached = model.reached(minimum.solution.x);
    if (reached.empty()) continue;
    for (Pose& pose : reached) pose = scale.out_of(pose);
    designs.add(scale.out_of(model.pair(minimum.solution.x)), reached,
                minimum.origin + refined_by(solver));
  }
  return found.statistics;
}

/// Of two searches for the same thing.
SearchStatistics together(const SearchStatistics& a, const SearchStatistics& b) {
  const double starts = std::max(1, a.starts + b.starts);
  return {a.starts + b.starts, std::max(a.best_hits, b.best_hits),
          (a.starts * a.unseen + b.starts * b.unseen) / starts};
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
  Designs designs(problem, MotionScale(problem).size());
  const auto drives = drives_of(problem);
  const int searches = static_cast<int>(drives.size());
  std::optional<int> starts = problem.solve.starts;
  if (!starts && limits_turn(problem.constraints)) starts = kLimitedStarts;
  if (starts) starts = (*starts + searches - 1) / searches;
  SearchStatistics statistics;
  for (const MotionProblem& drive : drives) {
    statistics =
        together(statistics, add_designs(drive, starts, run, deadline, designs, result.work));
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

/// What is verified of a mechanism on the raster, computed by the kernel.
std::optional<Design> raster_design(const MotionProblem& problem, const RasterMotion& motion) {
  auto design = nearest_design(problem, motion.pair, motion.reached, "raster");
  if (!design || !std::isfinite(design->error.sum_of_squares)) return std::nullopt;
  check_error(problem, *design);
  return design;
}

/// The raster of one drive, from the minima that a search without it finds.
RasterMotionResult search_one_raster(const MotionProblem& problem, const Run& run,
                                     const Deadline& deadline, SearchStatistics& statistics,
                                     Work& work) {
  const MotionScale scale(problem);
  const MotionProblem scaled = scale.into(problem);
  const double tolerance = problem.solve.tolerance.value_or(kDefaultTolerance);
  const auto found =
      search_motions(scaled, {}, problem.solve.starts, synthesis::chosen(problem.solve.solver),
                     tolerance, run, deadline, work);
  statistics = together(statistics, found.statistics);
  const auto accepts = [&](const RasterMotion& motion) {
    const auto design = raster_design(problem, motion);
    return design && all_satisfied(design->constraints);
  };
  return search_motion_raster(problem, scaled, scale, found.minima, accepts, run, deadline);
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
  for (MotionProblem& drive : drives_of(problem)) {
    drive.solve.designs = std::max(drive.solve.designs, kMinima);
    auto one = search_one_raster(drive, run, deadline, statistics, result.work);
    if (found) {
      add_other_drive(*found, std::move(one));
    } else {
      found = std::move(one);
    }
  }
  for (const RasterMotion& motion : found->designs) {
    if (std::ssize(result.designs) == problem.solve.designs) break;
    auto design = raster_design(problem, motion);
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
  Result result = solve_objectives(
      problem, run, deadline,
      [&](const MotionProblem& one, const Run& own) { return search(one, own, deadline); });
  Run silent = run;
  silent.progress = nullptr;
  const auto solve_once = [&](const MotionProblem& other) {
    return search(other, silent, deadline);
  };
  add_infeasibility(problem, deadline, solve_once, result);
  result.work.skipped = skipped_evaluations(problem.constraints);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
