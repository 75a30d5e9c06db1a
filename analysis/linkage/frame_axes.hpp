/// @file The axes of a four-bar's frame, A→D first, from pivots that are coordinates.
#pragma once

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/compensated.hpp"

namespace cognate {

/// Length and direction of A→D, and the links in a unit in which their powers are in range.
class FrameAxes {
 public:
  FrameAxes() = default;
  explicit FrameAxes(const FourBar& linkage);

  /// Lengths times the power of two that brings the longest into [1, 2); it rounds nothing.
  const Lengths<double>& lengths() const { return lengths_; }

  /// What |D − A| exceeds `lengths().frame` by, in the same unit.
  double frame_low() const { return frame_low_; }

  /// The unit vector along A→D.
  const Vec2d& direction() const { return direction_; }

  /// e^{iθ/2} for the angle θ from A→D of a crank at `crank_angle` from the x axis. Both halves
  /// come as vectors and are multiplied before they are rounded, so that nothing is lost where they
  /// are nearly equal. It changes sign with every turn of the crank.
  Vec2d half_crank(double crank_angle) const;

 private:
  Lengths<double> lengths_;
  double frame_low_ = 0;
  Vec2d direction_;
  Vec2<TwoParts<double>> half_frame_;  ///< along e^{iβ/2}, β the direction of A→D
  double inverse_half_ = 0;            ///< of its length
};

}  // namespace cognate
