/// @file The tolerances of least cost that keep the judged error within a limit.
#pragma once

#include <cstddef>

#include "analysis/tolerance/sensitivity.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/figures.hpp"

namespace cognate::problems {

/// For each dimension that has a tolerance in the file, whose size there is not used. To first
/// order: the worst case, or the root sum of squares with the nominal error added.
void add_allocation(const TolerancedMechanism& toleranced, const Tolerances& tolerances,
                    const ToleranceQuestion& question, std::size_t judged,
                    const SensitivityTable& table, ToleranceResult& result);

/// Notes that there are no tolerances of least cost.
void note_nothing_allocated(ToleranceResult& result);

}  // namespace cognate::problems
