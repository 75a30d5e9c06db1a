/// @file Drawings as DXF.
#pragma once

#include <string>

#include "app/drawing/plan.hpp"

namespace cognate::app {

enum class DxfVersion { r12, r2000 };

/// `plan` as a DXF document in its unit of length, where it has one: outlines as lightweight
/// polylines (polylines with vertices in R12) whose arcs are bulges, or as lines where they are,
/// circles and texts, each on its layer. Numbers are the shortest that read back to the same
/// double.
std::string dxf_text(const Plan& plan, DxfVersion version);

}  // namespace cognate::app
