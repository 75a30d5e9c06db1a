/// @file Why a machine does not do what was requested, in sentences.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/run.hpp"
#include "analysis/machine/steady_state.hpp"
#include "problems/machine/problem.hpp"

namespace cognate::problems {

/// Why there is no steady state. `turns`: whether the drive can turn fully.
std::string steady_note(const machine::SteadyState& steady, bool turns);

/// Why no flywheel was found that leaves `fluctuation`.
std::string flywheel_note(const machine::Flywheel& flywheel, double fluctuation);

/// A start or a stop as it went.
struct EndedMotion {
  std::string name;  ///< begins the sentence: "the start"
  const machine::MachineRun& run;
  bool turns = true;    ///< whether the drive can turn fully
  bool awaited = true;  ///< whether all was waited for that might have moved it, at rest, in time
};

/// Where and why a motion ended that was not to end there.
std::string ended_note(const EndedMotion& motion);

/// That the speed `wanted` lies beyond those at which the machine settles.
std::string beyond_note(double wanted, const machine::SteadyState& steady);

/// That the machine goes backwards with its motor, and what may be meant instead.
std::string backwards_note(const std::optional<Motor>& motor);

/// What a train does through which no load can drive the motor back.
std::string holding_note();

/// That a table of `rows` cannot show what happens within a turn; empty where it can.
std::string coarse_note(const std::string& name, std::size_t rows, double turns);

}  // namespace cognate::problems
