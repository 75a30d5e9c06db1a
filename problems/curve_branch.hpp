/// @file The coupler curve of a four-bar on one branch, by the crank angle, in the frame's axes.
#pragma once

#include <optional>
#include <vector>

#include "analysis/closure.hpp"
#include "analysis/four_bar.hpp"

namespace cognate::problems {

/// A place of the curve: `at` along the motion is the crank angle times its sense.
struct CurveSample {
  double at = 0;
  Vec2d point;
};

/// The coupler point of `linkage`, in its own assembly, with two derivatives.
class CurveBranch {
 public:
  /// A linkage with a coupler point; lengths of order 1.
  explicit CurveBranch(const FourBar& linkage);

  /// A point of the plane in axes with origin A and x along A→D, in which all others are.
  Vec2d in_frame(const Vec2d& point) const { return conj(axes_) * (point - pivot_); }

  /// The coupler point at a crank angle from the frame line; empty where the linkage does not
  /// close.
  std::optional<Vec2d> point(double crank_angle) const;

  /// Points from `from` to `to` along the motion, ends included, close enough that no chord is
  /// longer than some sixtieth of the curve, as far as a few halvings of the steps reach.
  std::vector<CurveSample> samples(double sense, double from, double to) const;

  /// The place along the motion, within [from, to], to which descent from `start` leads of the
  /// distance from `target`; to rounding.
  double nearest(double sense, const Vec2d& target, double start, double from, double to) const;

 private:
  struct Jet {
    Vec2d value, first, second;
    bool closes = false;
  };
  Jet jet(double crank_angle) const;
  struct Position {
    Vec2d crank;
    LinkDirections<double> links;
  };
  Position position(double crank_angle) const;

  Vec2d pivot_, axes_, coupler_point_;
  Lengths<double> links_;
  HalfClosure<double> near_, far_;  ///< where the crank points towards D, and away
  double assembly_;
};

}  // namespace cognate::problems
