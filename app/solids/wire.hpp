/// @file Curves of OpenCASCADE, in millimetres.
#pragma once

#include <TopoDS_Wire.hxx>

#include "app/export/solids.hpp"

namespace cognate::app {

/// Of millimetres: what is nearer is one point to OpenCASCADE.
inline constexpr double kOnePoint = 1e-7;

/// The curve in the plane of height `z` (mm): lines and arcs as they are, a spline of degree three
/// with continuous curvature through each run of corners where lines meet at less than 20°.
TopoDS_Wire wire_of(const SolidLoop& loop, double z, double millimetres);

}  // namespace cognate::app
