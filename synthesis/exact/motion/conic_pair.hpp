/// @file Where two conics of the projective plane meet.
#pragma once

#include <Eigen/Core>
#include <array>

namespace cognate::synthesis {

/// The real common points of two conics, homogeneous unit vectors. Two points that nearly fall
/// together, real or not, are both given, at the accuracy of the square root of rounding: refine
/// and compare.
struct ConicIntersection {
  std::array<Eigen::Vector3d, 4> points;
  int count = 0;
  /// The conics share a line (all its points are common) or are one; `points` are examples of it.
  bool common_curve = false;
};

/// The points of xᵀ a x = xᵀ b x = 0, a and b symmetric: a degenerate conic of their pencil that
/// splits into real lines is met by another conic.
ConicIntersection intersect(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

}  // namespace cognate::synthesis
