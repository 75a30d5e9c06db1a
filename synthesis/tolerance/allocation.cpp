#include "synthesis/tolerance/allocation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cognate::synthesis {
namespace {

constexpr int kMostSteps = 2000, kMostExchanges = 400;
constexpr double kDualTolerance = 1e-14, kMet = 1e-10;

/// t for the multipliers: tᵢ = (kᵢ/(p wᵢ))^(1/(p+1)), w = Σ λ a. Of a dimension without weight
/// none.
class Dual {
 public:
  Dual(const std::vector<double>& costs, const std::vector<ToleranceDemand>& demands, int power)
      : costs_(costs), demands_(demands), power_(power) {}

  std::vector<double> tolerances(const std::vector<double>& multipliers) const {
    std::vector<double> t(costs_.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
      double weight = 0;
      for (std::size_t m = 0; m < demands_.size(); ++m) {
        weight += multipliers[m] * demands_[m].factors[i];
      }
      t[i] = std::pow(costs_[i] / (power_ * weight), 1.0 / (power_ + 1));
    }
    return t;
  }

  double spent(std::size_t m, const std::vector<double>& t) const {
    double sum = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      sum += demands_[m].factors[i] * std::pow(t[i], power_);
    }
    return sum;
  }

  double cost(const std::vector<double>& t) const {
    double sum = 0;
    for (std::size_t i = 0; i < t.size(); ++i) sum += costs_[i] / t[i];
    return sum;
  }

  /// The Lagrangian at its least: a lower bound of the cost.
  double bound(const std::vector<double>& multipliers) const {
    const auto t = tolerances(multipliers);
    double value = cost(t);
    for (std::size_t m = 0; m < demands_.size(); ++m) {
      value += multipliers[m] * (spent(m, t) - demands_[m].limit);
    }
    return value;
  }

  /// The factor by which t must be multiplied to meet every demand.
  double fitting(const std::vector<double>& t) const {
    double most = 0;
    for (std::size_t m = 0; m < demands_.size(); ++m) {
      most = std::max(most, spent(m, t) / demands_[m].limit);
    }
    return std::pow(most, -1.0 / power_);
  }

 private:
  const std::vector<double>& costs_;
  const std::vector<ToleranceDemand>& demands_;
  int power_;
};

}  // namespace

std::optional<LeastCost> cheapest_tolerances(const std::vector<double>& costs,
                                             const std::vector<ToleranceDemand>& demands,
                                             int power) {
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const bool limited = std::ranges::any_of(
        demands, [&](const ToleranceDemand& demand) { return demand.factors[i] > 0; });
    if (!limited) return std::nullopt;
  }
  const Dual dual(costs, demands, power);
  // Multiplicative ascent: λ grows by the share of its demand that is spent. One demand: t scales
  // as λ^(−1/(p+1)), so that the exponent (p+1)/p meets it at once; with several it is damped.
  std::vector<double> multipliers(demands.size(), 1.0 / static_cast<double>(demands.size()));
  const double scale = std::pow(dual.fitting(dual.tolerances(multipliers)), -(power + 1.0));
  for (double& multiplier : multipliers) multiplier *= scale;
  const double exponent = demands.size() == 1 ? (power + 1.0) / power : 1.0;
  LeastCost best{{}, std::numeric_limits<double>::infinity(), 0};
  for (int step = 0; step < kMostSteps; ++step) {
    std::vector<double> t = dual.tolerances(multipliers);
    best.bound = std::max(best.bound, dual.bound(multipliers));
    const double factor = dual.fitting(t);
    std::vector<double> fitted = t;
    for (double& one : fitted) one *= factor;
    const double cost = dual.cost(fitted);
    if (cost < best.cost) {
      best.cost = cost;
      best.tolerances = std::move(fitted);
    }
    if (best.cost - best.bound <= kDualTolerance * best.cost) break;
    for (std::size_t m = 0; m < multipliers.size(); ++m) {
      multipliers[m] *= std::pow(dual.spent(m, t) / demands[m].limit, exponent);
    }
  }
  return best;
}

std::optional<LeastCost> cheapest_tolerances(
    const std::vector<double>& costs,
    const std::function<ToleranceDemand(const std::vector<double>&)>& worst, int power) {
  std::vector<ToleranceDemand> demands{worst(std::vector<double>(costs.size(), 1.0))};
  std::optional<LeastCost> best;
  for (int exchange = 0; exchange < kMostExchanges; ++exchange) {
    // A dimension that no demand holds yet is held by that which is worst where it alone is large.
    std::vector<double> t;
    best = cheapest_tolerances(costs, demands, power);
    if (best) {
      t = best->tolerances;
    } else {
      t.assign(costs.size(), 1.0);
      for (std::size_t i = 0; i < costs.size(); ++i) {
        const bool held = std::ranges::any_of(
            demands, [&](const ToleranceDemand& demand) { return demand.factors[i] > 0; });
        if (!held) {
          t[i] = 1e6;
          break;
        }
      }
    }
    ToleranceDemand next = worst(t);
    double spent = 0;
    for (std::size_t i = 0; i < t.size(); ++i) spent += next.factors[i] * std::pow(t[i], power);
    const bool met = spent <= next.limit * (1 + kMet);
    if (best && met) {
      if (spent > next.limit) {
        const double factor = std::pow(next.limit / spent, 1.0 / power);
        for (double& one : best->tolerances) one *= factor;
        best->cost /= factor;
      }
      return best;
    }
    if (!best) {
      const bool holds =
          std::ranges::any_of(next.factors, [](double factor) { return factor > 0; });
      if (!holds) return std::nullopt;
      if (exchange > static_cast<int>(2 * costs.size())) return std::nullopt;
    }
    demands.push_back(std::move(next));
  }
  return best;
}

}  // namespace cognate::synthesis
