/// @file The accuracy of batches of four-bars, on each instruction set.
#pragma once

#include "analysis/batch/instruction_set.hpp"
#include "tests/stress/accuracy.hpp"
#include "tests/stress/closure_families.hpp"

namespace cognate::stress {

/// Coupler points of `designs` linkages drawn from `family`, each at a few crank angles, with lanes
/// over designs. Errors are in units of the rounding of Real: 2⁻⁵³ for double, 2⁻²⁴ for float.
template <class Real>
Accuracy batch_accuracy(const Family& family, InstructionSet set, int designs, unsigned seed);

}  // namespace cognate::stress
