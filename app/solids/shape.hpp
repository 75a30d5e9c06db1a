/// @file Shapes of OpenCASCADE, in millimetres.
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>

#include "app/export/solids.hpp"

namespace cognate::app {

/// The shape of `solid`, whose lengths are so many millimetres, in its own axes. Where facets are
/// to be made of it that keep a tolerance (in millimetres), its twisted faces are cut into slices.
/// Throws Standard_Failure, or std::runtime_error with a message, where there is none.
TopoDS_Shape shape_of(const Solid& solid, double millimetres,
                      std::optional<double> facets = std::nullopt);

}  // namespace cognate::app
