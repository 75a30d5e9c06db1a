/// @file Shapes as texts of files.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "app/export/solids.hpp"

namespace cognate::app {

/// STEP of the assembly: each of `shapes` (mm) a product with its name, in its place.
std::string step_text(const SolidAssembly& assembly, const std::vector<TopoDS_Shape>& shapes);

/// STL of `shape`, whose facets are nowhere farther than `tolerance` (mm) from it, moved so that
/// its lowest point is on z = 0.
std::string stl_text(const std::string& name, const TopoDS_Shape& shape, double tolerance);

}  // namespace cognate::app
