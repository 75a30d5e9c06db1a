#include "problems/machine/vanishing_inertia.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

constexpr int kSamples = 360;
/// Of J ~ c (φ − φ₀)² a step away this is left where φ₀ is met to 1e-6 of the step.
constexpr double kNothing = 1e-12;

}  // namespace

std::optional<double> vanishing_inertia(const machine::Machine& machine) {
  constexpr double kUnknown = std::numeric_limits<double>::max();
  const auto inertia = [&](double phi) {
    const double value = machine.move_to(in_period(phi, machine.period)).value;
    return std::isfinite(value) ? value : kUnknown;
  };
  const double step = machine.period / kSamples;
  double least = kUnknown, at = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double value = inertia(i * step);
    if (value >= least) continue;
    least = value;
    at = i * step;
  }
  // In steps from `at`, whose own size would blur a place far from 0.
  const auto beside = [&](double steps) { return inertia(at + steps * step); };
  const auto [place, value] = boost::math::tools::brent_find_minima(beside, -1.0, 1.0, 30);
  double around = 0;
  for (const double side : {beside(place - 1), beside(place + 1)}) {
    if (side < kUnknown) around = std::max(around, side);
  }
  if (std::min(value, least) > kNothing * around) return std::nullopt;
  constexpr double kClose = 1e-6;
  const double phi = value < least ? at + place * step : at;
  return std::abs(std::remainder(phi, kTurn)) < kClose ? 0 : in_one_turn(phi);
}

}  // namespace cognate::problems
