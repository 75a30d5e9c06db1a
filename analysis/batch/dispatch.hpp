/// @file The kernels of the instruction set that a call requests.
#pragma once

#include <optional>

#include "analysis/batch/instruction_set.hpp"
#include "analysis/batch/kernel.hpp"

namespace cognate::batch {

/// The kernels of `set`, of the widest set if it is empty; nothing if the machine lacks it.
template <class Real>
std::optional<Kernels<Real>> find_kernels(std::optional<InstructionSet> set);

}  // namespace cognate::batch
