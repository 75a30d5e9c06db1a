/// @file Newton's method for the pivots of a dyad in homogeneous coordinates.
#pragma once

#include <Eigen/Core>
#include <span>

namespace cognate::synthesis {

struct PivotPair;

/// Which pivot is kept at infinity.
enum class Pinned { none, moving, fixed };

/// A pair (u, v) of unit vectors with uᵀB_j v = 0 for the three or four forms B_j, near `pair`: for
/// three, by the least step onto the curve; for four, the solution; with a pivot pinned to
/// infinity, the least squares of four. Ends where the residual falls no further.
PivotPair newton(std::span<const Eigen::Matrix3d> forms, const PivotPair& pair, Pinned pinned);

/// ‖J‖‖J⁺‖ (Frobenius) of the Jacobian of the forms by u and v, each on its unit sphere.
double condition_of(std::span<const Eigen::Matrix3d> forms, const PivotPair& pair);

}  // namespace cognate::synthesis
