#include "problems/machine/notes.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

#include "analysis/numbers/constants.hpp"
#include "problems/machine/gearing.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

constexpr std::string_view kOutOfTime = "out of time";
constexpr std::string_view kSteep =
    "too many steps, as where torques change very steeply with speed or angle";
constexpr std::string_view kManySteps =
    "too many steps, as where the machine swings to and fro, or torques change very steeply with "
    "speed or angle";

}  // namespace

std::string steady_note(const machine::SteadyState& steady, bool turns) {
  using machine::NoSteadyState;
  switch (steady.missing) {
    case NoSteadyState::none:
      return {};
    case NoSteadyState::stalls:
      return fmt::format(
          "no steady state: the machine stalls, because motor and loads together take energy from "
          "it at every speed examined ({:.6g} J in a period)",
          -steady.surplus);
    case NoSteadyState::stands:
      return "no steady state: the machine stops within a turn, although at constant speed it "
             "would gain as much energy in a turn as it loses; a larger flywheel helps, or a "
             "higher start speed if torques do not depend on speed";
    case NoSteadyState::runs_away:
      return fmt::format(
          "no steady state: the machine runs away, because motor and loads together give energy to "
          "it at every speed examined ({:.6g} J in a period)",
          steady.surplus);
    case NoSteadyState::any_speed:
      return fmt::format(
          "every speed is steady: torques do not depend on speed and do no work in a period; "
          "{}",
          steady.states.empty() ? "give run.start_speed" : "that of the start is taken");
    case NoSteadyState::depends_on_time:
      return "no steady state: motor or loads depend on time";
    case NoSteadyState::open:
      return turns ? "no steady state: motor or loads have no value at a speed that was examined"
                   : "no steady state: the mechanism cannot be assembled at every angle";
    case NoSteadyState::unsure:
      return "no steady state is reported: results with different steps disagree, as "
             "where torques change too steeply with speed or angle, or act over too small an "
             "angle";
    case NoSteadyState::stopped:
    case NoSteadyState::gave_up:
      break;
  }
  return fmt::format("the search for the steady state was ended before it was done: {}",
                     steady.missing == NoSteadyState::stopped ? kOutOfTime : kSteep);
}

std::string flywheel_note(const machine::Flywheel& flywheel, double fluctuation) {
  using machine::NoSteadyState;
  switch (flywheel.why) {
    case NoSteadyState::any_speed:
      return "no flywheel can be found because every speed is steady; give run.start_speed";
    case NoSteadyState::gave_up:
    case NoSteadyState::stopped:
    case NoSteadyState::unsure:
      return fmt::format("the search for the flywheel was ended before it was done: {}",
                         flywheel.why == NoSteadyState::stopped ? kOutOfTime : kSteep);
    case NoSteadyState::none:
    case NoSteadyState::stands:
    case NoSteadyState::stalls:
      return fmt::format("no flywheel makes the machine run with a fluctuation of {:.6g}",
                         fluctuation);
    default:
      return "no flywheel gives the machine a steady state";
  }
}

std::string ended_note(const EndedMotion& motion) {
  using machine::RunStop;
  const auto& [name, run, turns, awaited] = motion;
  const machine::MachineState &first = run.states.front(), &last = run.states.back();
  constexpr double kShown = 1e-3;
  const double in_turn = in_period(last.phi, kTurn) * 360 / kTurn;
  const double angle = in_turn < 360 - kShown ? in_turn : 0;
  const std::string place = fmt::format("after {:.6g} s and {:.6g} turns, at {:.6g} rad/s",
                                        last.time, (last.phi - first.phi) / kTurn, last.omega);
  switch (run.stop) {
    case RunStop::stalled:
      return fmt::format("{} fails: the machine stands still and nothing moves it{}, {}", name,
                         awaited ? "" : " yet; run.time_max says how long to wait for what does",
                         place);
    case RunStop::open:
      if (turns) return fmt::format("{} fails: motor or loads have no value, {}", name, place);
      if (last.time == first.time) {
        return fmt::format(
            "{} fails: the mechanism cannot be assembled where it begins, at {:.6g}°", name, angle);
      }
      return fmt::format("{} fails: the mechanism cannot be assembled further on than {:.6g}°, {}",
                         name, angle, place);
    case RunStop::gave_up:
    case RunStop::stopped:
      return fmt::format("{} was ended before it was done: {}, {}", name,
                         run.stop == RunStop::stopped ? kOutOfTime : kManySteps, place);
    case RunStop::at_rest:
      return fmt::format("{} fails: the machine stops, {}", name, place);
    default:
      return fmt::format("{} ended at its limit, {}", name, place);
  }
}

std::string beyond_note(double wanted, const machine::SteadyState& steady) {
  const std::string least = fmt::format("{:.6g}", steady.least.omega);
  const std::string greatest = fmt::format("{:.6g}", steady.greatest.omega);
  const std::string speeds =
      least == greatest ? "at " + least : fmt::format("between {} and {}", least, greatest);
  return fmt::format("the speed does not reach {:.6g} rad/s: it settles {} rad/s", wanted, speeds);
}

std::string backwards_note(const std::optional<Motor>& motor) {
  const std::string note = "the machine goes backwards; a steady motion is sought forwards only";
  if (!motor || !motor->train || gearing_of(*motor).ratio > 0) return note;
  return note + fmt::format(
                    ": the train turns the drive against the motor, and motor.reversed = {} lets "
                    "it go forwards",
                    !motor->train->reversed);
}

std::string holding_note() {
  return "the train is self-locking: a load cannot drive the motor back through it, so that a "
         "machine that its load pushes stays at the speed at which the motor gives no torque, and "
         "is held where the motor is off";
}

std::string coarse_note(const std::string& name, std::size_t rows, double turns) {
  constexpr double kOfATurn = 12;
  if (static_cast<double>(rows) >= kOfATurn * std::abs(turns)) return {};
  return fmt::format(
      "the table of {} has {} rows for {:.6g} turns: too few to show what happens within a turn; "
      "expected a greater run.steps, or an earlier end, for that",
      name, rows, std::abs(turns));
}

}  // namespace cognate::problems
