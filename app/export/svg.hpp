/// @file Drawings as SVG.
#pragma once

#include <string>

#include "app/drawing/plan.hpp"

namespace cognate::app {

/// `plan` as an SVG document, in its true size where the plan's unit of length is known, whose
/// units are those of the plan, or where its greater side is below 1e-2 or above 1e6 those times a
/// power of ten, which its `desc` tells; y upwards: paths, circles and texts whose class is the
/// name of their layer in small letters with hyphens.
std::string svg_text(const Plan& plan);

}  // namespace cognate::app
