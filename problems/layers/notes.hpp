/// @file What is said of the layers of links.
#pragma once

#include <string>

#include "problems/layers/layers.hpp"

namespace cognate::problems {

/// Why there are no layers: which pins cannot pass which of the links in question. `drive_slides`:
/// whether places of the drive are lengths, not angles.
std::string blocked_note(const LayerResult& layers, bool drive_slides);

/// Which collisions could not be decided and count as such; empty where there are none.
std::string unresolved_note(const LayerResult& layers, bool drive_slides);

/// What keeps the links from fewer layers: "crank and rocker collide at 12 deg"; of many the first
/// few, empty where nothing but joints does.
std::string collisions_text(const LayerResult& layers, bool drive_slides);

}  // namespace cognate::problems
