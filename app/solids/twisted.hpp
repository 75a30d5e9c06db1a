/// @file Prisms whose section turns as it rises, in millimetres.
#pragma once

#include <TopoDS_Shape.hxx>

#include "app/export/solids.hpp"

namespace cognate::app {

/// The solid of `prism`, whose section turns evenly about the axis z by `prism.twist` from its
/// lower to its upper face. Throws as `shape_of` does.
TopoDS_Shape twisted_prism(const SolidPrism& prism, double millimetres);

}  // namespace cognate::app
