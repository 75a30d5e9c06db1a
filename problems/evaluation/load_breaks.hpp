/// @file Where along the drive a load begins or ceases to act.
#pragma once

#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/active_loads.hpp"

namespace cognate::problems {

/// The places of the drive over `assembly_ranges` at which a load with `rule` may begin or cease to
/// act whichever way the drive moves: the ends of `between` (of a drive that turns in every turn of
/// the course), where the body that bears it turns back, and where that enters or leaves the part
/// of its stroke. Not ordered.
std::vector<double> load_breaks(const Mechanism<double>& mechanism,
                                const AssemblyRanges& assembly_ranges, const LoadRule& rule,
                                const Stroke& stroke);

}  // namespace cognate::problems
