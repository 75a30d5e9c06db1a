/// @file The layers of a design's links on the terminal.
#pragma once

#include <string>

#include "app/console/screen.hpp"
#include "problems/layers/layers.hpp"

namespace cognate::app {

/// The number of layers, the layer of each link, the pins, and what cannot share a layer.
/// `drive_slides`: whether places of the drive are lengths, not angles.
std::string layers_table(const problems::LayerResult& result, bool drive_slides,
                         const Screen& screen);

}  // namespace cognate::app
