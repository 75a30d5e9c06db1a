#include "analysis/machine/time_limits.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace cognate::machine {
namespace {

/// How often torques that depend on time are looked at in advance, from how many places.
constexpr std::size_t kTimes = 4096;
constexpr int kPlaces = 3;

}  // namespace

StepLimits limits_in_time(const Machine& machine, const MachineState& from, double duration) {
  StepLimits limits(from.time, duration, kTimes);
  const std::vector<int> one_stretch(kTimes);
  std::vector<double> values(kTimes);
  for (int place = 0; place < kPlaces; ++place) {
    machine.move_to(machine.period * (place + 0.5) / kPlaces);
    double sum = 0;
    for (std::size_t i = 0; i < kTimes; ++i) {
      const double speed = from.omega != 0 ? from.omega : std::numeric_limits<double>::min();
      const Torques acting = machine.torques(speed, limits.place(i));
      values[i] = acting.sum();
      sum += std::abs(acting.motor) + std::abs(acting.load);
    }
    limits.shorten(values, one_stretch, sum / static_cast<double>(kTimes));
  }
  return limits;
}

}  // namespace cognate::machine
