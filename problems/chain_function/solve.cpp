/// Functions of chains from problem to designs: search, conversion to the file's units,
/// verification.

#include <algorithm>
#include <cmath>

#include "analysis/numbers/parallel.hpp"
#include "problems/chain/found_designs.hpp"
#include "problems/chain/front/front.hpp"
#include "problems/chain/output/question.hpp"
#include "problems/chain_function/given.hpp"
#include "problems/chain_function/search.hpp"
#include "problems/chain_function/verify.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// Those that meet every limit, the best first; the others only where there are no such.
std::vector<Design> best_designs(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                                 const std::vector<ChainFunctionMinimum>& found) {
  const std::string origin = search_origin(synthesis::Solver::gauss_newton);
  std::vector<Design> designs;
  for (const ChainFunctionMinimum& one : found) {
    const ChainFunctionSpace& space = *one.space;
    auto mechanism = named(*space.topology, space.scale.out_of(space.chain, one.design.chain));
    Design design =
        verified(problem, wanted, *space.topology, std::move(mechanism), one.design.start);
    if (!std::isfinite(design.error.sum_of_squares)) continue;
    design.origin = origin;
    designs.push_back(std::move(design));
  }
  std::ranges::stable_sort(designs, {},
                           [&](const Design& design) { return error_of(problem, design); });
  return feasible_or_all(std::move(designs), problem.solve.designs);
}

/// The structural error at the samples, the start angles being the design's.
std::optional<ToleranceQuestion> function_question(const ChainFunctionProblem& problem,
                                                   const FunctionSamples& wanted,
                                                   const Design& design) {
  const double start = *design.metrics.input_start;
  std::vector<double> angles;
  for (const auto& pair : wanted.samples) angles.push_back(start + pair.input);
  auto asked = slides(problem) ? displacement_question(design.mechanism, problem.output[1], angles)
                               : output_question(design.mechanism, problem.output, angles);
  if (!asked) return std::nullopt;
  const ChainFunctionError error(problem, wanted, design.mechanism, start);
  auto& output = asked->question.quantities.front();
  for (const auto& pair : wanted.samples) output.offset.push_back(error.at(pair));
  add_transmissions(design.mechanism, asked->question);
  return std::move(asked->question);
}

Result find_designs(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                    const std::vector<ChainFunctionSpace>& spaces, const Run& run,
                    const Deadline& deadline) {
  Result result;
  if (is_given(problem)) {
    if (auto design = given_design(problem, wanted)) result.designs.push_back(*std::move(design));
    result.status = status_of(result.designs, deadline);
    return result;
  }
  const auto found = search_chain_functions(spaces, problem.solve, run, deadline, result.work);
  result.quantities = quantities(found.statistics);
  result.designs = best_designs(problem, wanted, found.designs);
  result.status = status_of(result.designs, deadline);
  return result;
}

std::vector<ChainFunctionSpace> spaces_of(const ChainFunctionProblem& problem,
                                          const FunctionSamples& wanted) {
  std::vector<ChainFunctionSpace> spaces;
  for (const Topology& topology : problem.topologies) {
    spaces.emplace_back(problem, topology, wanted);
  }
  return spaces;
}

/// The greatest output wanted from the least.
double travel_of(const FunctionSamples& wanted) {
  const auto [least, greatest] =
      std::ranges::minmax(wanted.samples, {}, &synthesis::AnglePair::output);
  return greatest.output - least.output;
}

ChainFrontProblem front_of_function(const ChainFunctionProblem& problem,
                                    const FunctionSamples& wanted) {
  const ErrorMeasure of = error_measure(problem);
  const double travel = travel_of(wanted);
  const auto error = [&problem](const Design& design) { return error_of(problem, design); };
  const auto solve = [&](const ChainDemand& demand, const Run& run, const Deadline& end) {
    const ChainFunctionProblem one = with_demand(problem, demand);
    return find_designs(one, wanted, spaces_of(one, wanted), run, end);
  };
  return {*problem.against,
          demand_of(problem),
          kMetError * travel,
          travel,
          error_column(of),
          error,
          [of, error](const Design& design) { return shown_error(of, error(design)); },
          solve};
}

}  // namespace

Result solve(const ChainFunctionProblem& given, const Run& run) {
  const auto valid = KindTraits<ChainFunctionProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const ChainFunctionProblem& problem = *valid;
  const Deadline deadline(run);
  const FunctionSamples wanted = function_samples(problem);
  const std::vector<ChainFunctionSpace> spaces = spaces_of(problem, wanted);
  const auto source = is_given(problem) ? DesignSource::exact : DesignSource::search;
  Result result =
      solve_in_layers(problem, run, source, [&](const ChainFunctionProblem& one, const Run& own) {
        return one.against ? chain_front(front_of_function(one, wanted), own, deadline)
                           : find_designs(one, wanted, spaces, own, deadline);
      });
  add_warnings(std::nullopt, problem.warnings, result);
  if (result.designs.empty()) {
    result.notes.emplace_back(
        is_given(problem)
            ? "The mechanism given cannot generate the whole function; change its dimensions."
            : "No mechanism was found that is assembled over the motion within the limits; wider "
              "limits, bounds of lengths and pivots, or more starts may help.");
  }
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) { return function_question(problem, wanted, design); }, result);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
