/// @file The dimensions of a chain that lie on a raster, as axes of a search.
#pragma once

#include <optional>
#include <string>
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

/// A dimension, as users call it, and its bounds in the file's unit.
struct DimensionOffRaster {
  std::string name;
  Range bounds;
};

/// The first dimension of a chain that has no value on the raster within the bounds of the file;
/// empty where each has one.
std::optional<DimensionOffRaster> dimension_off_raster(const Raster& raster,
                                                       const Topology& topology);

}  // namespace cognate::problems
