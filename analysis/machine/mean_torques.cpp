#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/machine/steady_state.hpp"

namespace cognate::machine {
namespace {

/// Places evenly spread over the period, none at its ends.
constexpr int kSamples = 90;

/// Speeds to look at: `count` from `least` on, each `factor` times the one before.
struct Speeds {
  double least, factor;
  std::size_t count;
};
/// Those of most machines, closely; then all that may be meant by a number.
constexpr std::array<Speeds, 2> kSpeeds{{{1e-4, 1.5, 57}, {1e-30, 4, 101}}};
constexpr int kFewSamples = 36;

std::optional<double> balance(const Machine& machine, const Speeds& range) {
  std::vector<double> speeds(range.count), sums(range.count);
  for (std::size_t k = 0; k < range.count; ++k) {
    speeds[k] = range.least * std::pow(range.factor, double(k));
  }
  for (int i = 0; i < kFewSamples; ++i) {
    machine.move_to(machine.period * (i + 0.5) / kFewSamples);
    for (std::size_t k = 0; k < range.count; ++k) sums[k] += machine.torques(speeds[k], 0).sum();
  }
  for (std::size_t k = 1; k < range.count; ++k) {
    if (!(sums[k - 1] > 0 && sums[k] <= 0)) continue;
    const double part = sums[k - 1] / (sums[k - 1] - sums[k]);
    return speeds[k - 1] + part * (speeds[k] - speeds[k - 1]);
  }
  return std::nullopt;
}

}  // namespace

double turnover(const Machine& machine, double omega, double time) {
  constexpr std::array<double, 3> kFactors{0.8, 1, 1.25};
  std::array<double, kFactors.size()> sums{};
  for (int i = 0; i < kSamples; ++i) {
    machine.move_to(machine.period * (i + 0.5) / kSamples);
    for (std::size_t k = 0; k < kFactors.size(); ++k) {
      const Torques acting = machine.torques(kFactors[k] * omega, time);
      sums[k] += std::abs(acting.motor) + std::abs(acting.load);
    }
  }
  double greatest = 0;
  for (const double sum : sums) greatest = std::fmax(greatest, sum);  // passes over what is NaN
  return greatest / kSamples * machine.period;
}

std::optional<double> speed_of_mean_torques(const Machine& machine) {
  for (const Speeds& range : kSpeeds) {
    if (const auto speed = balance(machine, range)) return speed;
  }
  return std::nullopt;
}

TorqueBreakpoints breakpoints_about(const Machine& machine, const SteadyGuess& guess) {
  TorqueBreakpoints breakpoints(machine);
  const double speed = guess.speed ? *guess.speed : speed_of_mean_torques(machine).value_or(1);
  const std::array<double, 3> speeds{0.2 * speed, speed, 3 * speed};
  breakpoints.look(machine, speeds);
  return breakpoints;
}

bool depends_on_speed(const Machine& machine, double omega) {
  constexpr double kRounding = 1e-12;
  for (int i = 0; i < kSamples; ++i) {
    machine.move_to(machine.period * (i + 0.5) / kSamples);
    const Torques at = machine.torques(omega, 0);
    for (const double factor : {0.25, 2.0, 16.0}) {
      const Torques other = machine.torques(factor * omega, 0);
      const auto differ = [](double a, double b) {
        return std::abs(a - b) > kRounding * std::max(std::abs(a), std::abs(b));
      };
      if (differ(at.motor, other.motor) || differ(at.load, other.load)) return true;
    }
  }
  return false;
}

}  // namespace cognate::machine
