/// @file The curves of a cam laid out in layers.
#pragma once

#include <string>

#include "app/drawing/cam_drawing.hpp"
#include "app/drawing/plan.hpp"

namespace cognate::app {

/// Each curve a closed outline on the layer PROFILE, PITCH or CUTTER, the base circles on
/// BASE_CIRCLE, and two crossing lines on CENTRE. It is called `title`, or "Cam" where that is
/// empty.
Plan cam_plan(const CamDrawing& drawing, const std::string& title);

}  // namespace cognate::app
