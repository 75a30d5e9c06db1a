/// @file Shapes of OpenCASCADE, in millimetres.
#pragma once

#include <TopoDS_Shape.hxx>

#include "app/export/solids.hpp"

namespace cognate::app {

/// The shape of `solid`, whose lengths are so many millimetres, in its own axes. Throws
/// Standard_Failure, or std::runtime_error with a message, where there is none.
TopoDS_Shape shape_of(const Solid& solid, double millimetres);

}  // namespace cognate::app
