/// @file The four-bars whose links can all lie on one line, and their motion through that position.
///
/// There two assemblies meet, and the root in the closure has a zero of first order: it changes
/// sign, if the motion is to be smooth. With θ the crank angle from A→D and k = 2 l₁ l₄,
///
///     p = k (1 − cos θ),  √p → √(2k) sin(θ/2)   where l₃ + l₄ = l₁ + l₂ or l₂ + l₄ = l₁ + l₃,
///     q = k (1 + cos θ),  √q → √(2k) cos(θ/2)   where l₁ + l₄ = l₂ + l₃.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/frame_axes.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"

namespace cognate {

/// How a linkage with a change point moves.
enum class ChangePointPath {
  single,             ///< through both assemblies, in two turns of the crank if it turns fully
  parallelogram,      ///< the rocker turns with the crank, the coupler keeps its direction
  antiparallelogram,  ///< the coupler crosses the frame
  deltoid,            ///< A–B–C–D keeps its axis of symmetry
  folded              ///< C stays on A: crank and coupler turn as one, the rocker rests
};

/// A crank angle from the x axis, in [0, 2π), at which all links lie on one line. Where B lies on D
/// the crank does not determine the position: coupler and rocker may turn about D together.
struct ChangeAngle {
  double crank_angle = 0;
  bool determined = true;
};

/// A pose with the angular velocities of coupler and rocker at unit angular velocity of the crank.
struct ChangePointPose {
  Pose pose;
  double coupler_rate = 0;
  double rocker_rate = 0;
  bool determined = true;  ///< false where B lies on D; the pose is then the limit of the motion
};

/// A four-bar with a change point, followed smoothly. Lengths that are equal within rounding are
/// taken to be equal, so that the linkage neither locks nor jumps there.
class ChangePointMotion {
 public:
  /// The motion on which `linkage` stands in its assembly at `start`, a crank angle from the x
  /// axis; at a change point itself, just after it counter-clockwise. Empty for linkages without
  /// one.
  static std::optional<ChangePointMotion> through(const FourBar& linkage, double start);

  /// The pose after turning on from the start to `crank_angle`, over any number of turns. Empty
  /// where the linkage does not close, and at dead points, where the rates are infinite.
  std::optional<ChangePointPose> at(double crank_angle) const;

  /// Which links are equal, and which of the motions through the change points this is.
  ChangePointClass kind() const { return class_; }
  ChangePointPath path() const;

  /// After what turn of the crank the motion repeats: 2π or 4π. (A crank that does not turn fully
  /// goes back and forth within it.)
  double period() const;

  /// Where links fall in line within a period, in order.
  std::vector<ChangeAngle> change_angles() const;

 private:
  ChangePointMotion(const FourBar& linkage, ChangePointClass kind);

  bool meets_d() const;  ///< whether B can lie on D

  /// √p and √q with their signs and derivatives by θ; h is their product.
  struct Roots;
  Roots roots(const Vec2d& half, const CrankDirection<double>& crank,
              const ClosureTriangle<double>& side) const;
  std::optional<ChangePointPose> about_d(double crank_angle, const Vec2d& half,
                                         const Roots& root) const;

  FourBar linkage_;
  ChangePointClass class_ = ChangePointClass::none;
  bool towards_ = false;  ///< p has its zero at θ = 0
  bool away_ = false;     ///< q has its zero at θ = π
  double sign_ = 1;       ///< of h where root_p and root_q are positive
  FrameAxes axes_;
  Lengths<double> links_;  ///< scaled as in `axes_`, equal where they should be
  HalfClosure<double> near_, far_;
};

/// The name of a four-bar with a change point where it stands in its assembly at `start`, a crank
/// angle from the x axis: "parallelogram" or "antiparallelogram" (the same lengths, in the other
/// assembly), "kite", "rhombus", and "single" where no lengths are equal. Empty for others.
std::string_view change_point_kind(const FourBar& linkage, double start);

}  // namespace cognate
