/// @file Why a gear, or a pair, cannot be or cannot run.
#pragma once

#include <string>
#include <vector>

#include "analysis/gear/other_gears.hpp"
#include "problems/gear/gear_result.hpp"

namespace cognate::problems {

/// What makes a gear impossible: a sentence about `name`, "The pinion", for each; none of a sound
/// one.
std::vector<std::string> gear_notes(const gear::HelicalGear& gear, const std::string& name);

/// The same of the transverse section, for which `needed_shift` is told.
std::vector<std::string> section_notes(const gear::SpurGear& section, double needed_shift,
                                       const std::string& name);

/// The same of the virtual gears of a bevel pair.
std::vector<std::string> virtual_pair_notes(const gear::SpurPair& pair);

/// The same of a cylindrical pair and of its mesh.
std::vector<std::string> gear_pair_notes(const GearPairDesign& design);

}  // namespace cognate::problems
