#include "problems/chain_function/given.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/chain/crank_starts.hpp"
#include "problems/chain/given.hpp"
#include "problems/chain_function/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kStartsInTurn = 360;
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

/// Starts about one from which the error grows to either side.
struct Valley {
  double error = 0;  ///< there
  DriveRange starts;
};

void add_valleys(const StartError& error, const DriveRange& starts, std::vector<Valley>& valleys) {
  const std::vector<double> places = spread_over(starts, kStartsInTurn);
  const bool turns = is_whole_turn(starts);
  const auto count = static_cast<std::ptrdiff_t>(places.size());
  const double part = (starts.to - starts.from) / double(count);
  std::vector<double> at;
  for (const double place : places) at.push_back(error(place));
  const auto beside = [&](std::ptrdiff_t i) {
    const bool outside = i < 0 || i >= count;
    return outside && !turns ? kInfinity : at[static_cast<std::size_t>((i + count) % count)];
  };
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const double here = beside(i), place = places[static_cast<std::size_t>(i)];
    if (!std::isfinite(here) || here > beside(i - 1) || here > beside(i + 1)) continue;
    const DriveRange about{place - part, place + part};
    valleys.push_back({here, turns ? about
                                   : DriveRange{std::max(about.from, starts.from),
                                                std::min(about.to, starts.to)}});
  }
}

/// The deepest of those from which the chain generates the whole function.
std::vector<Valley> valleys_of(const StartError& error, const Mechanism<double>& mechanism,
                               const Range& sweep) {
  std::vector<Valley> valleys;
  for (const DriveRange& starts : starts_within_ranges(mechanism, sweep.min, sweep.max)) {
    add_valleys(error, starts, valleys);
  }
  std::ranges::stable_sort(valleys, {}, &Valley::error);
  if (valleys.size() > kStartsRefined) valleys.resize(kStartsRefined);
  return valleys;
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
  double start = 0, least = kInfinity;
  for (const auto& [at, starts] : valleys_of(error, mechanism.mechanism, wanted.sweep)) {
    const auto found = golden_section(error, starts.from, starts.to, kStartSteps);
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
