/// @file The distances of chains from a pose, one in each SIMD lane. Include in kernels alone.
#pragma once

#include "synthesis/chain/chain_fit_kernel.hpp"
#include "synthesis/chain/heading.hpp"
#include "synthesis/chain/pose_error.hpp"
#include "synthesis/lanes/lane_directions.hpp"

namespace cognate::synthesis::COGNATE_ISA {

using Residual = PoseVector<Real>;

/// How far point and heading are from a pose, weighted, and the derivative of the last by the
/// heading's angle.
struct PoseError {
  Residual residual;
  Real slope;
};

inline PoseError pose_error(const ChainFitTask& task, const ChainView<Real>& chain,
                            const ChainPlace<Real>& at, int j) {
  const Real weight(task.root_weight[j]), turn_weight = weight * Real(task.angle_weight);
  const Direction target{Real(task.target_x[j]), Real(task.target_y[j])};
  const Direction error = weight * (at.at[task.trace] - target);
  const Direction wanted{Real(task.heading_x[j]), Real(task.heading_y[j])};
  const Chord<Real> chord(wanted, heading(chain, at, task.heading));
  return {{error.x, error.y, turn_weight * chord.length}, turn_weight * chord.slope};
}

}  // namespace cognate::synthesis::COGNATE_ISA
