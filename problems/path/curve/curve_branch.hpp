/// @file The coupler curve of a four-bar on one branch, by the crank angle, in the frame's axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/four_bar.hpp"

namespace cognate::problems {

/// How a place along the motion stands for a crank angle. Of a crank that turns fully the place is
/// the angle times its sense. Else the angle goes to and fro between the ends of its range as a
/// cosine: near a dead point the coupler moves by the root of the angle, and evenly with the place.
struct Travel {
  double sense = 1;
  bool turns = true;
  double middle = 0, half = 0;  ///< of the range, of the angle times the sense

  double along(double at) const { return turns ? at : middle - half * std::cos(at); }
  /// The crank angle and its derivatives by the place.
  double angle(double at) const { return sense * along(at); }
  double slope(double at) const { return sense * (turns ? 1 : half * std::sin(at)); }
  double second(double at) const { return turns ? 0 : sense * half * std::cos(at); }
  /// The place at an angle times the sense.
  double place(double along) const {
    return turns ? along : std::acos(std::clamp((middle - along) / half, -1.0, 1.0));
  }
};

/// A place of the curve along the motion.
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

  /// How far the coupler point is from `target`; infinite where the linkage does not close.
  double distance(double crank_angle, const Vec2d& target) const;

  /// Fills `all` with points from `from` to `to` along the motion, ends included, close enough that
  /// no chord is longer than some sixtieth of the curve, as far as a few halvings of the steps
  /// reach. `spare` is overwritten.
  void sample(const Travel& travel, double from, double to, std::vector<CurveSample>& all,
              std::vector<CurveSample>& spare) const;

  /// The place along the motion, within [from, to], to which descent from `start` leads of the
  /// distance from `target`; to rounding.
  double nearest(const Travel& travel, const Vec2d& target, double start, double from,
                 double to) const;

 private:
  struct Jet {
    Vec2d value, first, second;
    bool closes = false;
  };
  Jet jet(const Travel& travel, double at) const;
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
