#include "problems/linkage/cycle/mean_torque.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/cycle/cycle_energy.hpp"

namespace cognate::problems {
namespace {

constexpr int kParts = 48;

struct SquaredTorque {
  const Operation& operation;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    const T torque = driving_torque(of, at, operation);
    return torque * torque;
  }
};

/// The ends of the parts of the turn, by crank angles from the frame.
std::vector<double> part_ends(const Operation& operation, const CycleTable& table) {
  std::vector<double> ends;
  for (int k = 0; k <= kParts; ++k) ends.push_back(kTurn * k / kParts);
  const bool cut = std::ranges::any_of(
      operation.loads, [](const WorkingLoad& load) { return load.sense != LoadSense::always; });
  if (!cut) return ends;
  const auto [outer, inner] = turning_points(table.links(), table.assembly());
  for (const Vec2d& half : {outer, inner}) {
    const double angle = angle_of_half(half);
    if (angle > 0 && angle < kTurn) ends.push_back(angle);
  }
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

DimensionJet mean_square_torque(const Operation& operation, const CycleTable& table) {
  using Rule = boost::math::quadrature::gauss<double, 5>;
  const SquaredTorque square{operation};
  const auto at = [&](double angle) {
    return table.value(square, {std::cos(0.5 * angle), std::sin(0.5 * angle)});
  };
  const std::vector<double> ends = part_ends(operation, table);
  DimensionJet sum(0.);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = 0.5 * (ends[i] + ends[i + 1]), half = 0.5 * (ends[i + 1] - ends[i]);
    sum += half * Rule::weights()[0] * at(middle);
    for (std::size_t k = 1; k < Rule::abscissa().size(); ++k) {
      const double reach = half * Rule::abscissa()[k];
      sum += half * Rule::weights()[k] * (at(middle - reach) + at(middle + reach));
    }
  }
  return sum / kTurn;
}

}  // namespace cognate::problems
