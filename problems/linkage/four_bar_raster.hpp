/// @file The dimensions of a four-bar that lie on a raster, as axes of a search.
#pragma once

#include <array>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/similarity.hpp"
#include "problems/raster/raster.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {

/// A dimension of a four-bar that may lie on a raster.
enum class FourBarDimension { crank, coupler, rocker, frame, point_u, point_v, a_x, a_y, d_x, d_y };
inline constexpr std::size_t kFourBarDimensions = 10;

/// Of each dimension its place among the variables of a model; −1: it is given.
using FourBarPlaces = std::array<int, kFourBarDimensions>;

/// Whether the pivots that a file leaves open lie on its raster: the frame then follows.
bool has_pivot_raster(const Raster& raster, const Given& given);

struct FourBarRaster {
  std::vector<FourBarDimension> dimensions;
  std::vector<synthesis::RasterAxis> axes;  ///< in the file's unit
  std::vector<synthesis::AxisVariable> variables;
};

/// The axes of `raster` within `bounds`, both in the file's unit, where the variables of the model
/// are scaled by `scale`. What nothing bounds reaches a thousand sizes.
FourBarRaster four_bar_raster(const Raster& raster, const Given& given, const Bounds& bounds,
                              const FourBarPlaces& places, const Similarity& scale);

/// Gives a dimension, so that it is not sought.
void give_dimension(Given& given, FourBarDimension dimension, double value);

/// Sets a dimension; that of the frame follows from the pivots and is left alone.
void set_dimension(FourBar& linkage, FourBarDimension dimension, double value);

}  // namespace cognate::problems
