#include "analysis/machine/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/machine/adaptive_steps.hpp"
#include "analysis/machine/machine.hpp"
#include "analysis/machine/pieces.hpp"
#include "analysis/machine/steady_state.hpp"
#include "analysis/machine/step_limits.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::machine {
namespace {

/// How often torques that depend on time are looked at in advance, from how many places.
constexpr std::size_t kTimes = 4096;
constexpr int kPlaces = 3;

/// The longest steps over `duration` from the time of `from`, by torques at its speed and at some
/// places of the drive: what acts for less than a 4096th of it may be missed.
StepLimits limits_in_time(const Machine& machine, const MachineState& from, double duration) {
  StepLimits limits(from.time, duration, kTimes);
  const std::vector<int> one_segment(kTimes);
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
    limits.shorten(values, one_segment, sum / static_cast<double>(kTimes));
  }
  return limits;
}

/// What the components of the state are: φ in its period, and scaled √J ω and works; and √J ω of
/// the steady motion at the same φ, where the run approaches one.
enum Component : std::size_t { phi, momentum, motor, load, steady };

using State = AdaptiveSteps::State;

/// Slower than this is only a direction.
constexpr double kBarely = std::numeric_limits<double>::min();
/// A machine that moves no further than this part of its period between rests, so many times on
/// end, is at rest.
constexpr double kNoTravel = 1e-9;
constexpr int kMostRests = 8;
/// How many times in a run a machine at rest is asked whether what depends on time moves it.
constexpr int kWakes = 10000;
constexpr std::size_t kAsk = 256;

/// Steps that a run may take for each turn that it gets on, and for each piece of that.
constexpr std::size_t kStepsOfATurn = 5000, kStepsOfAPiece = 20;
/// The longest steps, in parts of the period, where it is not known how long torques change.
constexpr double kUntimed = 1.0 / 64;

/// A speed that the machine may reach.
double usual_speed(const Machine& machine, const MachineState& from, const RunEnd& end) {
  double speed = from.omega;
  if (end.speed && std::abs(*end.speed) > std::abs(speed)) speed = *end.speed;
  if (end.approach && std::abs(end.approach->omega) > std::abs(speed)) speed = end.approach->omega;
  return speed != 0 ? speed : speed_of_mean_torques(machine).value_or(1);
}

/// What may end a step, in the order in which they count where they coincide.
enum class Event { none, rest, speed, approach, travel, border };

class Runner {
 public:
  Runner(const Machine& machine, const TorqueBreakpoints& breakpoints, const MachineState& from,
         const RunEnd& end, const Accuracy& accuracy)
      : machine_(machine),
        breakpoints_(breakpoints),
        end_(end),
        accuracy_(accuracy),
        pieces_(machine, 0),
        from_(from),
        stepper_([this](const State& y, State& dy, double x) { slope(y, dy, x); },
                 accuracy.relative) {
    const double size = std::abs(from.omega);
    const double inertia = machine.move_to(pieces_.place(from.phi, 1).phi).value;
    work_ = usual_work(size);
    if (!(work_ > 0)) work_ = 0.5 * inertia * size * size;
    if (!(work_ > 0)) work_ = 1;
    momentum_ = std::sqrt(2 * std::max(work_, 0.5 * inertia * size * size));
    time_ = machine.period * std::sqrt(inertia) / momentum_;
    root_ = std::sqrt(inertia);
    if (end.approach) steady_speed_ = end.approach->omega;
    if (machine.depends_on_time && end.time) {
      limits_in_time_ = limits_in_time(machine, from, *end.time - from.time);
    }
  }

  /// The motion with states at `times` (increasing).
  MachineRun go(std::vector<double> times) {
    times_ = std::move(times);
    run_ = {.states = {from_}};
    next_ = taken_ = 0;
    now_ = from_;
    if (end_.approach && is_near(now_.omega, steady_speed_)) return finish(RunStop::approached);
    if (!std::isfinite(time_) || !(time_ > 0)) return finish(RunStop::open);
    int rests = 0;
    while (true) {
      if (now_.omega == 0) {
        if (moved_ && end_.at_rest) return finish(RunStop::at_rest);
        if (!set_out() && !wait()) return finish(waited_);
      } else {
        direction_ = now_.omega > 0 ? 1 : -1;
      }
      const double before = now_.phi;
      if (const auto stop = stretch()) return finish(*stop);
      const bool short_segment = std::abs(now_.phi - before) <= kNoTravel * machine_.period;
      rests = short_segment ? rests + 1 : 0;
      if (rests >= kMostRests) return finish(RunStop::stalled);
    }
  }

 private:
  /// What is worked in a period, as far as it is known at the beginning.
  double usual_work(double omega) const {
    double work = turnover(machine_, omega, from_.time);
    if (!machine_.depends_on_time || !end_.time) return work;
    constexpr int kLooks = 32;
    for (int i = 1; i <= kLooks; ++i) {
      const double time = from_.time + (*end_.time - from_.time) * i / kLooks;
      work = std::max(work, turnover(machine_, omega, time));
    }
    return work;
  }

  double speed(double root, double scaled) const {
    const double speed = scaled * momentum_ / root;
    return direction_ * std::max(direction_ * speed, kBarely);
  }

  void slope(const State& y, State& slope, double x) {
    const double root = root_at(y[phi]);
    const double omega = y[momentum] * momentum_ / root;
    const Torques acting = machine_.torques(speed(root, y[momentum]), x * time_);
    slope = {omega * time_, acting.sum() / root * (time_ / momentum_),
             acting.motor * omega * (time_ / work_), acting.load * omega * (time_ / work_),
             steady_slope(y, root, omega, x * time_)};
  }

  /// Of the steady motion at the φ of a machine that moves at `omega`.
  double steady_slope(const State& y, double root, double omega, double time) {
    if (!end_.approach) return 0;
    const double steady_omega = y[steady] * momentum_ / root;
    const double acting = machine_.torques(steady_omega, time).sum();
    return omega * acting / (root * steady_omega) * (time_ / momentum_);
  }

  bool is_near(double omega, double steady_omega) const {
    return std::abs(omega - steady_omega) <= end_.approach->within * std::abs(steady_omega);
  }

  /// Whether a machine at rest starts to move now, and where to.
  bool set_out() {
    for (const int direction : {1, -1}) {
      const Place place = pieces_.place(now_.phi, direction);
      machine_.move_to(pieces_.inside(place.piece, place.phi));
      const double acting = machine_.torques(direction * kBarely, now_.time).sum();
      if (!(direction * acting > 0)) continue;
      direction_ = direction;
      return true;
    }
    return false;
  }

  /// Waits at rest for what depends on time to move the machine; else `waited_` says why it ends.
  bool wait() {
    waited_ = RunStop::stalled;
    if (!machine_.depends_on_time || !end_.time) return false;
    const double from = now_.time, length = *end_.time - from;
    waited_ = RunStop::time;
    for (int i = 1; i <= kWakes; ++i) {
      now_.time = from + length * i / kWakes;
      if (set_out()) return true;
    }
    return false;
  }

  /// √J in the piece that the machine is in.
  double root_at(double angle) {
    return std::sqrt(machine_.move_to(pieces_.inside(place_.piece, angle)).value);
  }

  MachineState state(double x, const State& y) {
    return {.time = x * time_,
            .phi = pieces_.counted({place_.turn, place_.piece, y[phi]}),
            .omega = y[momentum] * momentum_ / root_at(y[phi]),
            .motor_work = y[motor] * work_,
            .load_work = y[load] * work_};
  }

  State state_vector() {
    const double scale = root_at(place_.phi) / momentum_;
    return {place_.phi, now_.omega * scale, now_.motor_work / work_, now_.load_work / work_,
            steady_speed_ * scale};
  }

  /// What changes its sign where an event happens, positive before it.
  double until(Event event, double x, const State& y) {
    switch (event) {
      case Event::rest:
        return direction_ * y[momentum];
      case Event::speed:
        return speed_side_ * (*end_.speed - state(x, y).omega);
      case Event::approach:
        return std::abs(y[momentum] - y[steady]) - end_.approach->within * std::abs(y[steady]);
      default:
        return direction_ * (limit_ - y[phi]);
    }
  }

  bool is_asked(Event event) const {
    return (event != Event::speed || end_.speed) && (event != Event::approach || end_.approach);
  }

  /// Where in the last step an event happens; nothing where it does not.
  std::optional<double> place_of(Event event) {
    const auto f = [&](double x) { return until(event, x, stepper_.at(x)); };
    const double from = stepper_.x_before();
    const double before = until(event, from, stepper_.y_before());
    double to = stepper_.x(), after = until(event, to, stepper_.y());
    if (after > 0) {
      const auto lowest = lowest_within(event, f, before, after);
      if (!lowest) return std::nullopt;
      to = *lowest;
      after = f(to);
      if (after > 0) return std::nullopt;
    }
    if (after == 0) return to;
    if (!(before > 0)) return from;
    return better_end(f, bracket_zero(f, from, before, to, after));
  }

  /// Within the last step where the speed comes nearest to what ends the run, if that is nearer
  /// than at both ends of the step.
  template <class Function>
  std::optional<double> lowest_within(Event event, const Function& f, double before, double after) {
    if (event != Event::speed && event != Event::approach) return std::nullopt;
    constexpr double kNext = 1e-3;
    constexpr int kSteps = 40;
    const double from = stepper_.x_before(), to = stepper_.x(), next = kNext * (to - from);
    if (!(f(from + next) < before && f(to - next) < after)) return std::nullopt;
    return golden_section(f, from, to, kSteps).middle();
  }

  /// The first event of the last step and where in it that is.
  std::pair<Event, double> first_event() {
    std::pair<Event, double> first{Event::none, stepper_.x()};
    for (const Event event : {Event::rest, Event::speed, Event::approach, limit_event_}) {
      if (!is_asked(event)) continue;
      const auto at = place_of(event);
      if (at && (first.first == Event::none || *at < first.second)) first = {event, *at};
    }
    return first;
  }

  void set_limit() {
    limit_ = direction_ > 0 ? pieces_.to(place_.piece) : pieces_.from(place_.piece);
    limit_event_ = Event::border;
    if (!end_.travel) return;
    const double target = from_.phi + direction_ * *end_.travel - place_.turn * machine_.period;
    if (direction_ * (limit_ - target) < 0) return;
    limit_ = target;
    limit_event_ = Event::travel;
  }

  /// Moves on in one direction within one piece; the reason where the run ends in it.
  std::optional<RunStop> stretch() {
    // After many turns φ does not say any more on which side of a border it is.
    if (at_border_ && now_.omega != 0) {
      pieces_.move_on(place_, direction_);
    } else {
      place_ = pieces_.place(now_.phi, direction_);
    }
    if (is_open()) return RunStop::open;
    set_limit();
    speed_side_ = end_.speed && now_.omega > *end_.speed ? -1 : 1;
    stepper_.start(now_.time / time_, state_vector());
    moved_ = true;
    while (true) {
      record();
      if (end_.time && stepper_.x() >= *end_.time / time_) return leave(RunStop::time);
      if (++taken_ >= most_steps()) return leave(RunStop::gave_up);
      if (taken_ % kAsk == 0 && accuracy_.stop && accuracy_.stop()) return leave(RunStop::stopped);
      if (!stepper_.step(next_time() / time_) || is_at_edge()) return leave(RunStop::open);
      const auto [event, at] = first_event();
      if (event != Event::none) return take(event, at);
    }
  }

  /// Whether the piece that is entered begins where the mechanism cannot be assembled.
  bool is_open() {
    return !std::isfinite(machine_.move_to(pieces_.inside(place_.piece, place_.phi)).value);
  }

  /// Whether the angle no longer changes for lack of places beyond it: where a mechanism cannot be
  /// assembled further on its inertia grows without bound, and the speed left is not yet 0.
  bool is_at_edge() {
    constexpr double kBeyond = 1e-12;
    const double now = stepper_.y()[phi];
    if (now != stepper_.y_before()[phi]) return false;
    const double beyond = now + direction_ * kBeyond * machine_.period;
    return !std::isfinite(machine_.move_to(pieces_.inside(place_.piece, beyond)).value);
  }

  /// The states that are due, which an event may have come upon.
  void record() {
    constexpr double kRounding = 1e-15;
    while (next_ < times_.size() && stepper_.x() * time_ >= times_[next_] * (1 - kRounding)) {
      run_.states.push_back(state(stepper_.x(), stepper_.y()));
      ++next_;
    }
  }

  std::optional<RunStop> leave(RunStop why) {
    now_ = state(stepper_.x(), stepper_.y());
    return why;
  }

  double next_time() const {
    double next = std::numeric_limits<double>::infinity();
    if (next_ < times_.size()) next = times_[next_];
    if (end_.time) next = std::min(next, *end_.time);
    // A machine that drifts on without end is looked at now and then.
    return std::min({next, stepper_.x() * time_ + 10 * time_, resolved_time()});
  }

  /// Until when a step may go so that it jumps over no narrow load.
  double resolved_time() const {
    const double now = stepper_.x() * time_;
    const double rate = std::abs(stepper_.slope()[phi]);
    const double bend = std::abs(stepper_.slope()[momentum]) * momentum_ / root_ * time_;
    const double way = breakpoints_.longest_step(stepper_.y()[phi]);
    const double by_angle = 2 * way / (rate + std::sqrt(rate * rate + 2 * bend * way)) * time_;
    const double longest =
        limits_in_time_ ? std::min(by_angle, limits_in_time_->at(now)) : by_angle;
    return now + std::max(longest, 1e-12 * std::abs(now));
  }

  std::size_t most_steps() const {
    const double way = pieces_.counted({place_.turn, place_.piece, stepper_.y()[phi]}) - from_.phi;
    const auto of_a_turn = static_cast<double>(kStepsOfATurn + kStepsOfAPiece * pieces_.count());
    return accuracy_.most_steps +
           static_cast<std::size_t>(std::abs(way) / machine_.period * of_a_turn);
  }

  /// Stands at the event, exactly; the reason where it ends the run.
  std::optional<RunStop> take(Event event, double at) {
    State y = stepper_.at(at);
    if (event == Event::rest) y[momentum] = 0;
    if (event == limit_event_) y[phi] = limit_;
    now_ = state(at, y);
    at_border_ = event == Event::border;
    if (end_.approach) steady_speed_ = y[steady] * momentum_ / root_at(y[phi]);
    if (event == Event::approach) return RunStop::approached;
    if (event == Event::travel) return RunStop::travel;
    if (event != Event::speed) return std::nullopt;
    now_.omega = *end_.speed;
    return RunStop::speed;
  }

  MachineRun finish(RunStop stop) {
    run_.states.push_back(now_);
    run_.stop = stop;
    return std::move(run_);
  }

  const Machine& machine_;
  const TorqueBreakpoints& breakpoints_;
  std::optional<StepLimits> limits_in_time_;
  RunEnd end_;
  Accuracy accuracy_;
  Pieces pieces_;
  MachineState from_, now_;
  AdaptiveSteps stepper_;
  double work_ = 1, momentum_ = 1, time_ = 1, root_ = 1;
  double steady_speed_ = 0;  ///< of the motion that the run approaches, where the machine stands
  Place place_;
  int direction_ = 1;
  double limit_ = 0, speed_side_ = 1;
  Event limit_event_ = Event::border;
  bool moved_ = false, at_border_ = false;
  RunStop waited_ = RunStop::stalled;
  std::vector<double> times_;
  std::size_t next_ = 0, taken_ = 0;
  MachineRun run_;
};

}  // namespace

MachineRun run(const Machine& machine, const TorqueBreakpoints& breakpoints,
               const MachineState& from, const RunEnd& end, const Accuracy& accuracy,
               std::size_t records) {
  Runner runner(machine, breakpoints, from, end, accuracy);
  MachineRun whole = runner.go({});
  const bool ended_early = whole.stop == RunStop::gave_up || whole.stop == RunStop::stopped;
  if (records == 0 || ended_early) return whole;
  const double duration = whole.states.back().time - from.time;
  std::vector<double> times;
  for (std::size_t i = 1; i <= records; ++i) {
    times.push_back(from.time +
                    duration * static_cast<double>(i) / static_cast<double>(records + 1));
  }
  return Runner(machine, breakpoints, from, end, accuracy).go(std::move(times));
}

MachineRun run(const Machine& machine, const MachineState& from, const RunEnd& end,
               const Accuracy& accuracy, std::size_t records) {
  TorqueBreakpoints breakpoints(machine);
  const double speed = usual_speed(machine, from, end);
  const std::array<double, 3> speeds{0.2 * speed, speed, 3 * speed};
  breakpoints.look(machine, speeds, from.time);
  if (machine.depends_on_time && !end.time) breakpoints.refine(kUntimed);
  return run(breakpoints.cut(machine), breakpoints, from, end, accuracy, records);
}

}  // namespace cognate::machine
