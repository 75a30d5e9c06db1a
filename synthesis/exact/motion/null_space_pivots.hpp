/// @file The dyads of a null space of linear conditions on the products of their pivots.
#pragma once

#include <Eigen/Core>
#include <array>

namespace cognate::synthesis {

/// The homogeneous coordinates of the two pivots of a dyad: (w₁, w₂, α) and (g₁, g₂, β).
struct PivotPair {
  Eigen::Vector3d moving;
  Eigen::Vector3d fixed;
};

/// Unknowns (h, w, g, q) = (αβ, βw, αg, wḡ) of conditions that are linear in them.
using PivotUnknowns = Eigen::Matrix<double, 7, 1>;
using PivotNullSpace = Eigen::Matrix<double, 7, 3>;

/// At most four pairs of pivots, unit vectors.
struct NullSpacePivots {
  std::array<PivotPair, 4> pairs;
  int count = 0;
  bool common_curve = false;  ///< infinitely many; `pairs` are examples
};

/// The real vectors of the null space that are made of two pivots: those with q h = w ḡ, two
/// conics in its coordinates. Those without pivots (cross slides, which hold the angle of the
/// body) are left out.
NullSpacePivots pivots_of_null_space(const PivotNullSpace& basis);

}  // namespace cognate::synthesis
