/// @file Where the drive of a machine cannot go.
#pragma once

#include <string>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"

namespace cognate::problems {

/// Why the drive does not turn fully over `assembly_ranges`, a turn or more; empty where it does.
std::string gap_in_words(const AssemblyRanges& assembly_ranges);

/// φ in [0, period) of the gaps of no width in assembly ranges that are a period long:
/// places between two ranges of the drive where a part of the mechanism is at infinity, and those
/// at which the drive does not hold it.
std::vector<double> walls(const AssemblyRanges& assembly_ranges);

}  // namespace cognate::problems
