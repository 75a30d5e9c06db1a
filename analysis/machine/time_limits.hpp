/// @file How long steps may be where torques depend on time.
#pragma once

#include "analysis/machine/machine.hpp"
#include "analysis/machine/step_limits.hpp"

namespace cognate::machine {

/// The longest steps over `duration` from the time of `from`, by torques at its speed and at some
/// places of the drive: what acts for less than a 4096th of it may be missed.
StepLimits limits_in_time(const Machine& machine, const MachineState& from, double duration);

}  // namespace cognate::machine
