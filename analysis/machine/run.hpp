/// @file The motion of a machine from an initial state: starting, running, stopping.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "analysis/machine/machine.hpp"

namespace cognate::machine {

/// When a run ends, whichever comes first; at least one of them must be given.
struct RunEnd {
  std::optional<double> time;    ///< s
  std::optional<double> travel;  ///< |φ − φ₀|
  std::optional<double> speed;   ///< ω reaches this value, from either side
  bool at_rest = false;          ///< ω reaches 0 from a motion
};

/// Why a run ended. `stalled`: at rest, and what acts does not move it; `open`: the mechanism
/// cannot be assembled further on; `too_long`: too many steps; `interrupted`.
enum class RunStop { time, travel, speed, at_rest, stalled, open, too_long, interrupted };

struct MachineRun {
  std::vector<MachineState> states;  ///< the first the initial one, the last where it ended
  RunStop stop = RunStop::time;
};

/// Integrates in time, restarting at every break that φ passes and wherever the motion turns round.
/// States are recorded at equal steps of time, `records` of them at most besides the ends.
MachineRun run(const Machine& machine, const MachineState& from, const RunEnd& end,
               const Accuracy& accuracy, std::size_t records,
               const std::atomic<bool>* interrupted = nullptr);

}  // namespace cognate::machine
