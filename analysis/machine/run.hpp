/// @file The motion of a machine from an initial state: starting, running, stopping.
#pragma once

#include <optional>
#include <vector>

#include "analysis/machine/machine.hpp"
#include "analysis/machine/torque_breakpoints.hpp"

namespace cognate::machine {

/// A steady motion that a run is to come close to: it ends as soon as its speed is that of the
/// steady motion at the same φ, to within `within` of it.
struct Approach {
  double omega = 0;      ///< of the steady motion at the φ where the run begins
  double within = 0.01;  ///< relative to that speed
};

/// When a run ends, whichever comes first; or with the most steps: those of `Accuracy`, and some
/// more for each turn travelled.
struct RunEnd {
  std::optional<double> time{};    ///< s
  std::optional<double> travel{};  ///< |φ − φ₀|
  std::optional<double> speed{};   ///< ω reaches this value, from either side
  std::optional<Approach> approach{};
  bool at_rest = false;  ///< ω reaches 0 from a motion
};

/// Why a run ended. `stalled`: at rest, and what acts does not move it; `open`: the mechanism
/// cannot be assembled further on; `gave_up`: too many steps; `stopped`: from outside.
enum class RunStop { time, travel, speed, approached, at_rest, stalled, open, gave_up, stopped };

struct MachineRun {
  std::vector<MachineState> states;  ///< the first the initial one, the last where it ended
  RunStop stop = RunStop::time;
};

/// Integrates in time, with √J ω for the speed: its derivative M/√J needs no slope of J and is
/// smooth at rest. Begins anew at every break that φ passes and wherever the motion turns round,
/// with the torques of the side to which it goes. The moment of an end is located within its step;
/// the steady motion that a run approaches is integrated along with it, by its own
/// dω/dφ. States are recorded at equal steps of time,
/// `records` of them in addition to the ends, for which the motion is integrated a second time;
/// none where it was given up.
MachineRun run(const Machine& machine, const MachineState& from, const RunEnd& end,
               const Accuracy& accuracy, std::size_t records);

/// The same of a machine whose torque breakpoints is known, which has its jumps among its breaks.
MachineRun run(const Machine& machine, const TorqueBreakpoints& breakpoints,
               const MachineState& from, const RunEnd& end, const Accuracy& accuracy,
               std::size_t records);

}  // namespace cognate::machine
