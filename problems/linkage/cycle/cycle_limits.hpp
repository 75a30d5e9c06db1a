/// @file Limits that hold over the full turn of the crank, as functions c ≥ 0 of a four-bar's
/// dimensions: clearances of moving points and the quantities of cycle_quantities.hpp.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// What of a linkage a peak speed or acceleration is that of.
enum class CycleOutput { coupler_point, rocker };

/// The dimensions on which limits over the turn depend, in the order of the slopes: four lengths,
/// coupler point u, v, pivot A x, y, and the angle of the frame.
struct CycleDimensions {
  Lengths<double> links;
  Vec2d coupler_point{};
  Vec2d pivot_a{};
  double frame_angle = 0;
  Assembly assembly = Assembly::open;
};
using LimitSlopes = std::array<double, 9>;

/// The turn is divided into sectors of the crank's angle from the frame, and each quantity has one
/// row for its extreme in each of them: rows that stay continuous and, but where two extremes
/// change places within a sector, smooth. Extremes are found on a table of crank directions and
/// refined; their slopes are those at a crank angle that stands still (the envelope theorem).
///
/// Clearance inside: for each finite side of the box the least distance from it. Outside: the least
/// of the greatest distance beyond a side. With r = |a|/a_max, or r the greatest torque of one
/// sector less the least of another, over the ripple allowed: 1 − r, from r = 1 on −ln r, so that
/// what grows beyond all bounds near a change point is mended by steps of a sensible size.
/// Likewise with r the power over the greatest allowed, or, of two sectors, the flywheel that their
/// energies ask for over the greatest allowed (cycle_energy.hpp), or 1 and what of a flywheel is
/// lacking for the fluctuation allowed over the mean inertia.
///
/// Where the linkage does not close in a sector, its rows are 1: to close is demanded by its class.
class CycleLimits {
 public:
  static constexpr int kSectors = 8;

  CycleLimits(const Constraints& constraints, CycleOutput output);

  int count() const { return count_; }

  /// Values (size count) and, unless `slopes` is empty, derivatives by the dimensions.
  void evaluate(const CycleDimensions& at, std::span<double> values,
                std::span<LimitSlopes> slopes) const;

 private:
  std::vector<Clearance> clearances_;
  CycleValues most_;  ///< finite ones alone
  Operation operation_;
  CycleOutput output_;
  int count_ = 0;
};

}  // namespace cognate::problems
