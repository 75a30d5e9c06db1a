/// @file The layers of a design's links as a document.
#pragma once

#include <nlohmann/json.hpp>

#include "problems/layers/layers.hpp"

namespace cognate::app {

/// `layers` of a design; places of the drive are degrees under `first_at_deg`, or of a driving
/// slider (`drive_slides`) lengths under `first_at`.
nlohmann::ordered_json layers_json(const problems::LayerResult& result, bool drive_slides);

}  // namespace cognate::app
