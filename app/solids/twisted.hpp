/// @file Prisms whose section turns as it rises, in millimetres.
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>

#include "app/export/solids.hpp"

namespace cognate::app {

/// The solid of `prism`, whose section turns evenly about the axis z by `prism.twist` from its
/// lower to its upper face. Where facets are to be made of it that keep a tolerance, its faces are
/// cut into slices, so low that few nodes are needed within them. Throws as `shape_of` does.
TopoDS_Shape twisted_prism(const SolidPrism& prism, double millimetres,
                           std::optional<double> facets);

}  // namespace cognate::app
