#include <array>
#include <cmath>

#include "analysis/machine/steady_state.hpp"

namespace cognate::machine {
namespace {

/// Places evenly spread over the period, none at its ends.
constexpr int kSamples = 90;

/// The speeds looked at, each so many times the one before.
constexpr double kLeast = 1e-4, kFactor = 1.5;
constexpr std::size_t kSpeeds = 57;
constexpr int kFewSamples = 36;

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
  std::array<double, kSpeeds> speeds{}, sums{};
  for (std::size_t k = 0; k < kSpeeds; ++k) speeds[k] = kLeast * std::pow(kFactor, double(k));
  for (int i = 0; i < kFewSamples; ++i) {
    machine.move_to(machine.period * (i + 0.5) / kFewSamples);
    for (std::size_t k = 0; k < kSpeeds; ++k) sums[k] += machine.torques(speeds[k], 0).sum();
  }
  for (std::size_t k = 1; k < kSpeeds; ++k) {
    if (!(sums[k - 1] > 0 && sums[k] <= 0)) continue;
    const double part = sums[k - 1] / (sums[k - 1] - sums[k]);
    return speeds[k - 1] + part * (speeds[k] - speeds[k - 1]);
  }
  return std::nullopt;
}

}  // namespace cognate::machine
