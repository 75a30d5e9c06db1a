/// @file The extremes of a cam that quantities and checks speak of.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/cam/cam.hpp"
#include "analysis/cam/turn_extremes.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {

/// A greatest or least value and the cam angle where it is, rad.
struct ValueAt {
  double value = 0;
  double angle = 0;
};

/// The extremes of one cam, which must outlive this: each quantity is looked at over the turn once,
/// when it is first requested. One thread at a time.
class CamExtremes {
 public:
  explicit CamExtremes(const cam::Cam& cam) : cam_(cam) {}

  const cam::Cam& cam() const { return cam_; }

  /// The greatest pressure angle of either sign.
  ValueAt pressure_angle() const;
  /// The greatest of either sign over the rises, or over the falls, their ends included. Nothing
  /// where the motion has none.
  std::optional<ValueAt> pressure_angle(cam::MotionPart stretch) const;
  /// The same only on the side to which the cam pushes in the rises; over the falls, only on the
  /// other.
  std::optional<ValueAt> working_pressure_angle(cam::MotionPart stretch) const;

  /// Radii of curvature of the profile: the least where it is convex (negative: undercut, the
  /// profile would turn back on itself), and where it is concave. Nothing where it is nowhere so.
  /// Where the velocity drops suddenly the pitch curve has a corner, of radius 0, and the contact
  /// on a flat face jumps back by the drop.
  std::optional<ValueAt> convex_radius() const;
  std::optional<ValueAt> concave_radius() const;

  /// The least height of a roller above the cam's centre, seen along its travel, or of an arm's or
  /// a face's end likewise: not positive where the follower would pass the centre.
  double least_along() const;

  /// Least and greatest distance of the profile from the cam's centre.
  double least_profile_radius() const;
  double greatest_profile_radius() const;

  /// The width of the part of a flat face that the cam touches.
  double face_width() const;

  /// The greatest contact force; `both_ways`, of a form-closed follower, the one of greatest size.
  ValueAt contact_force(bool both_ways) const;
  ValueAt least_demand() const;
  ValueAt torque() const;        ///< of greatest size
  ValueAt stress() const;        ///< infinite where the profile comes to a point or is undercut
  ValueAt roller_speed() const;  ///< of greatest size

  /// A derivative of the motion by the cam angle, its greatest size.
  ValueAt motion(double cam::FollowerMotion<double>::*derivative) const;

 private:
  const cam::TurnExtremes& whole(cam::CamQuantity quantity) const;
  std::optional<ValueAt> smooth_convex_radius() const;
  const std::vector<cam::Jump>& corners() const;
  const std::array<std::optional<cam::TurnExtremes>, 3>& pressure_of_strokes() const;

  static constexpr int kQuantities = 10;
  const cam::Cam& cam_;
  mutable std::array<std::optional<cam::TurnExtremes>, kQuantities> known_;
  mutable std::optional<std::vector<cam::Jump>> corners_;  ///< jumps of the velocity
  /// Of the pressure angle over rises, falls and dwells: nothing for a stretch that there is not.
  mutable std::optional<std::array<std::optional<cam::TurnExtremes>, 3>> pressure_;
};

}  // namespace cognate::problems
