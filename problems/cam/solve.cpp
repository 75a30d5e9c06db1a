/// Cams from problem to designs: in closed form where that is possible, else by search.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/parallel.hpp"
#include "problems/cam/exact.hpp"
#include "problems/cam/largest_roller.hpp"
#include "problems/cam/notes.hpp"
#include "problems/cam/quantities.hpp"
#include "problems/cam/raster.hpp"
#include "problems/cam/result.hpp"
#include "problems/cam/search.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/cam/tolerance_figures.hpp"
#include "problems/cam/variables.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

/// A number from −1 to 1, the same on every system.
double draw(std::mt19937_64& random) {
  return 2 * (static_cast<double>(random() >> 11U) * 0x1p-53) - 1;
}

/// Lengths in proportions that cams usually have, about a base radius.
cam::CamDimensions<double> usual(const CamProblem& problem, double base) {
  const auto or_else = [&](CamDimension dimension, double free) {
    return problem.length(dimension).given.value_or(free);
  };
  cam::CamDimensions<double> d;
  d.base_radius = or_else(CamDimension::base_radius, base);
  d.offset = or_else(CamDimension::offset, 0);
  d.roller_radius = or_else(CamDimension::roller_radius, 0.25 * d.base_radius);
  d.face_offset = or_else(CamDimension::face_offset, 0);
  const auto& arm = problem.length(CamDimension::arm).given;
  d.centre_distance = or_else(CamDimension::centre_distance,
                              arm ? std::hypot(*arm, d.base_radius) : 2 * d.base_radius);
  d.arm = arm.value_or(
      std::sqrt(std::abs(d.centre_distance * d.centre_distance - d.base_radius * d.base_radius)));
  return d;
}

void clamp_to_bounds(const CamVariables& variables, std::vector<double>& x) {
  const auto all = variables.variables();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i])) x[i] = all[i].scale;
    x[i] = std::clamp(x[i], all[i].lower, all[i].upper);
  }
}

/// Lengths by a factor, the offset and what may have either sign by an addition.
void vary(const CamVariables& variables, std::mt19937_64& random, std::vector<double>& x) {
  constexpr double kLogarithm = 1.5;
  const auto all = variables.variables();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool signed_length = all[i].lower < 0;
    const bool narrow = all[i].upper - all[i].lower < 4 * all[i].scale;
    const double by = draw(random);
    if (narrow) {
      x[i] = std::lerp(all[i].lower, all[i].upper, 0.5 * (1 + by));
    } else if (signed_length) {
      x[i] += 2 * by * variables.unit();
    } else {
      x[i] *= std::exp(kLogarithm * by);
    }
  }
}

/// `count` starts: the variables at proportions that cams usually have, then others drawn about
/// them, within the bounds. The same seed gives the same starts.
std::vector<std::vector<double>> cam_starts(const CamVariables& variables, int count,
                                            std::uint64_t seed) {
  constexpr double kBases[] = {1, 2, 4};
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> starts;
  for (int i = 0; i < count; ++i) {
    const double base = kBases[static_cast<std::size_t>(i) % std::size(kBases)];
    auto x = variables.values(usual(variables.problem(), base * variables.unit()));
    clamp_to_bounds(variables, x);
    if (i >= static_cast<int>(std::size(kBases))) vary(variables, random, x);
    clamp_to_bounds(variables, x);
    starts.push_back(std::move(x));
  }
  return starts;
}

using synthesis::Solver;
using Ends = std::vector<std::optional<CamCandidate>>;  ///< one for each start

/// Starts of a search; fewer for motions of so many pieces that each takes long.
constexpr std::size_t kStarts = 12, kManyPieces = 2000;
/// Starts that a second solver takes up where the first found no cam that keeps every limit.
constexpr std::size_t kRetried = 3;
/// Share of the search, for progress, after the first of two solvers.
constexpr double kFirstSolverDone = 0.8;

int starts_for(const cam::MotionProgramme& programme) {
  const std::size_t share = kStarts * kManyPieces / (programme.pieces().size() + 1);
  return static_cast<int>(std::clamp<std::size_t>(share, 1, kStarts));
}

/// A finished cam with all that is known of it.
CamDesign design_of(const CamProblem& problem, cam::Cam cam, std::vector<cam::MotionSegment> motion,
                    std::string origin) {
  CamDesign design;
  design.cam = std::move(cam);
  design.motion = std::move(motion);
  const bool pressed = problem.second.closure == cam::Closure::force;
  if (problem.has_operation && !problem.preload && pressed) {
    design.cam.system.operation.preload = least_preload(design.cam);
  }
  design.operation = design.cam.system.operation;
  if (problem.second.closure == cam::Closure::conjugate) {
    design.second = conjugate_cam(design.cam, problem.second);
  }
  const CamExtremes extremes(design.cam);
  design.metrics = cam_quantities(problem, design, extremes);
  design.constraints = cam_checks(problem, design, extremes);
  design.origin = std::move(origin);
  return design;
}

/// The problem with the preload that its motion needs, where the motion is given and it is not.
CamProblem with_preload(CamProblem problem, const cam::MotionProgramme& programme) {
  if (!problem.has_operation || problem.preload) return problem;
  if (problem.second.closure != cam::Closure::force) return problem;
  cam::Cam still;
  still.system.operation = problem.operation;
  still.programme = programme;
  problem.operation.preload = least_preload(still);
  return problem;
}

/// The problem with the base radius that a given distance of parallel contacts asks for.
CamProblem with_breadth(CamProblem problem, const cam::MotionProgramme& programme) {
  CamLength& base = problem.length(CamDimension::base_radius);
  const SecondContact& second = problem.second;
  if (second.closure != cam::Closure::constant_breadth || !second.breadth || base.given) {
    return problem;
  }
  cam::Cam still;
  still.programme = programme;
  base.given = 0.5 * (*second.breadth - constant_breadth(still));
  return problem;
}

/// Solves one problem; keeps what its parts share.
class CamSolver {
 public:
  CamSolver(const CamProblem& problem, const cam::MotionProgramme& programme, const Run& run,
            const Deadline& deadline, CamResult& result)
      : asked_(problem),
        programme_(programme),
        problem_(with_breadth(with_preload(problem, programme_), programme_)),
        sought_(without_roller(problem_)),
        variables_(sought_),
        run_(run),
        deadline_(deadline),
        result_(result) {}

  void solve() {
    result_.work.threads = 1;
    result_.work.skipped = {"search", "gradients"};
    if (!problem_.has_operation) result_.work.skipped.emplace_back("forces");
    if (variables_.variables().empty()) {
      add(cam_at(variables_, {}), "given");
      return;
    }
    const auto exact = exact_cam(sought_, programme_);
    const Range& base = sought_.length(CamDimension::base_radius).bounds;
    if (exact && exact->proof.base_radius_least > base.max * (1 + kCheckTolerance)) {
      // Proved to be impossible: the cam that the limits need shows by how much.
      add(cam_at(variables_, variables_.values(exact->dimensions)), "exact:half-planes");
      if (!result_.designs.empty()) return tell_proof(*exact);
    }
    if (exact && sought_.solve.solver == Solver::automatic && add_exact(*exact)) return;
    search(exact);
  }

 private:
  bool add(std::optional<cam::Cam> cam, std::string origin, std::vector<double> x = {}) {
    if (!cam) return false;
    auto motion = variables_.motion(x);
    if (frees_roller(problem_)) enlarge_roller(problem_, *cam);
    result_.designs.push_back(
        design_of(asked_, *std::move(cam), std::move(motion), std::move(origin)));
    return true;
  }

  /// Takes the exact cam, larger where bounds ask for that; false where it breaks a limit.
  bool add_exact(const ExactCam& exact) {
    auto d = exact.dimensions;
    const Range& base = sought_.length(CamDimension::base_radius).bounds;
    if (d.base_radius < base.min) {
      // (e, s₀) farther from the origin mostly stays in every half plane, which is checked; an
      // arm's cam is searched for.
      if (is_oscillating(sought_.follower)) return false;
      if (!sought_.length(CamDimension::offset).given) d.offset *= base.min / d.base_radius;
      d.base_radius = base.min;
    }
    if (!(d.base_radius > 0)) return false;
    const auto x = variables_.values(d);
    auto cam = cam_at(variables_, x);
    if (!cam) return false;
    CamDesign made = design_of(sought_, *cam, sought_.motion, "");
    if (!all_satisfied(made.constraints)) return false;
    add(std::move(cam), "exact:half-planes", x);
    if (is_flat(sought_.follower)) result_.designs.back().origin = "exact:curvature";
    tell_proof(exact);
    return true;
  }

  void tell_proof(const ExactCam& exact) {
    if (exact.proof.base_radius_least > 0) result_.designs.back().proof = exact.proof;
  }

  void search(const std::optional<ExactCam>& exact) {
    const auto solvers = solvers_of(sought_.solve.solver);
    std::erase_if(result_.work.skipped, [](const auto& what) { return what != "forces"; });
    result_.work.threads = thread_count(run_.threads);
    auto starts =
        cam_starts(variables_, sought_.solve.starts.value_or(starts_for(programme_)), run_.seed);
    // A solver that the file names shows what it finds by itself.
    const bool helped = exact && sought_.solve.solver == Solver::automatic;
    if (helped) starts.insert(starts.begin(), variables_.values(exact->dimensions));
    Ends ends(starts.size());
    const double first_done = solvers.size() > 1 ? kFirstSolverDone : 1;
    for (const Solver solver : solvers) {
      const bool is_first = solver == solvers.front();
      run_.enter(Phase::search, is_first ? first_done : 1);
      refine(starts, solver, part_of(run_, is_first ? 0 : first_done, is_first ? first_done : 1),
             ends);
      const bool found = std::ranges::any_of(
          ends, [](const auto& end) { return end && end->violation <= kCamFeasibility; });
      if (found || deadline_.reached()) break;
      starts.resize(std::min(starts.size(), kRetried));
    }
    take_best(ends, exact);
  }

  /// Brings every start to its end, which replaces that of its index where it is better.
  void refine(const std::vector<std::vector<double>>& starts, Solver solver, const Run& run,
              Ends& ends) {
    std::vector<Work> work(starts.size());
    double best = std::numeric_limits<double>::infinity();  // of those of thread 0
    parallel_for(static_cast<int>(starts.size()), run_.threads, [&](int index, int thread) {
      const auto i = static_cast<std::size_t>(index);
      if (index > 0 && deadline_.reached()) return;
      const auto end = search_cam(variables_, starts[i], solver, deadline_, work[i]);
      if (end && (!ends[i] || is_better(*end, *ends[i]))) ends[i] = end;
      if (thread != 0 || !run.progress) return;
      if (ends[i] && ends[i]->violation <= kCamFeasibility) {
        best = std::min(best, ends[i]->objective);
      }
      run.progress(double(i + 1) / double(starts.size()), best);
    });
    add_work(work);
  }

  static std::vector<Solver> solvers_of(Solver choice) {
    if (choice == Solver::automatic) return {Solver::slsqp, Solver::ipopt};
    return {choice};
  }

  void add_work(const std::vector<Work>& parts) {
    result_.work.candidates += parts.size();
    for (const Work& part : parts) {
      result_.work.positions += part.positions;
      result_.work.gradients += part.gradients;
      result_.work.solver_iterations += part.solver_iterations;
    }
  }

  /// The best of different ends, as many as the file asks for.
  void take_best(Ends& ends, const std::optional<ExactCam>& exact) {
    std::erase(ends, std::nullopt);
    std::ranges::stable_sort(ends, [](const auto& a, const auto& b) { return is_better(*a, *b); });
    std::vector<const CamCandidate*> kept;
    for (const auto& end : ends) {
      if (static_cast<int>(kept.size()) == sought_.solve.designs) break;
      if (std::ranges::any_of(kept, [&](const auto* k) { return is_same(*k, *end); })) continue;
      kept.push_back(&*end);
      add(cam_at(variables_, end->x), "search + " + std::string(name(end->solver)), end->x);
      if (exact) tell_proof(*exact);
    }
  }

  bool is_same(const CamCandidate& a, const CamCandidate& b) const {
    constexpr double kSame = 1e-6;
    for (std::size_t i = 0; i < a.x.size(); ++i) {
      const double scale = variables_.variables()[i].scale;
      if (std::abs(a.x[i] - b.x[i]) > kSame * (scale + std::abs(a.x[i]))) return false;
    }
    return true;
  }

  const CamProblem& asked_;
  const cam::MotionProgramme& programme_;
  CamProblem problem_;  ///< with the preload that it needs
  CamProblem sought_;   ///< without a roller whose radius follows from the rest
  CamVariables variables_;
  const Run& run_;
  const Deadline& deadline_;
  CamResult& result_;
};

/// The best cams on the raster, beside the best one without it.
void solve_on_raster(const CamProblem& problem, const cam::MotionProgramme& programme,
                     const Run& run, const Deadline& deadline, CamResult& result) {
  CamProblem free = between_raster_values(problem);
  free.solve.designs = 1;
  CamResult between;
  const Run before = part_of(run, 0, kBetweenValuesDone);
  CamSolver(free, programme, before, deadline, between).solve();
  result.work = between.work;
  const bool is_kept =
      !between.designs.empty() && all_satisfied(between.designs.front().constraints);
  const CamProblem pressed = with_preload(problem, programme);
  run.enter(Phase::raster, kUnknownEnd);
  const CamRasterAnswer answer = search_cam_raster(pressed, programme, run, deadline);
  result.work.candidates += answer.evaluated;
  for (const auto& dimensions : answer.best) {
    result.designs.push_back(
        design_of(problem, cam_of(pressed, programme, dimensions), problem.motion, "raster"));
  }
  const CamDesign* best = is_kept ? &between.designs.front() : nullptr;
  tell_cam_raster(pressed, programme, answer, best, result);
  // A cam that is the smallest between the values bounds those on them.
  if (best != nullptr && !result.designs.empty()) result.designs.front().proof = best->proof;
}

/// `problem` whose operation knows the unit of its lengths.
CamProblem in_unit_of_lengths(CamProblem problem) {
  cam::Operation& operation = problem.operation;
  operation.metres = metres(problem.length_unit);
  operation.displacement = is_oscillating(problem.follower) ? 1 : operation.metres;
  return problem;
}

/// Share of a run, for progress, after which samples are drawn from tolerances.
double found_share(const CamProblem& problem) {
  constexpr double kFound = 0.2;
  return problem.tolerances && problem.tolerances->samples > 0 ? kFound : 1;
}

Status status_of(const CamResult& result, const Deadline& deadline) {
  if (deadline.interrupted()) return Status::interrupted;
  if (deadline.expired()) return Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return all_satisfied(result.designs.front().constraints) ? Status::solved : Status::infeasible;
}

}  // namespace

CamResult solve(const CamProblem& given, const Run& run) {
  const auto valid = KindTraits<CamProblem>::checked(given);
  if (!valid) return refused<CamResult>(valid.error());
  const CamProblem problem = in_unit_of_lengths(*valid);
  const Deadline deadline(run);
  CamResult result;
  for (const auto& segment : problem.motion) {
    result.segments.push_back({peak_factors(segment), cam::handbook_factors(segment.law)});
  }
  const auto programme = programme_of(problem.motion);
  if (!programme) {
    result.notes.emplace_back(
        "A segment of the motion has no solution for its conditions or points.");
    return result;
  }
  const bool still = problem.free_motion.empty();
  const auto impossibility = still ? motion_impossibility(problem, *programme) : std::nullopt;
  const double found = found_share(problem);
  const Run finding = part_of(run, 0, found);
  if (!impossibility) {
    if (problem.raster) {
      solve_on_raster(problem, *programme, finding, deadline, result);
    } else {
      CamSolver(problem, *programme, finding, deadline, result).solve();
    }
  }
  const auto all =
      jumps(result.designs.empty() ? *programme : result.designs.front().cam.programme);
  std::ranges::copy_if(all, std::back_inserter(result.jumps),
                       [](const cam::Jump& jump) { return jump.order > 0; });
  result.status = status_of(result, deadline);
  std::ranges::move(cam_notes(problem, result), std::back_inserter(result.notes));
  if (impossibility) result.notes.insert(result.notes.begin(), *impossibility);
  if (result.status == Status::no_solution && !impossibility && !problem.raster) {
    result.notes.emplace_back(
        "No cam of these lengths can be put together with its follower; wider bounds may help.");
  }
  add_tolerances(problem, part_of(run, found, 1), deadline, result);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
