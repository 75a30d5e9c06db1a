/// @file Whether a crank can make a motion, from the ranges in which its mechanism closes.
#pragma once

#include <optional>
#include <span>

#include "analysis/linkage/mobility.hpp"

namespace cognate {

/// The range of `motion`, which may span several turns, turned by whole turns so that it lies in
/// one of `ranges` (as `crank_ranges` gives them), its ends clipped to that range; empty where the
/// crank cannot make the whole motion. Ends may lie beyond a dead point by 1e-7 rad, as in
/// `find_defects`.
std::optional<CrankRange> motion_within(std::span<const CrankRange> ranges,
                                        const CrankRange& motion);

}  // namespace cognate
