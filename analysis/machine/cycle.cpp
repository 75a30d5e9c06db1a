#include "analysis/machine/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/mechanism/zeros.hpp"

namespace cognate::machine {
namespace {

/// What the components of the state are: the growth of K, the time, the works of motor and loads
/// (all scaled), and the logarithm of a small deviation of ω.
enum Component : std::size_t { kinetic, elapsed, motor, load, deviation };

/// Forwards, with no speed to speak of.
constexpr double kBarely = std::numeric_limits<double>::min();
/// The step, relative to ω, of ∂M/∂ω by central differences.
constexpr double kDifference = 1e-5;
constexpr std::size_t kAsk = 256;

}  // namespace

Cycle::Cycle(const Machine& machine, double phi0, double work, const Accuracy& accuracy)
    : machine_(machine),
      accuracy_(accuracy),
      pieces_(machine, phi0),
      phi0_(phi0),
      work_(work),
      stepper_([this](const State& y, State& dy, double phi) { slope(y, dy, phi); },
               accuracy.relative) {}

/// ω where K has grown by `scaled`, or the least there is.
double Cycle::omega(double inertia, double scaled) {
  const double k = kinetic_ + scaled * work_;
  return k > 0 ? std::sqrt(2 * k / inertia) : kBarely;
}

void Cycle::slope(const State& y, State& slope, double phi) {
  const double inertia = machine_.move_to(pieces_.inside(place_.piece, phi)).value;
  const double speed = omega(inertia, y[kinetic]);
  const double time = y[elapsed] * time_scale_;
  const Torques acting = machine_.torques(speed, time);
  slope = {acting.sum() / work_, 0, 0, 0, 0};
  if (!(inertia > 0)) slope[kinetic] = std::numeric_limits<double>::quiet_NaN();
  if (!detailed_) return;
  slope[elapsed] = 1 / (speed * time_scale_);
  slope[motor] = acting.motor / work_;
  slope[load] = acting.load / work_;
  const double step = kDifference * speed;
  const double change =
      machine_.torques(speed + step, time).sum() - machine_.torques(speed - step, time).sum();
  slope[deviation] = change / (2 * step) / (inertia * speed);
}

/// J ω dω/dφ = M − ½ ω² dJ/dφ.
double Cycle::bend(double phi, const State& y) {
  const EquivalentInertia inertia = machine_.move_to(pieces_.inside(place_.piece, phi));
  const double speed = omega(inertia.value, y[kinetic]);
  const double acting = machine_.torques(speed, y[elapsed] * time_scale_).sum();
  return acting - 0.5 * speed * speed * inertia.slope;
}

MachineState Cycle::state(double phi, const State& y) {
  const double inertia = machine_.move_to(pieces_.inside(place_.piece, phi)).value;
  return {.time = y[elapsed] * time_scale_,
          .phi = pieces_.counted({place_.turn, place_.piece, phi}),
          .omega = omega(inertia, y[kinetic]),
          .motor_work = y[motor] * work_,
          .load_work = y[load] * work_};
}

/// The end of the last step, and the extreme between its ends, where the speed has one.
void Cycle::note_extreme(CycleDetail& detail) {
  const auto compare = [&](const MachineState& at) {
    if (at.omega > detail.greatest.omega) detail.greatest = {at.omega, at.phi};
    if (at.omega < detail.least.omega) detail.least = {at.omega, at.phi};
  };
  compare(state(stepper_.x(), stepper_.y()));
  const auto f = [&](double phi) { return bend(phi, stepper_.at(phi)); };
  const double before = bend(stepper_.x_before(), stepper_.y_before());
  const double after = bend(stepper_.x(), stepper_.y());
  // Of a speed that is all but even, changes of sign are rounding.
  const double rounding = accuracy_.relative * work_ / machine_.period;
  if (!(before * after < 0) || std::max(std::abs(before), std::abs(after)) <= rounding) return;
  const auto [low, high] = bracket_zero(f, stepper_.x_before(), before, stepper_.x(), after);
  compare(state(low, stepper_.at(low)));
}

CycleEnd Cycle::run_piece(double to, CycleDetail* detail, int steps) {
  const double length = machine_.period / steps;
  while (stepper_.x() < to) {
    double limit = to, record = to;
    if (detail != nullptr) {
      // φ of the next state to record, in this turn of the drive.
      record = phi0_ + length * static_cast<double>(detail->states.size()) -
               place_.turn * machine_.period;
      limit = std::min(to, std::max(record, stepper_.x()));
    }
    if (limit > stepper_.x()) {
      if (!stepper_.step(limit)) return CycleEnd::open;
      const double k = kinetic_ + stepper_.y()[kinetic] * work_;
      greatest_ = std::max(greatest_, k);
      least_ = std::min(least_, k);
      if (detail != nullptr) note_extreme(*detail);
    }
    if (detail != nullptr && stepper_.x() >= record) {
      detail->states.push_back(state(stepper_.x(), stepper_.y()));
    }
    if (++taken_ >= accuracy_.most_steps) return CycleEnd::gave_up;
    if (taken_ % kAsk == 0 && accuracy_.stop && accuracy_.stop()) return CycleEnd::gave_up;
  }
  return CycleEnd::whole;
}

CycleEnd Cycle::run(double kinetic) {
  kinetic_ = kinetic;
  detailed_ = false;
  greatest_ = least_ = kinetic;
  taken_ = 0;
  place_ = pieces_.place(phi0_, 1);
  State y{};
  for (std::size_t i = 0; i < pieces_.count(); ++i) {
    stepper_.start(place_.phi, y);
    const CycleEnd end = run_piece(pieces_.to(place_.piece), nullptr, 1);
    if (end != CycleEnd::whole) return end;
    y = stepper_.y();
    pieces_.move_on(place_, 1);
  }
  growth_ = y[Component::kinetic] * work_;
  return CycleEnd::whole;
}

CycleEnd Cycle::run(double kinetic, int steps, CycleDetail& detail) {
  kinetic_ = kinetic;
  detailed_ = true;
  greatest_ = least_ = kinetic;
  taken_ = 0;
  place_ = pieces_.place(phi0_, 1);
  State y{};
  const MachineState first = state(place_.phi, y);
  time_scale_ = machine_.period / first.omega;
  detail = {
      .states = {first}, .greatest = {first.omega, first.phi}, .least = {first.omega, first.phi}};
  detail.states.reserve(static_cast<std::size_t>(steps) + 1);
  for (std::size_t i = 0; i < pieces_.count(); ++i) {
    stepper_.start(place_.phi, y);
    const CycleEnd end = run_piece(pieces_.to(place_.piece), &detail, steps);
    if (end != CycleEnd::whole) return end;
    y = stepper_.y();
    if (i + 1 < pieces_.count()) pieces_.move_on(place_, 1);
  }
  // Rounding of φ₀ may leave the last state to this place.
  if (detail.states.size() <= static_cast<std::size_t>(steps)) {
    detail.states.push_back(state(stepper_.x(), y));
  }
  growth_ = y[Component::kinetic] * work_;
  detail.multiplier = std::exp(y[deviation]);
  return CycleEnd::whole;
}

}  // namespace cognate::machine
