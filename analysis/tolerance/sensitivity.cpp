#include "analysis/tolerance/sensitivity.hpp"

#include <algorithm>

#include "analysis/tolerance/partials.hpp"

namespace cognate {
namespace {

constexpr std::size_t kAtOnce = 4;
using Number = Partials<double, kAtOnce>;

/// Dimensions `first`… vary, the others stand at their nominal values.
std::vector<Number> varied(std::size_t dimensions, std::size_t first) {
  std::vector<Number> changes(dimensions, Number(0));
  for (std::size_t k = 0; k < kAtOnce && first + k < dimensions; ++k) changes[first + k].by[k] = 1;
  return changes;
}

}  // namespace

SensitivityTable sensitivities(const AffineMechanism& mechanism,
                               std::span<const Response> responses,
                               std::span<const Station> stations) {
  const std::size_t dimensions = mechanism.dimension_count();
  SensitivityTable table(responses.size(), dimensions, stations.size());
  // Values come from the plain numbers: those that carry derivatives leave compensated sums out.
  ChangedMechanism<double> plain(mechanism.nominal());
  for (std::size_t s = 0; s < stations.size(); ++s) {
    plain.move_to(stations[s]);
    for (std::size_t r = 0; r < responses.size(); ++r)
      table.value(s, r) = plain.value(responses[r]);
  }
  for (std::size_t first = 0; first < dimensions; first += kAtOnce) {
    const std::vector<Number> changes = varied(dimensions, first);
    ChangedMechanism<Number> changed(mechanism.at<Number>(changes));
    for (std::size_t s = 0; s < stations.size(); ++s) {
      changed.move_to(stations[s]);
      for (std::size_t r = 0; r < responses.size(); ++r) {
        const Vec2<Number> at = changed.value(responses[r]);
        const auto rates = table.rates(s, r);
        for (std::size_t k = 0; k < std::min(kAtOnce, dimensions - first); ++k) {
          rates[first + k] = deviation_rate<double>(responses[r].type, {at.x.value, at.y.value},
                                                    {at.x.by[k], at.y.by[k]});
        }
      }
    }
  }
  return table;
}

}  // namespace cognate
