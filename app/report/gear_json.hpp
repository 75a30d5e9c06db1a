/// @file The outline of a gear and its circles, as a page draws them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/gear/spur_gear.hpp"

namespace cognate::app {

/// How far chords may leave the curve, in modules, so that a page of `designs` designs stays small.
double gear_fineness(std::size_t designs);

/// A gear by its transverse section: `teeth`, `module`, radii (`reference`, `base`, `tip`, `root`,
/// `form`), `half_angle` (of the tooth at the base circle, rad), `pressure_angle` (rad) and `half`:
/// half a tooth by `x`, `y` and `part` (root, fillet, involute, tip by number, of the chord that
/// leads to the point), empty where the gear cannot be made.
nlohmann::ordered_json gear_json(const gear::SpurGear& gear, double fineness);

/// One tooth of the rack that cuts `gear`, from the middle of one tooth to that of the next, as it
/// stands above the gear's upright tooth: `x`, `y`.
nlohmann::ordered_json rack_json(const gear::SpurGear& gear, double fineness);

}  // namespace cognate::app
