/// @file A pinion that meshes with a rack, both spur.
#pragma once

#include <vector>

#include "analysis/gear/spur_pair.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::gear {

/// The rack's teeth are those of the pinion's basic rack, its tips shorter by `tip_reduction`
/// modules. `distance`: from the pinion's centre to its reference line, on which tooth and space
/// are as wide; r + x m without backlash.
struct RackPair {
  SpurGear pinion;
  double tip_reduction = 0;
  double distance = 0;
};

/// r + x m + ½ backlash/tan α.
double rack_distance(const SpurGear& pinion, double backlash);

/// The pitch line is the tangent to the reference circle whatever the distance, and the working
/// pressure angle the rack's. Of the second of `gears`, the rack, working radius and radii of
/// contact are infinite. Interference: by how much a tip passes along the line of action where the
/// other's involute or straight flank begins.
PairGeometry geometry(const RackPair& pair);

/// Its tooth at the right of the pitch point from the middle of the space to that of the tooth, in
/// the rack's own frame: the reference line y = 0, the body above, the tooth's middle x = 0.
std::vector<Vec2d> rack_tooth(const RackPair& pair);

}  // namespace cognate::gear
