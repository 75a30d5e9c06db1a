/// @file Drawings of cams as SVG.
#pragma once

#include <string>

#include "app/export/cam_drawing.hpp"

namespace cognate::app {

/// `drawing` as an SVG document whose units are those of the cam, y upwards: paths of class
/// `profile`, `pitch` or `cutter`, circles of class `base-circle`, and a cross of class `centre`.
std::string svg_text(const CamDrawing& drawing);

}  // namespace cognate::app
