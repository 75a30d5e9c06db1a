/// @file Machines of formulas and tables, for tests.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "analysis/machine/machine.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::test {

using InertiaLaw = std::function<machine::EquivalentInertia(double phi)>;
using TorqueLaw = std::function<machine::Torques(double phi, double omega, double time)>;

/// A machine of period 2π.
inline machine::Machine machine_of(InertiaLaw inertia, TorqueLaw torques,
                                   std::vector<double> breaks = {}) {
  auto at = std::make_shared<double>(0);
  return {.move_to =
              [at, inertia = std::move(inertia)](double phi) {
                *at = phi;
                return inertia(phi);
              },
          .torques = [at, torques = std::move(torques)](
                         double omega, double time) { return torques(*at, omega, time); },
          .period = kTurn,
          .breaks = std::move(breaks)};
}

inline InertiaLaw constant_inertia(double inertia) {
  return [inertia](double) { return machine::EquivalentInertia{inertia, 0}; };
}

/// Values evenly spread over a turn from 0, with straight lines between them.
struct PeriodicTable {
  std::vector<double> values;

  double step() const { return kTurn / static_cast<double>(values.size()); }

  double at(double phi) const {
    const auto [low, high, part] = rows(phi);
    return low + part * (high - low);
  }
  double slope(double phi) const {
    const auto [low, high, part] = rows(phi);
    return (high - low) / step();
  }
  std::vector<double> breaks() const {
    std::vector<double> breaks;
    for (std::size_t i = 0; i < values.size(); ++i) breaks.push_back(double(i) * step());
    return breaks;
  }

 private:
  struct Rows {
    double low, high, part;
  };
  Rows rows(double phi) const {
    const double place = phi / step();
    const auto row = static_cast<std::size_t>(std::floor(place));
    return {values[row % values.size()], values[(row + 1) % values.size()],
            place - std::floor(place)};
  }
};

}  // namespace cognate::test
