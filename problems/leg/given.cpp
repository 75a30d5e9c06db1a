#include "problems/leg/given.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/zeros.hpp"
#include "problems/chain/given.hpp"
#include "problems/leg/model.hpp"
#include "problems/leg/verify.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr double kDutyStep = 0.02;    ///< between duty factors that are tried
constexpr double kSameDuty = 1e-10;   ///< relative
constexpr double kSameStride = 1e-6;  ///< relative

/// Duty factors to be tried, the greatest first.
std::vector<double> tried_duties(double least) {
  std::vector<double> duties;
  for (int i = 0; kMostDuty - i * kDutyStep > least; ++i)
    duties.push_back(kMostDuty - i * kDutyStep);
  duties.push_back(least);
  return duties;
}

/// Those at which the leg has the stride specified, the greatest first.
std::vector<double> duties_of_stride(const LegProblem& problem, const NamedMechanism& leg) {
  const auto excess = [&](double duty) {
    const auto gait = foot_gait(problem.topologies.front(), leg, duty);
    return gait ? gait->stride - problem.target.stride : std::numeric_limits<double>::quiet_NaN();
  };
  const auto tried = tried_duties(problem.target.duty);
  std::vector<double> found;
  double above = excess(tried.front());
  for (std::size_t i = 1; i < tried.size(); ++i) {
    const double below = excess(tried[i]);
    if (below == 0) found.push_back(tried[i]);
    if (below * above < 0) {
      const auto ends = bracket_zero(excess, tried[i], below, tried[i - 1], above, kSameDuty);
      const double duty = better_end(excess, ends);
      // Where the stance leaps to another part of the path, so does the stride.
      const bool is_met = std::abs(excess(duty)) <= kSameStride * problem.target.stride;
      if (is_met) found.push_back(duty);
    }
    above = below;
  }
  return found;
}

/// Of the stances of the stride specified the longest within the limits.
std::optional<Design> longest_stance(const LegProblem& problem, const NamedMechanism& leg) {
  std::optional<Design> longest;
  for (const double duty : duties_of_stride(problem, leg)) {
    Design design = verified(problem, problem.topologies.front(), leg, duty);
    if (all_satisfied(design.constraints)) return design;
    if (!longest) longest = std::move(design);
  }
  return longest;
}

}  // namespace

bool is_given(const LegProblem& problem) {
  return problem.topologies.size() == 1 && is_given(problem.topologies.front());
}

std::optional<Design> given_design(const LegProblem& problem) {
  const Topology& topology = problem.topologies.front();
  const NamedMechanism leg = given_mechanism(topology);
  const bool is_longest = problem.target.objective == LegObjective::duty;
  std::optional<Design> design = is_longest ? longest_stance(problem, leg) : std::nullopt;
  if (!design) design = verified(problem, topology, leg, problem.target.duty);
  if (!std::isfinite(design->error.max)) return std::nullopt;
  design->origin = "given";
  return design;
}

}  // namespace cognate::problems
