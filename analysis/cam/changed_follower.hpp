/// @file Where a cam that is as designed puts a follower that is not.
#pragma once

#include <array>
#include <optional>

#include "analysis/cam/cam.hpp"

namespace cognate::cam {

/// A cam at one angle, whose follower may have other dimensions than it was designed for.
class ChangedFollower {
 public:
  /// `cam` must outlive this object; any `angle`.
  ChangedFollower(const Cam& cam, double angle);

  /// By how much the follower stands from where it should (length, or radians of an oscillating
  /// one), if its dimensions are off by `changes`. The profile is that of the cam as designed; a
  /// change of the base radius raises it by as much along its normals. The contact is found anew:
  /// the roller's centre on the parallel of the pitch curve that its path or arm crosses, the face
  /// on the tangent. Empty where it is not found, or undercut.
  std::optional<double> misplacement(const CamDimensions<double>& changes) const;

 private:
  struct CurvePlace;

  CurvePlace raised(const RollerState<double>& state, double raise, const Vec2d& turn) const;
  CurvePlace raised_at(double along, double raise) const;
  template <class Miss>
  std::optional<Vec2d> touching(double raise, double size, const Miss& miss) const;
  std::optional<double> of_translating_roller(const CamDimensions<double>& changes) const;
  std::optional<double> of_oscillating_roller(const CamDimensions<double>& changes) const;
  std::optional<double> of_oscillating_face(const CamDimensions<double>& changes) const;

  const Cam& cam_;
  double angle_;
  FollowerMotion<double> motion_;  ///< as designed
  RollerState<double> state_;      ///< as designed, of a roller or a knife edge
};

/// The derivatives of `ChangedFollower::misplacement` by the dimensions, in the order of
/// CamDimensions' members, at no change: with the pressure angle α, 1/cos α along the normal and
/// tan α across it, over the arm of an oscillating follower.
std::array<double, 6> misplacement_rates(const Cam& cam, double angle);

}  // namespace cognate::cam
