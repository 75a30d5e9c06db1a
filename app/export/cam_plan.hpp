/// @file The curves of a cam laid out in layers.
#pragma once

#include "app/export/cam_drawing.hpp"
#include "app/export/plan.hpp"

namespace cognate::app {

/// Each curve a closed outline on the layer PROFILE, PITCH or CUTTER, the base circles on
/// BASE_CIRCLE, and two crossing lines on CENTRE.
Plan cam_plan(const CamDrawing& drawing);

}  // namespace cognate::app
