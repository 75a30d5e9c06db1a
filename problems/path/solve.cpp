/// Path generation from problem to designs: search, conversion to the file's units, verification.

#include "problems/path/exact/solve.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/linkage/certifying.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/long_links.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/designs.hpp"
#include "problems/path/narrowed_limits.hpp"
#include "problems/path/problem.hpp"
#include "problems/path/raster.hpp"
#include "problems/path/scale.hpp"
#include "problems/path/search.hpp"
#include "problems/path/shape_placement.hpp"
#include "problems/raster/report.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/raster/shared_work.hpp"
#include "problems/search/infeasibility.hpp"
#include "problems/search/objectives.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

constexpr double kDefaultTolerance = 1e-13;
Status status(const Deadline& deadline, bool ended_early, const PathDesigns& designs, bool any) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (!any) return Status::no_solution;
  return designs.any_feasible() ? Status::solved : Status::infeasible;
}

Result solve_by_search(const PathProblem& problem, const Run& run, const Deadline& deadline) {
  const PathProblem searched = normalised(problem);
  const PathScale scale(searched);
  const PathProblem scaled = scale.into(searched);
  const synthesis::Solver solver = synthesis::chosen(problem.solve.solver);
  Result result;
  Run scaled_run = run;
  for (Design& design : scaled_run.known) {
    design.mechanism.description = scale.into(four_bar(design));
  }
  const auto search = [&](const PathProblem& one, const Run& own) {
    return search_paths(one, solver, problem.solve.tolerance.value_or(kDefaultTolerance), own,
                        deadline, result.work);
  };
  const PathSearchResult found = search(scaled, scaled_run);
  const bool ended_early = deadline.reached();
  PathDesigns designs(problem, scale.size);
  const auto add = [&](const PathProblem& of, const PathSearchResult& minima) {
    for (const PathMinimum& minimum : minima.minima) {
      const PathModel model = model_of(of, minimum);
      std::vector<double> angles = model.crank_angles(minimum.solution.x);
      for (double& angle : angles) angle = in_one_turn(angle);
      designs.add(scale.out_of(model.linkage(minimum.solution.x)), angles,
                  search_origin(solver, minimum.from_exact ? "exact:nine-point" : "search"));
    }
  };
  add(scaled, found);
  const bool counts_squares = problem.solve.loss == synthesis::Loss::none;
  if (!ended_early && counts_squares && !is_movable(problem)) {
    for (const Design& exceeding : designs.better_but_violating()) {
      const auto narrower = narrowed(scaled, scale, exceeding, run);
      if (narrower) add(narrower->problem, search(narrower->problem, narrower->run));
    }
    designs.sort();
  }
  result.status = status(deadline, ended_early, designs, !found.minima.empty());
  result.designs = designs.take();
  result.quantities = quantities(found.statistics);
  if (result.status == Status::no_solution) {
    result.notes.push_back(
        "No four-bar was found that closes at every target point; wider bounds or more starts may "
        "help.");
  }
  return result;
}

/// The continuous optimum and other minima, then the raster.
Result solve_on_raster(const PathProblem& problem, const Run& run, const Deadline& deadline) {
  const PathScale scale(problem);
  PathProblem scaled = scale.into(problem);
  scaled.solve.designs = std::max(scaled.solve.designs, kMinima);
  Result result;
  const auto search = [&](const PathProblem& one, const Run& own, Work& work) {
    return search_paths(one, synthesis::chosen(problem.solve.solver),
                        problem.solve.tolerance.value_or(kDefaultTolerance), own, deadline, work);
  };
  const PathSearchResult continuous = search(scaled, between_values(run), result.work);
  SharedWork shared(result.work);
  const auto search_given = [&](const PathProblem& given) {
    return shared.counted(
        [&](Work& work) { return search(given, of_one_combination(run), work).minima; });
  };
  PathDesigns designs(problem, scale.size);
  const auto accepts = [&](const RasterPath& design) {
    return designs.accepted(design.linkage, design.crank_angles).has_value();
  };
  const RasterPathResult found = search_path_raster(
      problem, scaled, scale, continuous.minima, accepts, search_given, on_values(run), deadline);
  for (const RasterPath& one : found.designs) {
    std::vector<double> angles = one.crank_angles;
    for (double& angle : angles) angle = in_one_turn(angle);
    designs.add_alone(one.linkage, angles);
  }
  result.status = status(deadline, deadline.reached(), designs, !found.designs.empty());
  result.designs = designs.take();
  result.quantities = quantities(continuous.statistics);
  const auto error = [&](double objective) { return scale.size * rms_of(problem, objective); };
  std::ranges::move(raster_quantities(found.search, error), std::back_inserter(result.quantities));
  result.notes = raster_notes(found.search, error);
  return result;
}

/// The nominal optimum and other minima, and from these the designs whose quantile is least.
Result solve_robustly(const PathProblem& problem, const Run& run, const Deadline& deadline) {
  const PathScale scale(problem);
  PathProblem scaled = scale.into(problem);
  scaled.solve.designs = std::max(scaled.solve.designs, kMinima);
  Result result;
  run.enter(Phase::search, kStartsDone);
  const auto search = [&](const PathProblem& one, const Run& part) {
    return search_paths(one, synthesis::chosen(problem.solve.solver),
                        problem.solve.tolerance.value_or(kDefaultTolerance), part, deadline,
                        result.work);
  };
  PathSearchResult nominal = search(scaled, part_of(run, 0, kNominalDone));
  if (const auto limits = with_good_transmission(scaled.constraints)) {
    PathProblem other = scaled;
    other.constraints = *limits;
    std::ranges::move(search(other, part_of(run, kNominalDone, kStartsDone)).minima,
                      std::back_inserter(nominal.minima));
  }
  const PathDesigns designs(problem, scale.size);
  RobustTask task = robust_path_task(problem, scaled, scale, nominal.minima,
                                     [&](const FourBar& linkage, std::vector<double> crank_angles) {
                                       for (double& angle : crank_angles)
                                         angle = in_one_turn(angle);
                                       auto design = designs.accepted(linkage, crank_angles);
                                       if (design) design->origin = "robust";
                                       return design;
                                     });
  task.error = [&](const Design& design) { return error_of(problem, design); };
  result.quantities = quantities(nominal.statistics);
  add_robust(task, robust_designs(task, part_of(run, kStartsDone, 1), deadline), false, result);
  if (deadline.reached()) {
    result.status = deadline.interrupted() ? Status::interrupted : Status::time_limit;
  } else if (!result.designs.empty()) {
    result.status = Status::solved;
  }
  return result;
}

void add_certificate(const PathProblem& problem, const Run& run, const Deadline& deadline,
                     Result& result) {
  if (result.status != Status::solved) {
    result.notes.emplace_back(kNothingToCertify);
    return;
  }
  double best = std::numeric_limits<double>::infinity();
  for (const Design& design : result.designs) {
    best = std::min(best, path_objective(problem, design));
  }
  result.certificate = certify(problem, best, run, deadline);
}

/// A point whose crank angle is free may be met a little before or after. Where only some are
/// prescribed, all keep the angles of the nominal design.
void add_path_tolerances(const PathProblem& problem, const Run& run, Result& result) {
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) {
        std::vector<Vec2d> targets;
        for (const Vec2d& point : problem.points) {
          targets.push_back(design.placement.value_or(CurvePlacement{}).point(point));
        }
        return error_at_targets(design.mechanism, "P", design.crank_angles, targets,
                                problem.timing != Timing::free);
      },
      result);
}

}  // namespace

Result solve(const PathProblem& given, const Run& run) {
  const auto valid = KindTraits<PathProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const PathProblem problem = in_joules(*valid);
  if (problem.method == PathMethod::exact) {
    Result exact = solve_in_layers(problem, run, DesignSource::exact, solve_exactly);
    mark_twins(exact.designs);
    add_warnings(extent_of(problem.points), problem.warnings, exact);
    add_path_tolerances(problem, run, exact);
    return exact;
  }
  const Deadline deadline(run);
  const auto finish = [&](Result& result) {
    mark_twins(result.designs);
    add_warnings(extent_of(problem.points), problem.warnings, result);
    note_units(problem.constraints.operation, problem.length_unit, result);
    if (problem.curve) {
      result.quantities.push_back({"target_length", problem.curve->curve.length()});
    }
    result.work.skipped = skipped_evaluations(problem.constraints);
    result.work.threads = thread_count(run.threads);
    result.work.seconds = deadline.spent();
  };
  if (problem.raster || problem.solve.robust) {
    Result result = solve_in_layers(problem, run, DesignSource::search,
                                    [&](const PathProblem& one, const Run& own) {
                                      return problem.raster ? solve_on_raster(one, own, deadline)
                                                            : solve_robustly(one, own, deadline);
                                    });
    add_path_tolerances(problem, run, result);
    finish(result);
    return result;
  }
  const auto search = [&](const PathProblem& one, const Run& own) {
    return solve_by_search(one, own, deadline);
  };
  const Run unseen = silent(run);
  Result result =
      solve_in_layers(problem, before_certificate(run, problem.solve), DesignSource::search,
                      [&](const PathProblem& one, const Run& own) {
                        Result found = solve_objectives(one, own, deadline, search);
                        add_infeasibility(
                            one, own, deadline,
                            [&](const PathProblem& other) { return search(other, unseen); }, found);
                        return found;
                      });
  if (problem.solve.certify) add_certificate(problem, run, deadline, result);
  merge_long_links(result);
  add_path_tolerances(problem, run, result);
  finish(result);
  return result;
}

}  // namespace cognate::problems
