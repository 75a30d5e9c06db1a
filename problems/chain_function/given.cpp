#include "problems/chain_function/given.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/chain/crank_angles/starts.hpp"
#include "problems/chain/given.hpp"
#include "problems/chain_function/verify.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kStartsInTurn = 360;
constexpr int kStartsRefined = 4;
constexpr int kStartSteps = 60;

/// More than any error.
constexpr double kBeyondLimits = 1e100;

/// What is minimised, where the crank starts at an angle; infinite where the chain does not close.
class StartError {
 public:
  StartError(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
             const Topology& topology)
      : problem_(problem),
        wanted_(wanted),
        topology_(topology),
        mechanism_(given_mechanism(topology)) {}

  /// From now on by how much the transmission angle is beyond its limits, where it is.
  void limit() { is_limited_ = true; }

  double operator()(double start) const {
    const auto error = function_error(problem_, wanted_, mechanism_, start);
    const double least = problem_.objective == FunctionObjective::minimax ? error.max : error.rms;
    if (!is_limited_ || !std::isfinite(least)) return least;
    const double beyond = beyond_limits(design(start));
    return beyond > 0 ? kBeyondLimits * (1 + beyond) : least;
  }

  const Mechanism<double>& mechanism() const { return mechanism_.mechanism; }

  Design design(double start) const {
    return verified(problem_, wanted_, topology_, mechanism_, start);
  }

  /// By how much, in radians, the transmission angle is; what rounding leaves is not.
  double beyond_limits(const Design& design) const {
    const Range& limit = problem_.constraints.transmission_angle;
    const Metrics& metrics = design.metrics;
    const double most =
        std::max(limit.min - metrics.transmission_min, metrics.transmission_max - limit.max);
    return most <= kCheckTolerance ? 0 : most;
  }

 private:
  const ChainFunctionProblem& problem_;
  const FunctionSamples& wanted_;
  const Topology& topology_;
  NamedMechanism mechanism_;
  bool is_limited_ = false;
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
std::vector<Valley> valleys_of(const StartError& error, const Range& sweep) {
  std::vector<Valley> valleys;
  for (const DriveRange& starts : starts_within_ranges(error.mechanism(), sweep.min, sweep.max)) {
    add_valleys(error, starts, valleys);
  }
  std::ranges::stable_sort(valleys, {}, &Valley::error);
  if (valleys.size() > kStartsRefined) valleys.resize(kStartsRefined);
  return valleys;
}

/// The start of the least error.
std::optional<double> best_start(const StartError& error, const Range& sweep) {
  std::optional<double> best;
  double least = kInfinity;
  for (const auto& [at, starts] : valleys_of(error, sweep)) {
    const auto found = golden_section(error, starts.from, starts.to, kStartSteps);
    // Where it ends beside a limit not all of these are within it.
    for (const double start : {found.middle(), found.from, found.to}) {
      const double here = error(start);
      if (here < least) std::tie(best, least) = std::pair(start, here);
    }
  }
  return best;
}

}  // namespace

bool is_given(const ChainFunctionProblem& problem) {
  return problem.topologies.size() == 1 && is_given(problem.topologies.front());
}

std::optional<Design> given_design(const ChainFunctionProblem& problem,
                                   const FunctionSamples& wanted) {
  StartError error(problem, wanted, problem.topologies.front());
  const auto start = best_start(error, wanted.sweep);
  if (!start) return std::nullopt;
  Design design = error.design(*start);
  if (error.beyond_limits(design) > 0 && problem.constraints.over == LimitSpan::range) {
    error.limit();
    Design within = error.design(best_start(error, wanted.sweep).value_or(*start));
    if (error.beyond_limits(within) == 0) design = std::move(within);
  }
  design.origin = "given";
  return design;
}

}  // namespace cognate::problems
