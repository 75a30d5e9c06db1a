/// Function generation from problem to designs: exact synthesis, or search and verification.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion_within.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/function/certificate.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/error.hpp"
#include "problems/function/exact.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/raster.hpp"
#include "problems/function/robust.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/scatter.hpp"
#include "problems/function/search.hpp"
#include "problems/function/target/jumps.hpp"
#include "problems/linkage/certifying.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/long_links.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/raster/report.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/raster/shared_work.hpp"
#include "problems/search/infeasibility.hpp"
#include "problems/search/objectives.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

/// A transmission angle nearer to 0 or 180° than this, in radians, is that of a dead point.
inline constexpr double kDeadTransmission = 1e-3;

constexpr int kIntervals = 1000;  ///< in which a function is searched for jumps

/// min(μ, π − μ) at a crank angle.
double acute_transmission(const Design& design, double angle) {
  if (const auto* slider = std::get_if<SliderCrank>(&design.mechanism.description)) {
    return kRightAngle - std::abs(pressure_angle(*slider, angle).value_or(kRightAngle));
  }
  return transmission_angles(lengths(four_bar(design)), {angle, angle}).acute_min;
}

/// The first input of the motion, from its start, at a dead point: at its ends, or where the
/// transmission angle is extreme. Empty where there is none, or no such motion.
std::optional<double> dead_input(const Design& design, const Range& sweep) {
  const bool slider = std::holds_alternative<SliderCrank>(design.mechanism.description);
  const auto ranges = slider ? crank_ranges(std::get<SliderCrank>(design.mechanism.description))
                             : crank_ranges(lengths(four_bar(design)));
  const double start = *design.metrics.input_start, first = slider ? kRightAngle : 0;
  const double from = start + sweep.min, to = start + sweep.max;
  if (!motion_within(ranges, {from, to})) return std::nullopt;
  std::vector<double> angles{from};
  for (double k = std::ceil((from - first) / kPi); first + k * kPi < to; ++k) {
    angles.push_back(first + k * kPi);
  }
  angles.push_back(to);
  for (const double angle : angles) {
    if (acute_transmission(design, angle) <= kDeadTransmission) return angle - start;
  }
  return std::nullopt;
}

/// On a table or list of pairs that scatters.
std::optional<std::string> scatter_note(const FunctionProblem& problem) {
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  const auto share = function ? scatter_share(function->table)
                              : scatter_share(std::get<AnglePairs>(problem.target));
  if (!share) return std::nullopt;
  const std::string scatter = fmt::format(
      "The target scatters about a smooth curve by {:.2g} % of its range, as measured values do",
      100 * *share);
  if (problem.objective == FunctionObjective::least_squares) {
    return scatter + ": errors of that size are its own, and the design follows the curve.";
  }
  return scatter +
         ": objective = \"least-squares\" averages it, this objective follows single values.";
}

/// Adds sentences on the designs of `result`, in the order in which they stand there, that pass or
/// reach a dead point or a change point, on a function that jumps within its domain, and on pairs
/// that scatter.
void note_motions(const FunctionProblem& problem, const FunctionSamples& wanted, Result& result) {
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const auto input = dead_input(result.designs[i], wanted.sweep);
    if (!input) continue;
    result.notes.push_back(fmt::format(
        "Design {}: the transmission angle is 0 or 180 degrees at an input of {:.4g} degrees, a "
        "dead point or change point within the motion: the output may lock there or go on in the "
        "other assembly.",
        i + 1, degrees(*input)));
  }
  if (const auto note = scatter_note(problem)) result.notes.push_back(*note);
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  if (!function || function->text.empty()) return;
  const auto jumps = reading::find_jumps(function->y, function->domain, kIntervals);
  if (jumps.empty()) return;
  result.notes.push_back(
      fmt::format("The function jumps at x = {:.6g}: no linkage follows it there, and the maximum "
                  "error is at least half of the jump.",
                  jumps.front()));
}

Status status(const Result& result, const Deadline& deadline, bool ended_early) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  const auto& constraints = result.designs.front().constraints;
  const bool sound = std::all_of(constraints.begin(), constraints.end(),
                                 [](const ConstraintCheck& check) { return check.satisfied; });
  return sound ? Status::solved : Status::infeasible;
}

/// Where a design came from, then the solvers that refined it.
std::string origin(StartOrigin start, synthesis::Solver finisher) {
  const std::string refined = search_origin(finisher).substr(std::string_view("search").size());
  switch (start) {
    case StartOrigin::overlay:
      return "exact:overlay" + refined;
    case StartOrigin::five_points:
      return "exact:freudenstein-5" + refined;
    case StartOrigin::search:
      break;
  }
  return "search" + refined;
}

Result solve_by_search(const FunctionProblem& problem, const Run& run, const Deadline& deadline) {
  Result result;
  const FunctionSamples wanted = function_samples(problem);
  const auto found = search_functions(problem, wanted, run, deadline, result.work);
  result.quantities = quantities(found.statistics);
  const bool ended_early = deadline.reached();
  std::vector<Design> designs;
  for (const auto& [minimum, from] : found.minima) {
    Design design = function_design(problem, wanted, minimum, positions_of(minimum, wanted.samples),
                                    origin(from, finisher_of(problem)));
    check_error(problem, design);
    if (std::isfinite(design.error.sum_of_squares)) designs.push_back(std::move(design));
  }
  // By a loss the search knows which is best; the design's own error is that of least squares.
  const bool by_loss = problem.solve.loss != synthesis::Loss::none;
  result.designs =
      best_designs(std::move(designs), by_loss ? std::nullopt : std::optional(problem.objective),
                   problem.solve.designs);
  result.status = status(result, deadline, ended_early);
  if (result.status == Status::no_solution) {
    result.notes.push_back(
        "No four-bar was found that closes over the whole range; wider bounds, free start angles "
        "or more starts may help.");
  }
  return result;
}

/// The continuous optimum and other minima, then the raster.
Result solve_on_raster(const FunctionProblem& problem, const Run& run, const Deadline& deadline) {
  Result result;
  const FunctionSamples wanted = function_samples(problem);
  FunctionProblem with_more = problem;
  with_more.solve.designs = std::max(problem.solve.designs, kMinima);
  const auto continuous =
      search_functions(with_more, wanted, between_values(run), deadline, result.work);
  SharedWork shared(result.work);
  const auto search_given = [&](const FunctionProblem& given) {
    return shared.counted([&](Work& work) {
      return search_functions(given, wanted, of_one_combination(run), deadline, work).minima;
    });
  };
  const auto design_of = [&](const FunctionGenerator& generator) {
    Design design = function_design(problem, wanted, generator,
                                    positions_of(generator, wanted.samples), "raster");
    check_error(problem, design);
    return design;
  };
  const auto accepts = [&](const FunctionGenerator& generator) {
    const Design design = design_of(generator);
    return std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
  };
  const auto found = search_function_raster(problem, wanted, continuous.minima, accepts,
                                            search_given, on_values(run), deadline);
  for (const FunctionGenerator& one : found.designs) result.designs.push_back(design_of(one));
  result.quantities = quantities(continuous.statistics);
  const auto error = [&](double objective) {
    const bool is_minimax = problem.objective == FunctionObjective::minimax;
    return degrees(is_minimax ? objective : std::sqrt(objective / double(wanted.samples.size())));
  };
  std::ranges::move(raster_quantities(found.search, error), std::back_inserter(result.quantities));
  result.notes = raster_notes(found.search, error);
  result.status = status(result, deadline, deadline.reached());
  return result;
}

/// The nominal optimum and other minima, and from these the designs whose quantile is least.
Result solve_robustly(const FunctionProblem& problem, const Run& run, const Deadline& deadline) {
  Result result;
  run.enter(Phase::search, kStartsDone);
  const FunctionSamples wanted = function_samples(problem);
  FunctionProblem with_more = problem;
  with_more.solve.designs = std::max(problem.solve.designs, kMinima);
  auto nominal =
      search_functions(with_more, wanted, part_of(run, 0, kNominalDone), deadline, result.work);
  if (const auto limits = with_good_transmission(problem.constraints)) {
    FunctionProblem other = with_more;
    other.constraints = *limits;
    auto more = search_functions(other, wanted, part_of(run, kNominalDone, kStartsDone), deadline,
                                 result.work);
    std::ranges::move(more.minima, std::back_inserter(nominal.minima));
  }
  const auto verified = [&](const FunctionGenerator& generator) -> std::optional<Design> {
    Design design = function_design(problem, wanted, generator,
                                    positions_of(generator, wanted.samples), "robust");
    check_error(problem, design);
    const bool is_met =
        std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
    return is_met ? std::optional(std::move(design)) : std::nullopt;
  };
  RobustTask task = robust_function_task(problem, wanted, nominal.minima, verified);
  task.error = [&](const Design& design) { return degrees(error_of(problem, design)); };
  result.quantities = quantities(nominal.statistics);
  add_robust(task, robust_designs(task, part_of(run, kStartsDone, 1), deadline), true, result);
  result.status = status(result, deadline, deadline.reached());
  return result;
}

void add_certificate(const FunctionProblem& problem, const Run& run, const Deadline& deadline,
                     Result& result) {
  if (result.status != Status::solved) {
    result.notes.emplace_back(kNothingToCertify);
    return;
  }
  const double best = result.designs.front().error.sum_of_squares;
  result.certificate = certify(problem, function_samples(problem), best, run, deadline);
}

/// The error of the output at the samples, start angles being those of the design.
std::optional<ToleranceQuestion> function_question(const FunctionProblem& problem,
                                                   const Design& design) {
  if (!design.metrics.input_start || !design.metrics.output_start) return std::nullopt;
  const NamedMechanism& mechanism = design.mechanism;
  const FourBar* linkage = mechanism.four_bar();
  const auto* slider = std::get_if<SliderCrank>(&mechanism.description);
  if (!linkage && !slider) return std::nullopt;
  const double zero = linkage ? frame_angle(*linkage) : angle_of(slider->direction);
  const FunctionSamples wanted = function_samples(problem);
  std::vector<double> angles;
  for (const auto& pair : wanted.samples) {
    angles.push_back(zero + *design.metrics.input_start + pair.input);
  }
  auto [question, kept] = question_at(mechanism, angles);
  question.left_out = angles.size() - kept.size();
  ToleranceQuantity error{.name = "error",
                          .response = travel_response(mechanism.mechanism, mechanism.output),
                          .judged = true};
  ChangedMechanism<double> nominal({mechanism.mechanism, {}});
  for (std::size_t s = 0; s < kept.size(); ++s) {
    nominal.move_to(question.stations[s]);
    const Vec2d value = nominal.value(error.response);
    const double output = *design.metrics.output_start + wanted.samples[kept[s]].output;
    error.offset.push_back(linkage ? std::remainder(angle_of(value) - zero - output, kTurn)
                                   : value.x - output);
  }
  question.quantities.push_back(std::move(error));
  add_transmissions(mechanism, question);
  return std::move(question);
}

void add_function_tolerances(const FunctionProblem& problem, const Run& run, Result& result) {
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) { return function_question(problem, design); }, result);
}

}  // namespace

Result solve(const FunctionProblem& given, const Run& run) {
  const auto valid = KindTraits<FunctionProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const FunctionProblem problem = in_joules(*valid);
  const Deadline deadline(run);
  const bool exact = problem.objective == FunctionObjective::exact;
  const auto solve_one = [&](const FunctionProblem& one, const Run& own) {
    return solve_by_search(one, own, deadline);
  };
  const Run unseen = silent(run);
  const auto solve_as_asked = [&](const FunctionProblem& asked, const Run& own) {
    if (exact) return solve_exactly(asked, deadline);
    if (asked.raster) return solve_on_raster(asked, own, deadline);
    if (asked.solve.robust) return solve_robustly(asked, own, deadline);
    Result found = solve_objectives(asked, own, deadline, solve_one);
    const auto solve_once = [&](const FunctionProblem& other) { return solve_one(other, unseen); };
    add_infeasibility(asked, own, deadline, solve_once, found);
    return found;
  };
  Result result =
      solve_in_layers(problem, before_certificate(run, problem.solve),
                      exact ? DesignSource::exact : DesignSource::search, solve_as_asked);
  if (!exact && !problem.raster && !problem.solve.robust) {
    if (problem.solve.certify) add_certificate(problem, run, deadline, result);
    merge_long_links(result);
  }
  note_motions(problem, function_samples(problem), result);
  mark_twins(result.designs);
  add_warnings(std::nullopt, problem.warnings, result);
  add_function_tolerances(problem, run, result);
  note_units(problem.constraints.operation, problem.length_unit, result);
  result.work.skipped = skipped_evaluations(problem.constraints);
  if (exact) result.work.skipped.insert(result.work.skipped.begin(), {"search", "gradients"});
  result.work.threads = exact ? 1 : thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
