#include "analysis/machine/steady_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/machine/run.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::machine {
namespace {

/// How often K is doubled where the drive stops from below.
constexpr int kMostDoublings = 30;
/// What counts as nothing, in tolerances and parts of what is worked in a period; and where the
/// fixed point is met.
constexpr double kNothing = 100, kMet = 0.1;
/// Motions of so many times the energy or work first looked at are on their way to infinity.
constexpr double kFar = 1e15;
/// A search whose errors were held against so many times the work there is at the speed found is
/// made again from there, so many times.
constexpr double kCoarse = 10;
constexpr int kSearches = 20;
/// Where two integrations of a period differ by more, in parts of what is worked, they are made
/// again with steps of at most these parts of the period.
constexpr double kSound = 1e-6;
/// Where K grows or shrinks by a period, not by how much matters.
constexpr double kSameSense = 0.05;
constexpr std::array<double, 3> kShorter{1.0 / 256, 1.0 / 2048, 1.0 / 16384};
/// The loosest tolerance: a little more saves little time, and blurs what is nothing.
constexpr double kLoosest = 1e-8;

/// K at the beginning of a period, and what it grows by in it.
struct Shot {
  double kinetic = 0;
  double growth = 0;
};

class Shooting {
 public:
  Shooting(const Machine& machine, const TorqueBreakpoints& breakpoints, const SteadyGuess& guess,
           const Accuracy& accuracy)
      : machine_(machine),
        breakpoints_(breakpoints),
        accuracy_(at_most_loose(accuracy)),
        guess_(guess),
        speed_(guess.speed ? *guess.speed : speed_of_mean_torques(machine).value_or(1)),
        inertia_(machine.move_to(guess.phi).value),
        work_(turnover(machine, speed_)),
        cycle_(machine, breakpoints, guess.phi, work_ > 0 ? work_ : 1, accuracy_) {}

  /// Whether errors were held against far more than is worked at the speed that was found.
  bool was_coarse(const SteadyState& found) const {
    return !found.states.empty() &&
           kCoarse * turnover(machine_, found.states.front().omega) < work_;
  }

  SteadyState find(int steps) {
    if (machine_.depends_on_time) return missing(NoSteadyState::depends_on_time);
    const double start = 0.5 * inertia_ * speed_ * speed_;
    if (!std::isfinite(start) || !std::isfinite(work_)) return missing(NoSteadyState::open);
    if (!shoot(start)) return missing(failure_);
    const Shot first = shot_;
    if (std::abs(first.growth) <= nothing() && is_any_speed(first))
      return of_any_speed(start, steps);
    const bool found = first.growth == 0  ? settle(first)
                       : first.growth > 0 ? climb(first)
                                          : descend(first) || leap(first);
    if (!found && is_about_works()) return missing_for_sure(failure_);
    return found ? finish(steps) : missing(failure_);
  }

 private:
  static Accuracy at_most_loose(Accuracy accuracy) {
    accuracy.relative = std::min(accuracy.relative, kLoosest);
    return accuracy;
  }

  /// What errors and differences are measured by.
  double size() const { return std::max(cycle_.scale(), cycle_.range()); }
  double nothing() const { return kNothing * accuracy_.relative * size(); }

  SteadyState missing(NoSteadyState why) {
    steady_.missing = why;
    steady_.surplus = shot_.growth;
    return std::move(steady_);
  }

  /// The same where other steps agree with what the last shot said.
  SteadyState missing_for_sure(NoSteadyState why) {
    ++steady_.integrations;
    const bool whole = cycle_.check(shot_.kinetic) == CycleEnd::whole;
    const double change = std::abs(cycle_.growth() - shot_.growth);
    const bool agree = change <= kSound * size() || change <= kSameSense * std::abs(shot_.growth);
    return missing(whole && agree ? why : NoSteadyState::unsure);
  }

  static NoSteadyState reason(CycleEnd end) {
    if (end == CycleEnd::open) return NoSteadyState::open;
    return end == CycleEnd::stopped ? NoSteadyState::stopped : NoSteadyState::gave_up;
  }

  /// Integrates a period from `kinetic`; false, with `failure_`, where that is not possible.
  bool shoot(double kinetic) {
    ++steady_.integrations;
    const CycleEnd end = cycle_.run(kinetic);
    if (end != CycleEnd::whole) {
      failure_ = reason(end);
      return false;
    }
    shot_ = {kinetic, cycle_.growth()};
    return true;
  }

  bool is_about_works() const {
    return failure_ == NoSteadyState::stalls || failure_ == NoSteadyState::stands ||
           failure_ == NoSteadyState::runs_away;
  }

  SteadyState of_any_speed(double kinetic, int steps) {
    if (!shoot(kinetic)) return missing(failure_);
    if (!guess_.speed) return missing_for_sure(NoSteadyState::any_speed);
    if (cycle_.stands()) return missing_for_sure(NoSteadyState::stands);
    return record(kinetic, steps, NoSteadyState::any_speed);
  }

  /// K neither grows nor shrinks at this speed; whether that is so at others too.
  bool is_any_speed(const Shot& first) {
    if (depends_on_speed(machine_, speed_)) return false;
    for (const double factor : {4.0, 1.5}) {
      if (!shoot(factor * first.kinetic) || std::abs(shot_.growth) > nothing()) return false;
    }
    return true;
  }

  /// From where K grows upwards, to where it shrinks. What a period makes of `below` is below the
  /// fixed point as well, since orbits do not cross.
  bool climb(Shot below) {
    const double farthest = kFar * std::max(below.kinetic, work_);
    double stride = 1e-3 * below.kinetic;
    while (below.kinetic < farthest) {
      if (!shoot(std::max(below.kinetic + stride, below.kinetic + 1.01 * below.growth)))
        return false;
      if (shot_.growth <= 0) {
        low_ = below;
        high_ = shot_;
        return true;
      }
      below = shot_;
      stride *= 3;
    }
    failure_ = NoSteadyState::runs_away;
    return false;
  }

  /// From where K shrinks downwards, to where it grows.
  bool descend(Shot above) {
    double stride = 1e-3 * above.kinetic;
    failure_ = NoSteadyState::stalls;
    while (above.kinetic > 0) {
      const double lower = std::min(above.kinetic - stride, above.kinetic + 1.01 * above.growth);
      if (!shoot(std::max(lower, 0.0))) return false;
      if (shot_.growth >= 0) {
        low_ = shot_;
        high_ = above;
        return true;
      }
      above = shot_;
      stride *= 3;
    }
    return false;
  }

  /// Above a speed from which the drive stops there may be others at which it gains speed.
  bool leap(const Shot& first) {
    if (failure_ != NoSteadyState::stalls) return false;
    const Shot stalling = shot_;
    double kinetic = first.kinetic;
    for (int i = 0; i < kMostDoublings; ++i) {
      kinetic *= 2;
      if (!shoot(kinetic)) return false;
      if (shot_.growth > 0) return climb(shot_);
    }
    shot_ = stalling;
    // Kept at some speed the drive would neither gain nor lose: it has too little energy.
    const bool balances = speed_of_mean_torques(machine_).has_value();
    failure_ = balances ? NoSteadyState::stands : NoSteadyState::stalls;
    return false;
  }

  /// Where K keeps still at a range of speeds, as where a motor gives nothing beyond one, the least
  /// of them: that to which the drive comes from below. If it does down to rest, `still` itself.
  bool settle(Shot still) {
    low_ = high_ = still;
    Shot below = still;
    for (double stride = 1e-3 * still.kinetic; below.growth == 0; stride *= 3) {
      still = below;
      if (still.kinetic == 0) return true;
      if (!shoot(std::max(still.kinetic - stride, 0.0))) return false;
      below = shot_;
    }
    double high = still.kinetic;
    if (below.growth > 0) {
      for (double low = below.kinetic; high - low > closeness() * high;) {
        const double middle = std::midpoint(low, high);
        if (!shoot(middle)) return false;
        (shot_.growth > 0 ? low : high) = middle;
      }
    }
    low_ = high_ = {high, 0};
    return true;
  }

  double closeness() const { return std::max(0.01 * accuracy_.relative, 1e-15); }

  /// The fixed point within the bracket, to the accuracy of integration.
  bool refine() {
    if (low_.kinetic == high_.kinetic) return true;
    if (low_.growth == 0 || high_.growth == 0) return settle(low_.growth == 0 ? low_ : high_);
    const double met = kMet * accuracy_.relative * cycle_.scale();
    bool failed = false;
    const auto growth = [&](double kinetic) {
      failed = failed || !shoot(kinetic);
      return failed || std::abs(shot_.growth) <= met ? 0 : shot_.growth;
    };
    const auto [a, b] = bracket_zero(growth, low_.kinetic, low_.growth, high_.kinetic, high_.growth,
                                     closeness(), 100);
    low_.kinetic = a;
    high_.kinetic = b;
    return !failed;
  }

  /// The period from `kinetic` in detail, if it agrees with the last shot.
  SteadyState record(double kinetic, int steps, NoSteadyState why) {
    CycleDetail detail;
    ++steady_.integrations;
    const CycleEnd end = cycle_.run(kinetic, steps, detail);
    if (end != CycleEnd::whole) return missing(reason(end));
    steady_.missing = why;
    steady_.states = std::move(detail.states);
    steady_.greatest = detail.greatest;
    steady_.least = detail.least;
    steady_.energy_swing = detail.energy_swing;
    steady_.motor_power = detail.motor_power;
    steady_.multiplier = detail.multiplier;
    steady_.surplus = cycle_.growth();
    steady_.energy_residual = energy_residual();
    // In time the energy itself is integrated, which may be far more than what is worked.
    const double blur = kNothing * accuracy_.relative * kinetic / size();
    const double change = std::abs(cycle_.growth() - shot_.growth) / size();
    const bool sound = change <= kSound && steady_.energy_residual <= kSound + blur;
    if (!sound) steady_.missing = NoSteadyState::unsure;
    return std::move(steady_);
  }

  SteadyState finish(int steps) {
    if (!refine()) return missing(failure_);
    const double kinetic = 0.5 * (low_.kinetic + high_.kinetic);
    if (!shoot(kinetic)) return missing(failure_);
    if (cycle_.stands()) return missing_for_sure(NoSteadyState::stands);
    return record(kinetic, steps, NoSteadyState::none);
  }

  double energy_residual() {
    const double size = std::max(work_, cycle_.range());
    if (!(size > 0)) return 0;
    if (cycle_.is_damped()) {
      const MachineState& last = steady_.states.back();
      return std::abs(last.motor_work + last.load_work) / size;
    }
    const MachineState& first = steady_.states.front();
    RunEnd end;
    end.travel = machine_.period;
    const MachineRun turn = cognate::machine::run(
        machine_, breakpoints_, {.phi = first.phi, .omega = first.omega}, end, accuracy_, 0);
    const MachineState& last = turn.states.back();
    const double inertia = machine_.move_to(guess_.phi).value;
    const double growth = 0.5 * inertia * (last.omega - first.omega) * (last.omega + first.omega);
    const double work = last.motor_work + last.load_work;
    return std::max(std::abs(growth - work), std::abs(work)) / size;
  }

  const Machine& machine_;
  const TorqueBreakpoints& breakpoints_;
  Accuracy accuracy_;
  SteadyGuess guess_;
  double speed_, inertia_, work_;
  Cycle cycle_;
  Shot shot_, low_, high_;
  SteadyState steady_;
  NoSteadyState failure_ = NoSteadyState::none;
};

}  // namespace

double mean_speed(const SteadyState& steady) {
  return 0.5 * (steady.greatest.omega + steady.least.omega);
}

double fluctuation(const SteadyState& steady) {
  return (steady.greatest.omega - steady.least.omega) / mean_speed(steady);
}

SteadyState steady_state(const Machine& machine, TorqueBreakpoints breakpoints,
                         const SteadyGuess& guess, const Accuracy& accuracy, int steps) {
  SteadyGuess from = guess;
  int integrations = 0;
  std::size_t doubts = 0;
  for (int i = 0;; ++i) {
    const Machine cut = breakpoints.cut(machine);
    Shooting shooting(cut, breakpoints, from, accuracy);
    SteadyState found = shooting.find(steps);
    found.integrations = integrations += found.integrations;
    const bool unsure = found.missing == NoSteadyState::unsure;
    const bool coarse = shooting.was_coarse(found);
    const bool last = i == kSearches || (unsure && doubts == kShorter.size());
    if (unsure && last) found.states.clear();
    if (last || !(unsure || coarse)) return found;
    if (unsure) breakpoints.refine(kShorter[doubts++]);
    if (coarse) from.speed = found.states.front().omega;
    if (!found.states.empty()) breakpoints.look(machine, {&found.states.front().omega, 1});
  }
}

SteadyState steady_state(const Machine& machine, const SteadyGuess& guess, const Accuracy& accuracy,
                         int steps) {
  return steady_state(machine, breakpoints_about(machine, guess), guess, accuracy, steps);
}

}  // namespace cognate::machine
