/// Path generation from problem to designs: search, conversion to the file's units, verification.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>

#include "analysis/linkage/cognates.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/certifying.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/long_links.hpp"
#include "problems/linkage/placement.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/same_design.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/crank_sense.hpp"
#include "problems/path/curve_following.hpp"
#include "problems/path/exact.hpp"
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

/// The root of the mean square of which an objective of the search is the weighted sum.
double rms_of(const PathProblem& problem, double sum_of_squares) {
  const auto& weights = problem.weights;
  const double total = weights.empty() ? static_cast<double>(problem.points.size())
                                       : std::accumulate(weights.begin(), weights.end(), 0.0);
  return std::sqrt(sum_of_squares / total);
}

}  // namespace

// What error_limit.hpp and objectives.hpp ask of a kind, found by the type of its problem.

/// What the error of a problem is: the root mean square distance,
/// squares by their weights. A smaller one means a smaller objective.
ErrorMeasure error_measure(const PathProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

/// That error of a design, a length.
double error_of(const PathProblem& problem, const Design& design) {
  return rms_of(problem, path_objective(problem, design));
}

/// Errors up to this are rounding: the target is met.
double met_error(const PathProblem& problem) {
  return kMetError * PathScale(problem).size;
}

namespace {

constexpr double kDefaultTolerance = 1e-13;
/// Designs closer than this, relative to their size, are one: no use is made of a thousandth.
constexpr double kSameWithin = 1e-3;

class Designs {
 public:
  /// `size`: of the path, in the file's unit.
  Designs(const PathProblem& problem, double size)
      : problem_(problem), exact_below_(kMetExactly * size * size) {}

  /// Adds the design and its timed cognate, unless they are known.
  void add(const FourBar& linkage, const std::vector<double>& crank_angles, std::string origin) {
    origin_ = std::move(origin);
    if (!add_one(linkage, crank_angles)) return;
    const auto cognate = timed_cognate(linkage);
    if (!cognate) return;
    const double turned = frame_angle(*cognate) - frame_angle(linkage);
    const bool from_x_axis =
        problem_.timing != Timing::free && problem_.crank_reference == CrankReference::global;
    const double whole_turn = kTurn;
    if (from_x_axis && std::abs(std::remainder(turned, whole_turn)) > kCheckTolerance) return;
    std::vector<double> angles = crank_angles;
    for (double& angle : angles) angle = in_one_turn(angle + turned);
    Design design = verified(*cognate, angles);
    if (all_satisfied(design.constraints)) insert(std::move(design));
  }

  /// Adds a design that is on the raster, where its cognates are not.
  void add_alone(const FourBar& linkage, const std::vector<double>& crank_angles) {
    origin_ = "raster";
    add_one(linkage, crank_angles);
  }

  /// A design that meets every constraint; empty where one does not.
  std::optional<Design> accepted(const FourBar& linkage,
                                 const std::vector<double>& crank_angles) const {
    Design design = verified(linkage, crank_angles);
    const bool is_met =
        std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
    return is_met ? std::optional(std::move(design)) : std::nullopt;
  }

  bool enough() const {
    return feasible_.size() >= static_cast<std::size_t>(problem_.solve.designs);
  }
  bool any_feasible() const { return !feasible_.empty(); }
  /// By their errors.
  void sort() {
    std::ranges::stable_sort(feasible_, {},
                             [this](const Design& design) { return objective(design); });
  }

  /// Those that break a constraint and are better than any that does not, best first.
  std::vector<Design> better_but_violating() const {
    double least = kInfinity;
    for (const Design& design : feasible_) least = std::min(least, objective(design));
    std::vector<Design> better;
    std::ranges::copy_if(violating_, std::back_inserter(better),
                         [&](const Design& design) { return objective(design) < least; });
    std::ranges::stable_sort(better, {}, [this](const Design& one) { return objective(one); });
    return better;
  }

  /// The best designs, with cognates named: feasible ones if there are any. Among those that meet
  /// the points to rounding the better transmission angle comes first.
  std::vector<Design> take() {
    const auto wanted = static_cast<std::size_t>(problem_.solve.designs);
    std::vector<Design> all = std::move(feasible_.empty() ? violating_ : feasible_);
    const auto exact = std::stable_partition(all.begin(), all.end(), [&](const Design& design) {
      return design.error.sum_of_squares <= exact_below_;
    });
    std::stable_sort(all.begin(), exact, [](const Design& a, const Design& b) {
      return a.metrics.transmission_acute_min > b.metrics.transmission_acute_min;
    });
    if (all.size() > wanted) all.resize(wanted);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < i && !all[i].cognate_of; ++k) {
        if (is_cognate(four_bar(all[k]), four_bar(all[i]), kSameWithin)) {
          all[i].cognate_of = static_cast<int>(k);
        }
      }
    }
    return all;
  }

 private:
  double objective(const Design& design) const { return path_objective(problem_, design); }

  /// `linkage` as it was found, where the target is.
  Design verified(const FourBar& linkage, const std::vector<double>& crank_angles) const {
    Design design = is_movable(problem_) ? moved(linkage, crank_angles)
                                         : verified(linkage, problem_.points, crank_angles);
    if (problem_.curve) judge_following(design);
    return design;
  }

  /// With the target moved to where the file's lengths and pivots want it.
  Design moved(const FourBar& linkage, const std::vector<double>& crank_angles) const {
    const CurvePlacement placement = placement_of(problem_, linkage);
    std::vector<Vec2d> targets;
    for (const Vec2d& point : problem_.points) targets.push_back(placement.point(point));
    std::vector<double> angles = crank_angles;
    for (double& angle : angles) angle = in_one_turn(angle + placement.turn);
    Design design = verified(placed(problem_, linkage, placement), targets, angles);
    design.error = path_error(linkage, problem_.points, crank_angles);
    design.placement = placement;
    design.metrics.quantities = quantities(placement);
    return design;
  }

  void judge_following(Design& design) const {
    const ClosedCurve& curve = problem_.curve->curve;
    const double deviation =
        curve_deviation(curve, four_bar(design), design.placement.value_or(CurvePlacement{}));
    design.metrics.quantities.push_back({"curve_deviation_max", deviation});
    if (!problem_.constraints.no_extra_loop) return;
    design.constraints.push_back(check_extra_loop(curve, deviation, design.error.max));
  }

  Design verified(const FourBar& linkage, std::span<const Vec2d> targets,
                  const std::vector<double>& crank_angles) const {
    Design design;
    design.mechanism = named(linkage);
    design.crank_angles = crank_angles;
    design.error = path_error(linkage, targets, crank_angles);
    design.metrics = design_metrics(linkage, crank_angles,
                                    {problem_.order, problem_.timing == Timing::prescribed});
    add_cycle_metrics(problem_.constraints, linkage, CycleOutput::coupler_point, design.metrics);
    design.constraints = check_constraints(problem_.constraints, problem_.bounds, problem_.given,
                                           linkage, design.metrics);
    if (problem_.crank_sense != CrankSense::either && leaves_sense_open(problem_)) {
      design.constraints.push_back(check_sense(problem_.crank_sense, crank_angles));
    }
    check_error(problem_, design);
    design.origin = origin_;
    return design;
  }

  bool add_one(const FourBar& linkage, const std::vector<double>& crank_angles) {
    return insert(verified(linkage, crank_angles));
  }

  /// Keeps the design in its list unless an equal one is there, or it does not close at a point: so
  /// may a cognate near a dead point, where rounding decides.
  bool insert(Design design) {
    if (!std::isfinite(design.error.sum_of_squares)) return false;
    auto& list = all_satisfied(design.constraints) ? feasible_ : violating_;
    for (const Design& known : list) {
      if (same_design(four_bar(known), four_bar(design), kSameWithin)) return false;
    }
    list.push_back(std::move(design));
    return true;
  }

  const PathProblem& problem_;
  double exact_below_;
  std::string origin_;  ///< of the designs that are being added
  std::vector<Design> feasible_, violating_;
};

Status status(const Deadline& deadline, bool ended_early, const Designs& designs, bool any) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (!any) return Status::no_solution;
  return designs.any_feasible() ? Status::solved : Status::infeasible;
}

/// The limits of the transmission angle less what a design exceeds them by, and half of that again;
/// empty where it breaks another constraint, or these by more than three degrees.
std::optional<Range> narrowed_limits(const PathProblem& problem, const Design& design) {
  constexpr double kMost = 3 * kDegree, kMore = 1.5;
  const auto& limits = problem.constraints.transmission_angle;
  const bool is_alone = std::ranges::all_of(design.constraints, [](const ConstraintCheck& check) {
    return check.satisfied || check.name == "transmission_angle_deg";
  });
  if (!limits || !is_alone) return std::nullopt;
  const double below = std::max(0.0, limits->min - design.metrics.transmission_min);
  const double above = std::max(0.0, design.metrics.transmission_max - limits->max);
  if (!(std::max(below, above) <= kMost)) return std::nullopt;
  const Range narrowed{limits->min + kMore * below, limits->max - kMore * above};
  return narrowed.min < narrowed.max ? std::optional(narrowed) : std::nullopt;
}

/// Whoever places points that are not timed may take the crank a little beyond where the search has
/// the limits of the transmission angle: from designs that exceed them by little, within limits
/// narrowed by that. `scaled` is `problem` by `scale`; `add` takes what is found.
void search_within_narrower_limits(
    const PathProblem& problem, const PathProblem& scaled, const PathScale& scale,
    const std::vector<Design>& exceeding,
    const std::function<PathSearchResult(const PathProblem&, Run)>& search,
    const std::function<void(const PathProblem&, const PathSearchResult&)>& add, const Run& run) {
  for (const Design& design : exceeding) {
    const auto limits = narrowed_limits(problem, design);
    if (!limits) continue;
    PathProblem narrow = scaled;
    narrow.constraints.transmission_angle = limits;
    narrow.solve.starts = 0;
    Run own = silent(run);
    own.known = {design};
    own.known.front().mechanism.description = scale.into(four_bar(design));
    add(narrow, search(narrow, own));
  }
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
  Designs designs(problem, scale.size);
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
    search_within_narrower_limits(problem, scaled, scale, designs.better_but_violating(), search,
                                  add, run);
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
  Designs designs(problem, scale.size);
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
  const Designs designs(problem, scale.size);
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
