#include <algorithm>
#include <limits>

#include "analysis/linkage/mobility.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/found.hpp"
#include "problems/function/model.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/starts.hpp"
#include "problems/linkage/verify.hpp"
#include "synthesis/optimise/solver.hpp"
#include "tests/bench/work_precision/contest.hpp"

namespace cognate::bench {
namespace {

using problems::FunctionModel;
using problems::FunctionObjective;
using problems::FunctionProblem;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kReach = 3;  ///< radians, and logarithms of lengths
/// Starts that one draw of screened ones makes ready.
constexpr int kBatch = 32;

double error_of(const problems::Design& design, FunctionObjective objective) {
  if (!problems::all_satisfied(design.constraints)) return kNone;
  return objective == FunctionObjective::minimax ? design.error.max : design.error.sum_of_squares;
}

struct Function {
  FunctionProblem problem;
  problems::ConfinedFunctions confined;
  problems::FunctionSamples wanted;
  std::vector<problems::FunctionStartPoint> ready;  ///< screened starts not yet given out

  explicit Function(const FunctionProblem& own)
      : problem(own), confined(own), wanted(problems::function_samples(own)) {
    // The largest error is one over the whole domain.
    if (problem.objective == FunctionObjective::minimax) wanted.samples = wanted.range;
  }

  /// Of a problem of `confined`.
  std::shared_ptr<const FunctionModel> model(Assembly assembly, const FunctionProblem& own) const {
    const auto objective = problem.objective == FunctionObjective::minimax
                               ? synthesis::Objective::max_abs
                               : synthesis::Objective::sum_of_squares;
    return std::make_shared<FunctionModel>(own, wanted, assembly, objective);
  }
};

std::optional<Attempt> draw(const std::shared_ptr<Function>& function, Starts how,
                            std::mt19937_64& random) {
  std::shared_ptr<const FunctionModel> model;
  std::optional<std::vector<double>> x;
  if (how == Starts::screened) {
    auto& ready = function->ready;
    if (ready.empty()) {
      ready = find_starts(function->problem, function->wanted, {.seed = random(), .count = kBatch})
                  .starts;
      std::ranges::reverse(ready);
    }
    if (ready.empty()) return std::nullopt;
    const auto generator = ready.back().generator;
    ready.pop_back();
    model = function->model(generator.assembly, function->confined.of(generator.links));
    x = model->variables_of(generator);
  } else {
    model =
        function->model(random() % 2 == 0 ? Assembly::open : Assembly::crossed, function->problem);
    x = random_point(*model, kReach, random);
    if (!x) return std::nullopt;
  }
  const auto error = [function, model](std::span<const double> at) {
    const auto generator = model->generator(at);
    const auto design =
        function_design(function->problem, function->wanted, generator,
                        problems::positions_of(generator, function->wanted.samples), "");
    return error_of(design, function->problem.objective);
  };
  return Attempt{model, std::move(*x), error};
}

}  // namespace

Contest function_contest(const FunctionProblem& problem, std::string name) {
  Contest contest;
  contest.name = std::move(name);
  const bool minimax = problem.objective == FunctionObjective::minimax;
  contest.kind = minimax ? "function, minimax" : "function";
  contest.begin = [problem](Starts how) -> Draw {
    const auto function = std::make_shared<Function>(problem);
    return [function, how](std::mt19937_64& random) { return draw(function, how, random); };
  };
  contest.solve = [problem](int starts, const problems::Run& run) {
    FunctionProblem asked = problem;
    asked.solve.starts = starts;
    const auto result = solve(asked, run);
    if (result.status != problems::Status::solved) return kNone;
    return error_of(result.designs.front(), asked.objective);
  };
  return contest;
}

}  // namespace cognate::bench
