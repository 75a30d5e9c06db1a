#include "problems/function/robust.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "problems/basics/degrees.hpp"
#include "problems/function/found.hpp"
#include "problems/function/model.hpp"
#include "problems/linkage/linkage_keys.hpp"

namespace cognate::problems {
namespace {

/// A model in which all lengths are variables, those that are given held by bounds, and the problem
/// that it is of, which it refers to.
struct OpenedFunction {
  FunctionProblem problem;
  std::unique_ptr<const FunctionModel> model;
};

/// The model of the form of `minimum`.
std::shared_ptr<const OpenedFunction> opened(const FunctionProblem& confined,
                                             const FunctionSamples& wanted,
                                             const FunctionGenerator& minimum) {
  constexpr double kRoom = 2;  // about a length that is given, so that it can move
  auto made = std::make_shared<OpenedFunction>();
  made->problem = confined;
  for (const LinkKey& key : kLinkKeys) {
    auto& given = made->problem.given.*key.given;
    if (given) made->problem.bounds.*key.bounds = Range{*given / kRoom, *given * kRoom};
    given.reset();
  }
  made->model = std::make_unique<const FunctionModel>(made->problem, wanted, minimum.assembly,
                                                      synthesis::Objective::sum_of_squares);
  return made;
}

std::optional<RobustStart> start_of(const FunctionProblem& problem, const Design& design,
                                    const FunctionGenerator& minimum,
                                    std::shared_ptr<const OpenedFunction> open) {
  RobustStart start;
  start.x = open->model->variables_of(minimum);
  for (const synthesis::Variable& variable : open->model->variables()) {
    start.lower.push_back(variable.lower);
    start.upper.push_back(variable.upper);
  }
  const auto toleranced =
      problems::toleranced(design.mechanism, *problem.tolerances, problem.length_unit);
  if (!toleranced) return std::nullopt;
  for (std::size_t i = 0; i < kLinkKeys.size(); ++i) {
    const LinkKey& key = kLinkKeys[i];
    if (problem.given.*key.given) start.lower[i] = start.upper[i] = start.x[i];
    const auto found =
        std::ranges::find(toleranced->dimensions, key.key, &TolerancedDimension::name);
    if (found == toleranced->dimensions.end()) continue;
    start.dimensions.push_back(*found);
    start.variables.push_back({.variable = static_cast<int>(i), .is_logarithm = true});
  }
  const auto* model = open->model.get();
  start.model = std::shared_ptr<const synthesis::Model>(std::move(open), model);
  return start.dimensions.empty() ? std::nullopt : std::optional(std::move(start));
}

}  // namespace

RobustTask robust_function_task(const FunctionProblem& problem, const FunctionSamples& wanted,
                                const std::vector<FunctionDesign>& minima,
                                const VerifiedFunction& verified) {
  RobustTask task;
  task.share = *problem.solve.robust;
  task.distribution = problem.tolerances->distribution;
  task.components = 1;
  task.unit = degrees(1);
  const ConfinedFunctions confined(problem);
  for (const FunctionDesign& minimum : minima) {
    const auto design = verified(minimum.generator);
    if (!design) continue;
    const FunctionProblem& of = confined.of(minimum.generator.links);
    auto start =
        start_of(problem, *design, minimum.generator, opened(of, wanted, minimum.generator));
    if (start) {
      task.starts.push_back(*std::move(start));
    } else {
      task.lacks_tolerances = true;
    }
  }
  task.design = [&problem, verified](const RobustStart& start,
                                     const std::vector<double>& x) -> std::optional<Design> {
    auto generator = static_cast<const FunctionModel&>(*start.model).generator(x);
    for (const LinkKey& key : kLinkKeys) {
      const auto& given = problem.given.*key.given;
      if (given) generator.links.*key.length = *given;  // without the rounding of the logarithm
    }
    return verified(generator);
  };
  return task;
}

}  // namespace cognate::problems
