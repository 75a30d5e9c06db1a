/// @file The search for generators of functions in a page.
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/report/kernel/sketched.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/search.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::page {
namespace {

using problems::Design;
using problems::FunctionProblem;

/// Pairs of angles that a four-bar comes as near to as can be, with what the file format has for
/// limits; the crank is the unit of length.
std::size_t read_pairs(problems::reading::LinkageTables& tables, FunctionProblem& problem) {
  using namespace problems::reading;
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  require_target(target, "pairs_deg");
  const auto pairs = target.twos("pairs_deg", kAngle, "[input, output]",
                                 {.min = 3, .max = kMostTargets, .of = "pairs"});
  problems::AnglePairs wanted;
  for (const Two& pair : pairs.value_or(std::vector<Two>{})) {
    wanted.emplace_back(radians(pair[0]), radians(pair[1]));
  }
  const std::size_t count = wanted.size();
  problem.target = std::move(wanted);
  problem.given.crank = 1;
  read_link_constraints(constraints, length_limits(problem.given, problem.bounds),
                        problem.constraints);
  problem.solve = read_solve(solve, problem.constraints, false);
  return count;
}

/// Rows of the lengths of crank, coupler, rocker and frame, 1 where the assembly is open, and the
/// start angles of input and output in degrees.
std::vector<Design> read_generators(problems::reading::TableReader& document,
                                    std::size_t /*targets*/) {
  using problems::reading::radians;
  constexpr std::size_t kMost = 20;
  std::vector<Design> known;
  const auto rows =
      document.each_row("known", 7, problems::reading::kNumber,
                        "rows of four lengths, the assembly and two start angles in degrees",
                        {.max = kMost, .of = "designs"});
  for (const auto& row : rows) {
    if (!row) continue;
    const std::vector<double>& v = *row;
    Design design;
    design.mechanism.description = four_bar(problems::FunctionGenerator{
        {v[0], v[1], v[2], v[3]}, v[4] == 1 ? Assembly::open : Assembly::crossed, 0, 0});
    design.metrics.input_start = radians(v[5]);
    design.metrics.output_start = radians(v[6]);
    known.push_back(std::move(design));
  }
  return known;
}

std::vector<Design> solved(const FunctionProblem& problem, const problems::Run& run) {
  const problems::Deadline none(run);
  problems::Work work;
  const problems::FunctionSamples wanted = function_samples(problem);
  std::vector<Design> designs;
  for (const auto& [minimum, from] : search_functions(problem, wanted, run, none, work).minima) {
    Design design =
        function_design(problem, wanted, minimum, positions_of(minimum, wanted.samples), "search");
    if (std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints)) {
      designs.push_back(std::move(design));
    }
  }
  return best_designs(std::move(designs), problem.objective, problem.solve.designs);
}

}  // namespace

nlohmann::ordered_json sketched_functions(const SketchQuestion& question) {
  return answered<FunctionProblem>(
      question, read_pairs,
      [](const auto& problem, const auto& run) { return solved(problem, run); }, read_generators);
}

}  // namespace cognate::page
