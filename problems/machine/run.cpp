#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/steady_state.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity.hpp"
#include "problems/evaluation/force_units.hpp"
#include "problems/linkage/result.hpp"
#include "problems/machine/gearing.hpp"
#include "problems/machine/model.hpp"
#include "problems/machine/motion_table.hpp"
#include "problems/machine/notes.hpp"
#include "problems/machine/problem.hpp"
#include "problems/machine/result.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

/// A speed that is even to within so many tolerances has no place where it is greatest.
constexpr double kEven = 10;

double degrees(double phi, double period) {
  return in_period(phi, period) * 360 / kTurn;
}

/// speed_mean_rad_s, speed_max_rad_s, speed_max_at_deg, speed_min_rad_s, speed_min_at_deg (places
/// of a speed that is not even),
/// fluctuation, period_s, energy_swing_J (greatest less least kinetic energy), multiplier,
/// energy_residual, and with a motor motor_work_J (of a period), motor_power_mean_W,
/// motor_power_max_W, both at the drive.
std::vector<Quantity> steady_quantities(const MachineProblem& problem,
                                        const machine::Machine& machine,
                                        const machine::SteadyState& steady) {
  const bool is_even = machine::fluctuation(steady) <= kEven * problem.run.tolerance;
  std::vector<Quantity> quantities{{"speed_mean_rad_s", machine::mean_speed(steady)},
                                   {"speed_max_rad_s", steady.greatest.omega}};
  const auto add_place = [&](const char* name, const machine::SpeedAt& at) {
    if (!is_even) quantities.push_back({name, degrees(at.phi, machine.period)});
  };
  add_place("speed_max_at_deg", steady.greatest);
  quantities.push_back({"speed_min_rad_s", steady.least.omega});
  add_place("speed_min_at_deg", steady.least);
  quantities.push_back({"fluctuation", machine::fluctuation(steady)});
  quantities.push_back({"period_s", steady.period()});
  quantities.push_back({"energy_swing_J", steady.energy_swing});
  quantities.push_back({"multiplier", steady.multiplier});
  quantities.push_back({"energy_residual", steady.energy_residual});
  if (problem.motor) {
    const double work = steady.states.back().motor_work;
    quantities.push_back({"motor_work_J", work});
    quantities.push_back({"motor_power_mean_W", work / steady.period()});
    quantities.push_back({"motor_power_max_W", steady.motor_power});
  }
  return quantities;
}

/// flywheel_inertia_kg_m2, and where the machine runs without one
/// flywheel_inertia_approximate_kg_m2, greatest_excess_work_J, fluctuation_without_flywheel.
std::vector<Quantity> flywheel_quantities(const machine::Flywheel& flywheel) {
  std::vector<Quantity> quantities{{"flywheel_inertia_kg_m2", flywheel.inertia}};
  if (flywheel.without.states.empty()) return quantities;
  quantities.push_back({"flywheel_inertia_approximate_kg_m2", flywheel.approximate});
  quantities.push_back({"greatest_excess_work_J", flywheel.greatest_excess});
  quantities.push_back({"fluctuation_without_flywheel", machine::fluctuation(flywheel.without)});
  return quantities;
}

using machine::Machine;
using machine::MachineRun;
using machine::MachineState;
using machine::NoSteadyState;
using machine::RunEnd;
using machine::RunStop;
using machine::SteadyState;

/// A start is over as soon as the speed is as close to the steady one at the same angle, relative
/// to it.
constexpr double kStarted = 0.01;
/// Turns after which a start or stop ends for which the file gives no limit.
constexpr double kMostTurns = 1000;

void append(std::vector<Quantity>& quantities, std::vector<Quantity> more) {
  std::ranges::move(more, std::back_inserter(quantities));
}

class MachineTasks {
 public:
  MachineTasks(const MachineProblem& problem, const Run& run)
      : problem_(problem), deadline_(run), model_(problem, deadline_) {
    accuracy_.relative = problem.run.tolerance;
    accuracy_.stop = [this] { return deadline_.reached(); };
    flywheel_ = problem.flywheel;
  }

  MachineResult answer() {
    if (problem_.motor) add_train(*problem_.motor);
    if (const auto place = model_.without_inertia(flywheel_)) {
      fail(fmt::format(
          "the machine's inertia vanishes where the drive is at {:.6g}°, and any torque "
          "would bring any speed at once there; give the crank, a flywheel or the motor "
          "an inertia",
          *place * 360 / kTurn));
    } else {
      do_tasks();
    }
    result_.status = status();
    result_.work.seconds = deadline_.spent();
    result_.work.positions = result_.work.velocities = result_.work.accelerations =
        model_.evaluations();
    return std::move(result_);
  }

 private:
  void add_train(const Motor& motor) {
    append(result_.quantities, train_quantities(motor));
    if (gearing_of(motor).is_self_locking()) note_once(holding_note());
  }

  void do_tasks() {
    if (problem_.fluctuation && model_.turns()) find_flywheel();
    for (const MachineTask task : problem_.run.tasks) {
      if (task == MachineTask::steady) steady();
      if (task == MachineTask::start) start();
      if (task == MachineTask::stop) stop();
    }
  }

  Status status() const {
    if (deadline_.interrupted()) return Status::interrupted;
    if (deadline_.expired()) return Status::time_limit;
    if (result_.motions.empty()) return Status::no_solution;
    return whole_ ? Status::solved : Status::infeasible;
  }

  void fail(std::string note) {
    whole_ = false;
    result_.notes.push_back(std::move(note));
  }

  machine::SteadyGuess guess() const {
    const double phi = problem_.run.start_phi, speed = problem_.run.start_speed;
    machine::SteadyGuess guess{.phi = in_period(phi, model_.period())};
    if (speed > 0) guess.speed = speed;
    return guess;
  }

  Machine machine(bool motor = true, double brake = 0) const {
    return model_.machine({.flywheel = flywheel_, .motor = motor, .brake = brake});
  }

  void find_flywheel() {
    const auto machine_with = [this](double inertia) {
      return model_.machine({.flywheel = inertia});
    };
    machine::Flywheel found = machine::flywheel_for(machine_with, *problem_.fluctuation, guess(),
                                                    accuracy_, problem_.run.steps);
    if (found.found) {
      flywheel_ = found.inertia;
      append(result_.quantities, flywheel_quantities(found));
      if (found.without.states.empty()) {
        result_.notes.emplace_back(
            "without a flywheel the machine does not complete a turn, so that it has no "
            "fluctuation "
            "and the textbook formula gives no flywheel");
      }
      steady_ = std::move(found.steady);
      return;
    }
    fail(flywheel_note(found, *problem_.fluctuation));
    is_explained_ = found.why == found.without.missing && found.why != NoSteadyState::stalls;
    steady_ = std::move(found.without);
  }

  /// The steady state, found once; not looked for where the drive cannot turn fully.
  const SteadyState& steady_state() {
    if (!model_.turns()) {
      steady_ = SteadyState{.missing = NoSteadyState::open};
    } else if (!steady_) {
      steady_ = machine::steady_state(machine(), guess(), accuracy_, problem_.run.steps);
    }
    return *steady_;
  }

  bool is_steady() { return !steady_state().states.empty(); }

  void steady() {
    const SteadyState& found = steady_state();
    if (!model_.turns()) note_gap();
    if (!is_steady()) {
      whole_ = false;
      if (!is_explained_) note_once(steady_note(found, model_.turns()));
      if (found.missing == NoSteadyState::stalls && sets_out_backwards()) note_backwards();
      return;
    }
    if (found.missing == NoSteadyState::any_speed) {
      result_.notes.push_back(steady_note(found, model_.turns()));
    }
    const Machine whole = machine();
    result_.motions.push_back({MachineTask::steady, motion_table(whole, found.states)});
    append(result_.quantities, steady_quantities(problem_, whole, found));
  }

  /// Whether motor and loads, in the mean over a period, push the drive backwards from rest.
  bool sets_out_backwards() const {
    constexpr int kSamples = 90;
    constexpr double kNothing = 1e-9;
    const Machine whole = machine();
    double sum = 0, size = 0;
    for (int i = 0; i < kSamples; ++i) {
      whole.move_to(whole.period * (i + 0.5) / kSamples);
      const auto acting = whole.torques(-std::numeric_limits<double>::min(), 0);
      sum += acting.sum();
      size += std::abs(acting.motor) + std::abs(acting.load);
    }
    return sum < -kNothing * size;
  }

  void note_backwards() { note_once(backwards_note(problem_.motor)); }

  void note_gap() { note_once(model_.gap()); }

  void note_once(const std::string& note) {
    if (std::ranges::find(result_.notes, note) != result_.notes.end()) return;
    result_.notes.push_back(note);
  }

  RunEnd limits() const {
    RunEnd end;
    end.time = problem_.run.time_max;
    if (problem_.run.turns_max) end.travel = *problem_.run.turns_max * kTurn;
    if (!end.time && !end.travel) end.travel = kMostTurns * kTurn;
    return end;
  }

  /// Whether a motion ended where the file lets it end.
  bool is_limit(RunStop stop) const {
    return (stop == RunStop::time && problem_.run.time_max) ||
           (stop == RunStop::travel && problem_.run.turns_max);
  }

  MachineRun follow(const Machine& machine, const MachineState& from, const RunEnd& end) const {
    const auto rows = static_cast<std::size_t>(std::max(problem_.run.steps, 1)) - 1;
    return machine::run(machine, from, end, accuracy_, rows);
  }

  void add(MachineTask task, const Machine& machine, const MachineRun& run) {
    result_.motions.push_back({task, motion_table(machine, run.states)});
    const std::string name = task == MachineTask::start ? "start" : "stop";
    const MachineState& last = run.states.back();
    const double turns = (last.phi - run.states.front().phi) / kTurn;
    result_.quantities.push_back({name + "_time_s", last.time});
    result_.quantities.push_back({name + "_turns", turns});
    result_.quantities.push_back({name + "_end_speed_rad_s", last.omega});
    const std::string coarse = coarse_note("the " + name, run.states.size(), turns);
    if (model_.depends_on_angle() && !coarse.empty()) result_.notes.push_back(coarse);
  }

  /// Says where a motion ended; a failure unless that is all right.
  void note_end(const std::string& name, const MachineRun& run, bool is_right) {
    const bool awaited = !model_.depends_on_time() || problem_.run.time_max;
    const std::string note = ended_note({name, run, model_.turns(), awaited});
    if (is_right) {
      result_.notes.push_back(note);
    } else {
      fail(note);
      if (run.stop == RunStop::open && !model_.turns()) note_gap();
    }
  }

  /// Whether a motion that settles comes past `speed` on its way.
  bool passes(double speed) const {
    const double from = problem_.run.start_speed;
    return speed >= std::min(from, steady_->least.omega) &&
           speed <= std::max(from, steady_->greatest.omega);
  }

  void start() {
    const MachineRunRequest& wanted = problem_.run;
    RunEnd end = limits();
    const bool settles = is_steady() && steady_state().missing == NoSteadyState::none;
    const bool beyond = settles && wanted.speed_end && !passes(*wanted.speed_end);
    end.speed = wanted.speed_end;
    if (settles && (!wanted.speed_end || beyond)) {
      end.approach = {{steady_->states.front().omega, kStarted}};
    }
    const Machine whole = machine();
    const MachineRun run =
        follow(whole, {.phi = wanted.start_phi, .omega = wanted.start_speed}, end);
    add(MachineTask::start, whole, run);
    if (run.states.back().omega < 0) note_backwards();
    if (run.stop == RunStop::speed) return;
    if (run.stop != RunStop::approached) {
      note_end("the start", run, is_limit(run.stop) && !wanted.speed_end);
    } else if (beyond) {
      fail(beyond_note(*wanted.speed_end, *steady_));
    }
  }

  void stop() {
    const bool from_steady = is_steady();
    const double speed = from_steady ? steady_->states.front().omega : problem_.run.start_speed;
    if (speed == 0) {
      fail("the stop has no speed to begin from: there is no steady state and no start speed");
      return;
    }
    RunEnd end = limits();
    end.at_rest = true;
    const Machine whole = machine(false, problem_.brake.value_or(0));
    const MachineRun run = follow(whole, {.phi = problem_.run.start_phi, .omega = speed}, end);
    add(MachineTask::stop, whole, run);
    if (run.stop != RunStop::at_rest) note_end("the stop", run, is_limit(run.stop));
  }

  const MachineProblem& problem_;
  Deadline deadline_;
  MachineModel model_;
  machine::Accuracy accuracy_;
  double flywheel_ = 0;
  std::optional<SteadyState> steady_;
  MachineResult result_;
  bool is_explained_ = false;  ///< why there is no steady state, with the flywheel
  bool whole_ = true;
};

/// `problem` with inertias, torques and works at the drive in kg·m², N·m and J.
MachineProblem in_joules(MachineProblem problem) {
  if (!problem.mechanism) return problem;
  const double unit = metres(problem.length_unit);
  problem.mechanism = in_joules(*std::move(problem.mechanism), unit);
  for (MachineLoad& load : problem.loads) load.rule = in_joules(load.rule, unit);
  return problem;
}

}  // namespace

MachineResult run_machine(const MachineProblem& given, const Run& run) {
  const auto valid = KindTraits<MachineProblem>::checked(given);
  if (!valid) return refused<MachineResult>(valid.error());
  const MachineProblem problem = in_joules(*valid);
  run.enter(Phase::simulation, kUnknownEnd);
  MachineResult result = MachineTasks(problem, run).answer();
  if (given.mechanism) {
    std::ranges::move(unit_notes(*given.mechanism, given.length_unit),
                      std::back_inserter(result.notes));
  }
  return result;
}

}  // namespace cognate::problems
