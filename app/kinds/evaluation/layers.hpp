/// @file The layers of a mechanism's links, as a document and as tables for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/console/screen.hpp"
#include "problems/layers/layers.hpp"

namespace cognate::app {

/// `layers` of a design; places of the drive are degrees under `first_at_deg`, or of a driving
/// slider (`drive_slides`) lengths under `first_at`.
nlohmann::ordered_json layers_json(const problems::LayerResult& result, bool drive_slides);

/// The number of layers, the layer of each link, the pins, and what cannot share a layer.
std::string layers_table(const problems::LayerResult& result, bool drive_slides,
                         const Screen& screen);

}  // namespace cognate::app
