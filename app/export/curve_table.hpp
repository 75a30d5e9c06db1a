/// @file The points of a cam's curve as a table.
#pragma once

#include <string>

#include "app/drawing/cam_drawing.hpp"

namespace cognate::app {

/// The points of `curve` as CSV: cam_deg, x, y, normal_x, normal_y (unit, away from the material),
/// radius_of_curvature (negative where the curve is concave, empty where it is straight). Numbers
/// read back to the same doubles.
std::string csv_text(const CamOutline& curve);

}  // namespace cognate::app
