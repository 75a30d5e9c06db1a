/// @file The dimensions of a chain that lie on a raster, as axes of a search.
#pragma once

#include <vector>

#include "problems/chain/space.hpp"
#include "problems/raster/raster.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// A parameter on the raster: a value is origin + size times it.
struct ChainAxis {
  std::size_t parameter;
  double origin, size;
};

struct ChainAxes {
  std::vector<synthesis::RasterAxis> axes;
  std::vector<ChainAxis> places;
};

/// The axes of `raster` within the bounds of `scaled`, which `scale` has made of the file's.
ChainAxes chain_axes(const Raster& raster, const ChainSpace& scaled, const TargetScale& scale);

}  // namespace cognate::problems
