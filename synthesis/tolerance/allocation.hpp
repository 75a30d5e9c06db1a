/// @file Tolerances of least cost.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace cognate::synthesis {

/// A demand on tolerances tᵢ > 0: Σ aᵢ tᵢᵖ ≤ b, with aᵢ ≥ 0 and b > 0.
struct ToleranceDemand {
  std::vector<double> factors;
  double limit = 0;
};

/// The least cost and where it is reached.
struct LeastCost {
  std::vector<double> tolerances;
  double cost = 0;
  /// Demands λ-weighted: no tolerances that meet the demands cost less (weak duality).
  double bound = 0;
};

/// Minimises Σ kᵢ/tᵢ under `demands`, p being `power` (1: sums of deviations, 2: of their squares).
/// Convex in log t; for one demand tᵢ = (kᵢ/(λ p aᵢ))^(1/(p+1)) in closed form. Empty where a
/// dimension with a cost has no demand, so that its tolerance has no end.
std::optional<LeastCost> cheapest_tolerances(const std::vector<double>& costs,
                                             const std::vector<ToleranceDemand>& demands,
                                             int power);

/// The same under demands without number: `worst(t)` gives the demand that is missed most by t, or
/// is nearest to it. Demands are exchanged until none is missed by more than rounding.
std::optional<LeastCost> cheapest_tolerances(
    const std::vector<double>& costs,
    const std::function<ToleranceDemand(const std::vector<double>&)>& worst, int power);

}  // namespace cognate::synthesis
