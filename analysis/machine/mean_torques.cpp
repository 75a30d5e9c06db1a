#include <cmath>

#include "analysis/machine/steady_state.hpp"
#include "analysis/mechanism/zeros.hpp"

namespace cognate::machine {
namespace {

constexpr int kSamples = 90;

/// Calls `take` with the torques at places evenly spread over the period, none at its ends.
template <class Take>
void sample(const Machine& machine, double omega, double time, Take&& take) {
  for (int i = 0; i < kSamples; ++i) {
    machine.move_to(machine.period * (i + 0.5) / kSamples);
    take(machine.torques(omega, time));
  }
}

double mean_torque(const Machine& machine, double omega) {
  double sum = 0;
  sample(machine, omega, 0, [&](const Torques& acting) { sum += acting.sum(); });
  return sum / kSamples;
}

}  // namespace

double turnover(const Machine& machine, double omega, double time) {
  double sum = 0;
  sample(machine, omega, time,
         [&](const Torques& acting) { sum += std::abs(acting.motor) + std::abs(acting.load); });
  return sum / kSamples * machine.period;
}

std::optional<double> speed_of_mean_torques(const Machine& machine) {
  constexpr double kLeast = 1e-4, kMost = 1e6, kFactor = 1.25;
  const auto f = [&](double omega) { return mean_torque(machine, omega); };
  double before = f(kLeast);
  for (double omega = kLeast; omega < kMost; omega *= kFactor) {
    const double next = kFactor * omega;
    const double after = f(next);
    if (before > 0 && after <= 0) {
      return after < 0 ? bracket_zero(f, omega, before, next, after).first : next;
    }
    before = after;
  }
  return std::nullopt;
}

}  // namespace cognate::machine
