#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "analysis/machine/flywheel.hpp"
#include "problems/machine/machine_model.hpp"
#include "problems/machine/machine_notes.hpp"
#include "problems/machine/machine_result.hpp"
#include "problems/machine/motion_table.hpp"
#include "problems/machine/steady_facts.hpp"

namespace cognate::problems {
namespace {

using machine::Machine;
using machine::MachineRun;
using machine::MachineState;
using machine::NoSteadyState;
using machine::RunEnd;
using machine::RunStop;
using machine::SteadyState;

constexpr double kTurn = 2 * std::numbers::pi;
/// A start is over where the speed is as close to the steady one, relative to it.
constexpr double kStarted = 0.01;
/// Turns after which a start or stop ends for which the file gives no limit.
constexpr double kMostTurns = 1000;

void append(std::vector<Fact>& facts, std::vector<Fact> more) {
  std::ranges::move(more, std::back_inserter(facts));
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
  void do_tasks() {
    if (problem_.fluctuation) find_flywheel();
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
    machine::SteadyGuess guess{.phi = phi - model_.period() * std::floor(phi / model_.period())};
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
      append(result_.facts, flywheel_facts(found));
      if (found.without.states.empty()) {
        result_.notes.emplace_back(
            "without a flywheel the machine does not get round, so that there is no fluctuation "
            "of it, nor what the textbooks' formula makes of it");
      }
      steady_ = std::move(found.steady);
      return;
    }
    fail(flywheel_note(found, *problem_.fluctuation));
    if (found.without.states.empty()) steady_ = std::move(found.without);
  }

  /// The steady state, found once.
  const SteadyState& steady_state() {
    if (!steady_) {
      steady_ = machine::steady_state(machine(), guess(), accuracy_, problem_.run.steps);
    }
    return *steady_;
  }

  bool is_steady() { return !steady_state().states.empty(); }

  void steady() {
    const SteadyState& found = steady_state();
    if (!model_.turns()) result_.notes.push_back(model_.gap());
    if (!is_steady()) {
      fail(steady_note(found, model_.turns()));
      if (found.missing == NoSteadyState::any_speed) {
        result_.notes.emplace_back("with a start speed, that of the start is taken");
      }
      return;
    }
    if (found.missing == NoSteadyState::any_speed)
      result_.notes.push_back(steady_note(found, model_.turns()));
    const Machine whole = machine();
    result_.motions.push_back({MachineTask::steady, motion_table(whole, found.states)});
    append(result_.facts, steady_facts(problem_, whole, found));
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

  void tell(MachineTask task, const Machine& machine, const MachineRun& run) {
    result_.motions.push_back({task, motion_table(machine, run.states)});
    const std::string name = task == MachineTask::start ? "start" : "stop";
    const MachineState& last = run.states.back();
    const double turns = (last.phi - run.states.front().phi) / kTurn;
    result_.facts.push_back({name + "_time_s", last.time});
    result_.facts.push_back({name + "_turns", turns});
    result_.facts.push_back({name + "_end_speed_rad_s", last.omega});
  }

  void start() {
    const MachineRunRequest& wanted = problem_.run;
    RunEnd end = limits();
    const bool settles = is_steady() && steady_state().missing == NoSteadyState::none;
    const bool beyond = settles && wanted.speed_end && *wanted.speed_end > steady_->greatest.omega;
    end.speed = wanted.speed_end;
    if (settles && (!wanted.speed_end || beyond)) {
      end.approach = {{guess().phi, steady_->states.front().omega, kStarted}};
    }
    const Machine whole = machine();
    const MachineRun run =
        follow(whole, {.phi = wanted.start_phi, .omega = wanted.start_speed}, end);
    tell(MachineTask::start, whole, run);
    if (beyond && run.stop == RunStop::approached) {
      fail(
          fmt::format("the speed does not reach {:.6g} rad/s: it settles between {:.6g} and {:.6g} "
                      "rad/s",
                      *wanted.speed_end, steady_->least.omega, steady_->greatest.omega));
    } else if (is_limit(run.stop) && !wanted.speed_end) {
      result_.notes.push_back(ended_note("the start", run, model_.turns()));
    } else if (run.stop != RunStop::approached && run.stop != RunStop::speed) {
      fail(ended_note("the start", run, model_.turns()));
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
    tell(MachineTask::stop, whole, run);
    if (run.stop != RunStop::at_rest) fail(ended_note("the stop", run, model_.turns()));
  }

  const MachineProblem& problem_;
  Deadline deadline_;
  MachineModel model_;
  machine::Accuracy accuracy_;
  double flywheel_ = 0;
  std::optional<SteadyState> steady_;
  MachineResult result_;
  bool whole_ = true;
};

}  // namespace

MachineResult run_machine(const MachineProblem& problem, const Run& run) {
  return MachineTasks(problem, run).answer();
}

}  // namespace cognate::problems
