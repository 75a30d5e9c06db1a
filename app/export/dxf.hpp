/// @file Drawings of cams as DXF.
#pragma once

#include <string>

#include "app/export/cam_drawing.hpp"

namespace cognate::app {

/// `drawing` as a DXF document of release 2000 without a unit of length: each curve a closed
/// lightweight polyline on the layer PROFILE, PITCH or CUTTER, the base circles on BASE_CIRCLE, and
/// two crossing lines on CENTRE. Numbers are the shortest that read back to the same double.
std::string dxf_text(const CamDrawing& drawing);

}  // namespace cognate::app
