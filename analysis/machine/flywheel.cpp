#include "analysis/machine/flywheel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/zeros.hpp"

namespace cognate::machine {
namespace {

/// Flywheels are looked for from this part of the approximate one on, doubled so many times.
constexpr double kFirstInertia = 1.0 / 64;
constexpr int kMostInertiaDoublings = 40;
constexpr int kPowerSamples = 720;
/// (ω_max − ω_min)/ω_m of a drive that stops.
constexpr double kComesToRest = 2;

bool runs(const SteadyState& steady) {
  return steady.missing == NoSteadyState::none ||
         (steady.missing == NoSteadyState::any_speed && !steady.states.empty());
}

/// Whether the machine has no steady state because it lacks energy.
bool falls_short(const SteadyState& steady) {
  return steady.missing == NoSteadyState::stands || steady.missing == NoSteadyState::stalls;
}

double mean_inertia(const Machine& machine) {
  double sum = 0;
  for (int i = 0; i < kPowerSamples; ++i) {
    sum += machine.move_to(machine.period * (i + 0.5) / kPowerSamples).value;
  }
  return sum / kPowerSamples;
}

class FlywheelSearch {
 public:
  FlywheelSearch(const std::function<Machine(double)>& machine_with, double wanted,
                 const SteadyGuess& guess, const Accuracy& accuracy)
      : machine_with_(machine_with),
        wanted_(wanted),
        guess_(guess),
        accuracy_(accuracy),
        bare_(machine_with(0)),
        breakpoints_(breakpoints_about(bare_, guess)),
        mean_inertia_(mean_inertia(bare_)) {}

  Flywheel find(int steps) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Flywheel found{.approximate = kNone, .greatest_excess = kNone};
    found.without = with(0, steps);
    if (runs(found.without)) {
      const double mean = mean_speed(found.without);
      found.greatest_excess = greatest_excess_work(bare_, guess_.phi, mean, accuracy_);
      found.approximate =
          std::max(0.0, found.greatest_excess / (mean * mean * wanted_) - mean_inertia_);
    }
    if (const auto inertia = root(found)) {
      found.inertia = *inertia;
      found.steady = *inertia > 0 ? with(*inertia, steps) : found.without;
      found.found = runs(found.steady);
    }
    if (!found.found) found.why = why_;
    return found;
  }

 private:
  SteadyState with(double inertia, int steps) {
    SteadyState steady =
        steady_state(machine_with_(inertia), breakpoints_, guess_, accuracy_, steps);
    why_ = steady.missing;
    return steady;
  }

  /// By how much the fluctuation is beyond the desired one; NaN where it is not known.
  double beyond(const SteadyState& steady) const {
    if (falls_short(steady)) return kComesToRest - wanted_;
    if (!runs(steady)) return std::numeric_limits<double>::quiet_NaN();
    return fluctuation(steady) - wanted_;
  }

  double beyond(double inertia) { return beyond(with(inertia, 1)); }

  std::optional<double> root(const Flywheel& found) {
    double low = 0, at_low = beyond(found.without);
    if (std::isnan(at_low)) return std::nullopt;
    if (at_low <= 0) return 0;
    double high = kFirstInertia * std::fmax(found.approximate, mean_inertia_);
    for (int i = 0; i < kMostInertiaDoublings; ++i, high *= 2) {
      const double at_high = beyond(high);
      if (std::isnan(at_high)) return std::nullopt;
      if (at_high <= 0) return refine(low, at_low, high, at_high);
      low = high;
      at_low = at_high;
    }
    return std::nullopt;
  }

  std::optional<double> refine(double low, double at_low, double high, double at_high) {
    if (at_high == 0) return high;
    const double close = std::max(0.1 * accuracy_.relative, 1e-14);
    bool failed = false;
    const auto f = [&](double inertia) {
      const double value = failed ? 0 : beyond(inertia);
      failed = failed || std::isnan(value);
      return failed ? 0 : value;
    };
    const auto [a, b] = bracket_zero(f, low, at_low, high, at_high, close, 60);
    if (failed) return std::nullopt;
    return b;
  }

  const std::function<Machine(double)>& machine_with_;
  double wanted_;
  SteadyGuess guess_;
  Accuracy accuracy_;
  Machine bare_;
  TorqueBreakpoints breakpoints_;
  double mean_inertia_;
  NoSteadyState why_ = NoSteadyState::none;
};

}  // namespace

Flywheel flywheel_for(const std::function<Machine(double inertia)>& machine_with, double wanted,
                      const SteadyGuess& guess, const Accuracy& accuracy, int steps) {
  return FlywheelSearch(machine_with, wanted, guess, accuracy).find(steps);
}

}  // namespace cognate::machine
