/// @file A four-bar set moving: the points of a given design at given crank angles.
#pragma once

#include <optional>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/frame_axes.hpp"

namespace cognate {

/// Where the linkage stands, in the plane of its pivots.
struct Pose {
  Vec2d b;  ///< crank pin
  Vec2d c;  ///< joint of coupler and rocker
  std::optional<Vec2d> coupler_point;
  double rocker_angle = 0;        ///< of D→C from the x axis, in (−π, π]
  double transmission_angle = 0;  ///< ∠BCD in [0, π]
};

/// The pose whose links point along `links` in the frame's axes, the crank at `crank_angle` from
/// the x axis; `frame_direction` is the unit vector along A→D.
Pose pose(const FourBar& linkage, const Vec2d& frame_direction, double crank_angle,
          const LinkDirections<double>& links);

/// A four-bar prepared for evaluation. Lengths are scaled by a power of two, so that any finite
/// dimensions will do, and |D − A| is kept to twice the precision.
class Motion {
 public:
  /// Prepares `linkage`, which is copied.
  explicit Motion(const FourBar& linkage);

  /// The pose at a crank angle counted from the x axis; empty where the linkage does not close.
  std::optional<Pose> at(double crank_angle) const;

  /// Directions of the links in the frame's axes at a crank angle counted from A→D.
  LinkDirections<double> directions(double crank_angle_from_frame) const;

 private:
  FourBar linkage_;
  FrameAxes axes_;
  Closure<double> closure_;
};

}  // namespace cognate
