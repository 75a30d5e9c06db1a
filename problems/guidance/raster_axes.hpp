/// @file The dimensions of a guided body's mechanism that lie on a raster, as axes of a search.
#pragma once

#include <span>
#include <vector>

#include "problems/guidance/model.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/scale.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {

struct MotionAxes {
  std::vector<int> dimensions;  ///< see motion_dimensions
  std::vector<synthesis::RasterAxis> axes;
  std::vector<synthesis::AxisVariable> variables;
};

/// The axes of `problem`, in the file's unit, where the variables of `model` are scaled by `scale`.
/// What nothing bounds reaches a thousand sizes.
MotionAxes motion_axes(const MotionProblem& problem, const MotionModel& model,
                       const MotionScale& scale);

/// A scaled problem with such dimensions given, their values those of the model's variables; of a
/// point both coordinates are among them.
MotionProblem with_dimensions(MotionProblem scaled, std::span<const int> dimensions,
                              std::span<const double> values);

}  // namespace cognate::problems
