#include "problems/chain_function/given.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/chain/given.hpp"
#include "problems/chain_function/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kStartsTried = 360;
constexpr double kBetweenStarts = kTurn / kStartsTried;
constexpr int kStartsRefined = 4;
constexpr int kStartSteps = 60;

/// What is minimised, where the crank starts at an angle; infinite where the chain does not close.
class StartError {
 public:
  StartError(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
             const NamedMechanism& mechanism)
      : problem_(problem), wanted_(wanted), mechanism_(mechanism) {}

  double operator()(double start) const {
    const auto error = function_error(problem_, wanted_, mechanism_, start);
    return problem_.objective == FunctionObjective::minimax ? error.max : error.rms;
  }

 private:
  const ChainFunctionProblem& problem_;
  const FunctionSamples& wanted_;
  const NamedMechanism& mechanism_;
};

/// The starts tried from which the error grows to either side, the best first.
std::vector<double> valleys(const StartError& error) {
  std::vector<double> at;
  for (int i = 0; i < kStartsTried; ++i) at.push_back(error(kBetweenStarts * i));
  std::vector<int> found;
  for (int i = 0; i < kStartsTried; ++i) {
    const auto here = at[static_cast<std::size_t>(i)];
    const auto before = at[static_cast<std::size_t>((i + kStartsTried - 1) % kStartsTried)];
    const auto after = at[static_cast<std::size_t>((i + 1) % kStartsTried)];
    if (std::isfinite(here) && here <= before && here <= after) found.push_back(i);
  }
  std::ranges::stable_sort(found, {}, [&](int i) { return at[static_cast<std::size_t>(i)]; });
  if (found.size() > kStartsRefined) found.resize(kStartsRefined);
  std::vector<double> starts;
  for (const int i : found) starts.push_back(kBetweenStarts * i);
  return starts;
}

}  // namespace

bool is_given(const ChainFunctionProblem& problem) {
  return problem.topologies.size() == 1 && is_given(problem.topologies.front());
}

std::optional<Design> given_design(const ChainFunctionProblem& problem,
                                   const FunctionSamples& wanted) {
  const Topology& topology = problem.topologies.front();
  const NamedMechanism mechanism = given_mechanism(topology);
  const StartError error(problem, wanted, mechanism);
  double start = 0, least = std::numeric_limits<double>::infinity();
  for (const double valley : valleys(error)) {
    const auto found =
        golden_section(error, valley - kBetweenStarts, valley + kBetweenStarts, kStartSteps);
    const double middle = found.middle();
    const double here = error(middle);
    if (here < least) std::tie(start, least) = std::pair(middle, here);
  }
  if (!std::isfinite(least)) return std::nullopt;
  Design design = verified(problem, wanted, topology, mechanism, start);
  design.origin = "given";
  return design;
}

}  // namespace cognate::problems
