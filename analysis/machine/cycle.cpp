#include "analysis/machine/cycle.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/numbers/zeros.hpp"

namespace cognate::machine {
namespace {

/// What the components of the state are: the growth of K, the time, the works of motor and loads
/// (all scaled), and the logarithm of a small deviation of ω.
enum CycleComponent : std::size_t { grown, elapsed, motor_work, load_work, deviation };

/// Forwards, with no speed to speak of.
constexpr double kLeastRate = std::numeric_limits<double>::min();
/// The step, relative to ω, of ∂M/∂ω by central differences.
constexpr double kRateDifference = 1e-5;
/// A machine of which deviations decay so much in a period is integrated implicitly.
constexpr double kDamped = 1e5;
/// The error of K is held, in explicit steps, against no less than this part of the work: a smaller
/// K is passed through in steps that φ does not resolve.
constexpr double kLeastScale = 1e-10;
/// The longest of the steps that are compared with others, in parts of the period.
constexpr double kFine = 1.0 / 256;
constexpr std::size_t kAskOfCycle = 256;

}  // namespace

Cycle::Cycle(const Machine& machine, const TorqueBreakpoints& breakpoints, double phi0, double work,
             const Accuracy& accuracy)
    : machine_(machine),
      breakpoints_(breakpoints),
      accuracy_(accuracy),
      pieces_(machine, phi0),
      phi0_(phi0),
      work_(work),
      stepper_([this](const State& y, State& dy, double phi) { slope(y, dy, phi); },
               accuracy.relative) {}

double Cycle::kinetic(const State& y) const {
  return kinetic_ + y[grown] * scale_;
}

/// ω, or the least there is.
double Cycle::speed(double inertia, double kinetic) const {
  return kinetic > 0 ? std::max(std::sqrt(2 * kinetic / inertia), kLeastRate) : kLeastRate;
}

/// ∂M/∂ω where the machine stands.
double Cycle::torque_slope(double speed, double time) const {
  const double step = kRateDifference * speed;
  const double change =
      machine_.torques(speed + step, time).sum() - machine_.torques(speed - step, time).sum();
  return step > 0 ? change / (2 * step) : 0;
}

Cycle::State Cycle::slope_at(double inertia, double speed, double time) {
  const Torques acting = machine_.torques(speed, time);
  State slope{acting.sum() / scale_, 0, 0, 0, 0};
  if (!(inertia > 0)) slope[grown] = std::numeric_limits<double>::quiet_NaN();
  if (!detailed_) return slope;
  slope[elapsed] = 1 / (speed * time_scale_);
  slope[motor_work] = acting.motor / work_;
  slope[load_work] = acting.load / work_;
  slope[deviation] = torque_slope(speed, time) / (inertia * speed);
  return slope;
}

void Cycle::slope(const State& y, State& slope, double phi) {
  const double inertia = machine_.move_to(pieces_.inside(place_.piece, phi)).value;
  slope = slope_at(inertia, speed(inertia, kinetic(y)), y[elapsed] * time_scale_);
}

Sensitivity<Cycle::State> Cycle::sensitivity(const State& y, const State& slope, double phi,
                                             double step) {
  Sensitivity<State> sensitivity;
  const double inertia = machine_.move_to(pieces_.inside(place_.piece, phi)).value;
  const double omega = speed(inertia, kinetic(y));
  if (omega > kLeastRate) {
    const double time = y[elapsed] * time_scale_;
    const State above = slope_at(inertia, omega * (1 + kRateDifference), time);
    const State below = slope_at(inertia, omega * (1 - kRateDifference), time);
    const double by_speed = 1 / (2 * kRateDifference * omega);
    for (std::size_t i = 0; i < y.size(); ++i) {
      sensitivity.by_first[i] = (above[i] - below[i]) * by_speed * (scale_ / (inertia * omega));
    }
  }
  State beyond;
  this->slope(y, beyond, phi + step);
  for (std::size_t i = 0; i < y.size(); ++i) {
    sensitivity.by_x[i] = (beyond[i] - slope[i]) / step;
  }
  return sensitivity;
}

Cycle::Mark Cycle::mark(double phi, const State& y) {
  const EquivalentInertia inertia = machine_.move_to(pieces_.inside(place_.piece, phi));
  const double omega = speed(inertia.value, kinetic(y));
  const Torques acting = machine_.torques(omega, y[elapsed] * time_scale_);
  return {.at = {omega, pieces_.counted({place_.turn, place_.piece, phi})},
          .torque = acting.sum(),
          .bend = acting.sum() - 0.5 * omega * omega * inertia.slope,
          .power = acting.motor * omega};
}

/// The derivative of the motor's power along the motion, by central differences.
double Cycle::motor_power_slope(double phi, const State& y) {
  constexpr double kStep = 1e-6;
  const double step = kStep * machine_.period;
  State rate;
  slope(y, rate, phi);
  const auto beside = [&](double distance) {
    State at = y;
    for (std::size_t i = 0; i < at.size(); ++i) at[i] += distance * rate[i];
    return mark(phi + distance, at).power;
  };
  return (beside(step) - beside(-step)) / (2 * step);
}

MachineState Cycle::state(double phi, const State& y) {
  const double inertia = machine_.move_to(pieces_.inside(place_.piece, phi)).value;
  return {.time = y[elapsed] * time_scale_,
          .phi = pieces_.counted({place_.turn, place_.piece, phi}),
          .omega = speed(inertia, kinetic(y)),
          .motor_work = y[motor_work] * work_,
          .load_work = y[load_work] * work_};
}

void Cycle::note_energy(const State& y) {
  const double growth = y[grown] * scale_;
  greatest_ = std::max(greatest_, growth);
  least_ = std::min(least_, growth);
}

/// The end of the last step, and the extremes of speed, energy and power between its ends.
void Cycle::note_extremes(CycleDetail& detail) {
  const double from = stepper_.x_before(), to = stepper_.x();
  const Mark before = std::exchange(last_, mark(to, stepper_.y()));
  const auto compare = [&](const SpeedAt& at) {
    if (at.omega > detail.greatest.omega) detail.greatest = at;
    if (at.omega < detail.least.omega) detail.least = at;
  };
  compare(last_.at);
  // Of what is all but even, changes of sign are rounding.
  const double rounding = accuracy_.relative * work_ / machine_.period;
  const auto place_of = [&](double Mark::*vanishing) -> std::optional<double> {
    const double a = before.*vanishing, b = last_.*vanishing;
    if (!(a * b < 0) || std::max(std::abs(a), std::abs(b)) <= rounding) return std::nullopt;
    const auto f = [&](double phi) { return mark(phi, stepper_.at(phi)).*vanishing; };
    return bracket_zero(f, from, a, to, b).first;
  };
  if (const auto at = place_of(&Mark::bend)) compare(mark(*at, stepper_.at(*at)).at);
  if (const auto at = place_of(&Mark::torque)) note_energy(stepper_.at(*at));
  note_power(before, detail);
}

/// The motor's greatest power in the last step, where that may be beyond what was met before: in a
/// step over which it bends little.
void Cycle::note_power(const Mark& before, CycleDetail& detail) {
  const double from = stepper_.x_before(), to = stepper_.x();
  const double change = std::abs(last_.power - before.power);
  const double highest = std::max(before.power, last_.power);
  const bool too_low = highest + change + power_change_ < detail.motor_power;
  power_change_ = change;
  detail.motor_power = std::max(detail.motor_power, highest);
  if (too_low || !(motor_power_slope(from, stepper_.y_before()) > 0) ||
      !(motor_power_slope(to, stepper_.y()) < 0)) {
    return;
  }
  constexpr int kBits = 26;
  const auto power = [&](double phi) { return -mark(phi, stepper_.at(phi)).power; };
  const double found = boost::math::tools::brent_find_minima(power, from, to, kBits).second;
  detail.motor_power = std::max(detail.motor_power, -found);
}

double Cycle::longest_step() const {
  const double longest = breakpoints_.longest_step(stepper_.x());
  return fine_ ? std::min(0.5 * longest, kFine * machine_.period) : longest;
}

/// By how much a deviation of K decays with φ.
double Cycle::decay(double phi, double kinetic) {
  const double inertia = machine_.move_to(pieces_.inside(place_.piece, phi)).value;
  const double omega = speed(inertia, kinetic);
  return -torque_slope(omega, 0) / (inertia * omega);
}

void Cycle::choose_method(bool implicit) {
  if (implicit == stepper_.is_implicit()) return;
  AdaptiveSteps::Sensitivities sensitivities;
  if (implicit) {
    sensitivities = [this](const State& y, const State& slope, double phi, double step) {
      return sensitivity(y, slope, phi, step);
    };
  }
  stepper_.make_implicit(std::move(sensitivities));
}

/// After every step whether to go on, now and then whether implicitly.
CycleEnd Cycle::count_step() {
  if (++taken_ >= accuracy_.most_steps) return CycleEnd::gave_up;
  if (taken_ % kAskOfCycle != 0) return CycleEnd::whole;
  if (accuracy_.stop && accuracy_.stop()) return CycleEnd::stopped;
  const double rate = decay(stepper_.x(), kinetic(stepper_.y()));
  always_implicit_ = always_implicit_ || rate * (stepper_.x() - stepper_.x_before()) > 1;
  if (always_implicit_) choose_method(true);
  return CycleEnd::whole;
}

CycleEnd Cycle::run_piece(double to, CycleDetail* detail, int steps) {
  const double length = machine_.period / steps;
  if (detail != nullptr) {
    last_ = mark(stepper_.x(), stepper_.y());
    detail->motor_power = std::max(detail->motor_power, last_.power);
  }
  while (stepper_.x() < to) {
    double limit = std::min(to, stepper_.x() + longest_step()), record = to;
    if (detail != nullptr) {
      // φ of the next state to record, in this turn of the drive.
      record = phi0_ + length * static_cast<double>(detail->states.size()) -
               place_.turn * machine_.period;
      limit = std::min(limit, std::max(record, stepper_.x()));
    }
    if (limit > stepper_.x()) {
      if (!stepper_.step(limit)) return CycleEnd::open;
      note_energy(stepper_.y());
      if (detail != nullptr) note_extremes(*detail);
    }
    if (detail != nullptr && stepper_.x() >= record) {
      detail->states.push_back(state(stepper_.x(), stepper_.y()));
    }
    if (const CycleEnd end = count_step(); end != CycleEnd::whole) return end;
  }
  return CycleEnd::whole;
}

CycleEnd Cycle::go(double kinetic, CycleDetail* detail, int steps) {
  kinetic_ = kinetic;
  detailed_ = detail != nullptr;
  greatest_ = least_ = 0;
  taken_ = 0;
  place_ = pieces_.place(phi0_, 1);
  choose_method(always_implicit_ || decay(place_.phi, kinetic) * machine_.period > kDamped);
  const double least_scale = stepper_.is_implicit() ? kLeastRate : kLeastScale * work_;
  scale_ = kinetic > 0 ? std::clamp(kinetic, least_scale, work_) : work_;
  State y{};
  if (detailed_) {
    const MachineState first = state(place_.phi, y);
    time_scale_ = machine_.period / first.omega;
    detail->states = {first};
    detail->states.reserve(static_cast<std::size_t>(steps) + 1);
    detail->greatest = detail->least = {first.omega, first.phi};
    detail->motor_power = mark(place_.phi, y).power;
    power_change_ = 0;
  }
  const CycleEnd end = integrate_round(pieces_, place_, stepper_, y,
                                       [&](double to) { return run_piece(to, detail, steps); });
  growth_ = y[grown] * scale_;
  if (!detailed_ || end != CycleEnd::whole) return end;
  // Rounding of φ₀ may leave the last state to this place.
  if (detail->states.size() <= static_cast<std::size_t>(steps)) {
    detail->states.push_back(state(stepper_.x(), y));
  }
  detail->energy_swing = range();
  detail->multiplier = std::exp(y[deviation]);
  return end;
}

CycleEnd Cycle::run(double kinetic) {
  fine_ = false;
  return go(kinetic, nullptr, 1);
}

CycleEnd Cycle::check(double kinetic) {
  fine_ = true;
  return go(kinetic, nullptr, 1);
}

CycleEnd Cycle::run(double kinetic, int steps, CycleDetail& detail) {
  fine_ = true;
  return go(kinetic, &detail, steps);
}

}  // namespace cognate::machine
