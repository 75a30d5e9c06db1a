/// @file Why a machine does not do what was asked for, in sentences.
#pragma once

#include <string>

#include "analysis/machine/flywheel.hpp"
#include "analysis/machine/run.hpp"
#include "analysis/machine/steady_state.hpp"

namespace cognate::problems {

/// Why there is no steady state. `turns`: whether the drive can turn fully.
std::string steady_note(const machine::SteadyState& steady, bool turns);

/// Why no flywheel was found that leaves `fluctuation`.
std::string flywheel_note(const machine::Flywheel& flywheel, double fluctuation);

/// Where and why a motion ended that was not to end there; `what` begins the sentence: "the start".
std::string ended_note(const std::string& what, const machine::MachineRun& run, bool turns);

}  // namespace cognate::problems
