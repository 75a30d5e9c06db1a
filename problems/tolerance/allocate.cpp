#include "problems/tolerance/allocate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "analysis/numbers/constants.hpp"
#include "synthesis/tolerance/worst_case.hpp"

namespace cognate::problems {
namespace {

/// What the file calls the dimension `name`: "coupler_point" for "coupler_point.u".
bool is_of_group(std::string_view name, std::string_view group, bool is_pivot) {
  if (group == "pivots") return is_pivot;
  return name == group || (name.starts_with(group) && name.substr(group.size()).starts_with("."));
}

bool is_pivot_coordinate(std::string_view name) {
  return name.ends_with(".x") || name.ends_with(".y");
}

/// Demands of one position for given tolerances.
class Demands {
 public:
  Demands(const ToleranceQuestion& question, std::size_t judged, const SensitivityTable& table,
          double limit, int power)
      : question_(question),
        quantity_(question.quantities[judged]),
        judged_(judged),
        table_(table),
        limit_(limit),
        power_(power) {}

  /// The nominal error at a station, and of a point its direction.
  Vec2d nominal(std::size_t s) const {
    if (!quantity_.is_distance()) {
      return {quantity_.offset.empty() ? 0 : std::abs(quantity_.offset[s]), 0};
    }
    return quantity_.target.empty() ? Vec2d{} : table_.value(s, judged_) - quantity_.target[s];
  }

  double greatest_nominal() const {
    double most = 0;
    for (std::size_t s = 0; s < question_.stations.size(); ++s) {
      most = std::max(most, norm(nominal(s)));
    }
    return most;
  }

  synthesis::ToleranceDemand worst(const std::vector<double>& t) const {
    synthesis::ToleranceDemand worst;
    double most = -1;
    for (std::size_t s = 0; s < question_.stations.size(); ++s) {
      synthesis::ToleranceDemand demand = power_ == 2 ? squared(s) : direct(s, t);
      double spent = 0;
      for (std::size_t i = 0; i < t.size(); ++i) {
        spent += demand.factors[i] * std::pow(t[i], power_);
      }
      if (spent / demand.limit > most) {
        most = spent / demand.limit;
        worst = std::move(demand);
      }
    }
    return worst;
  }

 private:
  synthesis::ToleranceDemand squared(std::size_t s) const {
    synthesis::ToleranceDemand demand;
    for (const Vec2d& rate : table_.rates(s, judged_)) demand.factors.push_back(squared_norm(rate));
    const double left = limit_ - norm(nominal(s));
    demand.limit = left * left;
    return demand;
  }

  /// Along the direction in which the corner of the tolerances lies farthest.
  synthesis::ToleranceDemand direct(std::size_t s, const std::vector<double>& t) const {
    const auto rates = table_.rates(s, judged_);
    const Vec2d base = nominal(s);
    Vec2d along{1, 0};
    if (quantity_.is_distance()) {
      std::vector<Vec2d> arms{base};
      for (std::size_t i = 0; i < t.size(); ++i) arms.push_back(t[i] * rates[i]);
      const Vec2d corner = synthesis::farthest_corner_place(std::move(arms));
      if (norm(corner) > 0) along = (1 / norm(corner)) * corner;
    }
    synthesis::ToleranceDemand demand;
    for (const Vec2d& rate : rates) demand.factors.push_back(std::abs(dot(rate, along)));
    demand.limit = limit_ - std::abs(dot(base, along));
    return demand;
  }

  const ToleranceQuestion& question_;
  const ToleranceQuantity& quantity_;
  std::size_t judged_;
  const SensitivityTable& table_;
  double limit_;
  int power_;
};

std::vector<double> costs_of(const std::vector<TolerancedDimension>& dimensions,
                             const Allocation& allocation) {
  std::vector<double> costs;
  for (const TolerancedDimension& dimension : dimensions) {
    double cost = 1;
    for (const auto& [group, factor] : allocation.costs) {
      if (is_of_group(dimension.name, group, is_pivot_coordinate(dimension.name))) cost = factor;
    }
    costs.push_back(cost);
  }
  return costs;
}

/// That of a length less than nothing would be left.
void note_too_wide(std::span<const TolerancedDimension> dimensions,
                   const std::vector<double>& tolerances, std::vector<std::string>& notes) {
  std::vector<std::string> lost;
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const bool is_finite = std::isfinite(tolerances[i]);
    if (is_finite && dimensions[i].is_length && tolerances[i] >= dimensions[i].nominal) {
      lost.push_back(dimensions[i].name);
    }
  }
  if (lost.empty()) return;
  notes.push_back(fmt::format(
      "The tolerances that tolerance.allocate gives {} are as large as these lengths: its limit is "
      "too wide for figures of first order.",
      fmt::join(lost, ", ")));
}

}  // namespace

void allocate(const AllocatedCosts& to, const WorstDemand& worst, int power,
              ToleranceResult& result) {
  constexpr double kNone = 1e-12;  // of the greatest influence: rounding
  const double greatest = *std::ranges::max_element(to.influence);
  std::vector<std::size_t> held;
  std::vector<double> costs;
  for (std::size_t i = 0; i < to.influence.size(); ++i) {
    if (!(to.influence[i] > kNone * greatest)) continue;
    held.push_back(i);
    costs.push_back(to.costs[i]);
  }
  const auto worst_of_held = [&](const std::vector<double>& t) {
    std::vector<double> all(to.influence.size(), 0.0);
    for (std::size_t h = 0; h < held.size(); ++h) all[held[h]] = t[h];
    synthesis::ToleranceDemand demand = worst(all);
    for (std::size_t h = 0; h < held.size(); ++h) demand.factors[h] = demand.factors[held[h]];
    demand.factors.resize(held.size());
    return demand;
  };
  std::optional<synthesis::LeastCost> cheapest;
  if (!held.empty()) cheapest = synthesis::cheapest_tolerances(costs, worst_of_held, power);
  if (!cheapest) {
    result.notes.emplace_back(
        "No tolerances were allocated: no dimension changes the error at any position.");
    return;
  }
  std::vector<double> tolerances(to.influence.size(), std::numeric_limits<double>::infinity());
  for (std::size_t h = 0; h < held.size(); ++h) tolerances[held[h]] = cheapest->tolerances[h];
  std::vector<std::string> free;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    const std::string& name = to.dimensions[i].name;
    result.allocation.push_back({name, tolerances[i], to.costs[i] / tolerances[i]});
    if (std::isinf(tolerances[i])) free.push_back(name);
  }
  if (!free.empty()) {
    result.notes.push_back(fmt::format(
        "To first order the error does not change with {} at any position: tolerance.allocate "
        "leaves their tolerances open.",
        fmt::join(free, ", ")));
  }
  note_too_wide(to.dimensions, tolerances, result.notes);
  result.allocation_cost = cheapest->cost;
}

void add_allocation(const TolerancedMechanism& toleranced, const Tolerances& tolerances,
                    const ToleranceQuestion& question, std::size_t judged,
                    const SensitivityTable& table, ToleranceResult& result) {
  if (!tolerances.allocation || toleranced.dimensions.empty()) return;
  const Allocation& allocation = *tolerances.allocation;
  const bool angle = is_angular(question.quantities[judged].response.type);
  const double limit = allocation.limit * (angle ? kPi / 180 : 1);
  const int power = allocation.basis == AllocationBasis::rss ? 2 : 1;
  const Demands demands(question, judged, table, limit, power);
  if (!(demands.greatest_nominal() < limit)) {
    result.notes.push_back(fmt::format(
        "No tolerances keep the error within the limit of tolerance.allocate: that of the nominal "
        "design is {:.6g} already.",
        demands.greatest_nominal() * (angle ? 180 / kPi : 1)));
    return;
  }
  AllocatedCosts to{toleranced.dimensions, costs_of(toleranced.dimensions, allocation), {}};
  to.influence.assign(toleranced.dimensions.size(), 0.0);
  for (std::size_t s = 0; s < question.stations.size(); ++s) {
    const auto rates = table.rates(s, judged);
    for (std::size_t i = 0; i < rates.size(); ++i) {
      to.influence[i] = std::max(to.influence[i], norm(rates[i]));
    }
  }
  allocate(
      to, [&](const std::vector<double>& t) { return demands.worst(t); }, power, result);
  if (result.allocation_cost) result.allocation_error = limit;
}

}  // namespace cognate::problems
