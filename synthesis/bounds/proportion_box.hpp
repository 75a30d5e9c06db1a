/// @file Boxes of the four-bars' proportions and crank phases, and where a link points over a box.
///
/// With frame + crank = 1 let k be the frame, δ = coupler − rocker and s = 1/(coupler + rocker). At
/// the crank angle θ from A→D the diagonal is D − B = k − (1 − k)e^{iθ}, of length d and angle ψ.
/// With a = δ/d and b = s·d the triangle B–C–D has at B the angle β with
///
///     cos β = (a + b)/(1 + a b),   tan(β/2) = √((1 − a)(1 − b)/((1 + a)(1 + b))),
///
/// (from the law of cosines), at D the same with −a for a; it closes where |a| ≤ 1 and b ≤ 1. All
/// proportions, infinitely long couplers and rockers (s = 0) among them, lie in a bounded region.
/// The crank turns fully where |δ| ≤ |2k − 1| and s ≤ 1; then δ = |2k − 1| cos ξ and s = cos η,
/// which keeps β's derivatives bounded up to the change points, and fill a box.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/bounds/interval.hpp"

namespace cognate::synthesis {

inline constexpr int kBoxSides = 4;

/// Which proportions a box's sides 1 and 2 stand for; side 0 is k, side 3 the phase, which is added
/// to the crank angles.
enum class Proportions {
  crank_shortest,  ///< ξ in [0, π] and η in [0, π/2], k ≥ 1/2
  frame_shortest,  ///< ξ in [0, π] and η in [0, π/2], k ≤ 1/2
  any              ///< δ in [−1, 1] and σ in [0, 1), s = σ/(1 − σ)
};

/// A box of proportions and phase, in one assembly (+1 open, −1 crossed).
struct ProportionBox {
  std::array<Interval, kBoxSides> side;
  Proportions proportions = Proportions::any;
  int assembly = 1;
};

/// Lengths over a box, in units of frame + crank, and how far the crank can turn.
struct ProportionRanges {
  Interval frame, crank;
  Interval difference;    ///< δ
  Interval inverse;       ///< s
  Interval inner, outer;  ///< d where the crank points to D, |2k − 1|, and away from it, 1
};

ProportionRanges ranges_of(const ProportionBox& box);

/// The direction of a link over a box at one crank angle. At the box's middle it is `middle`, up to
/// `radius`; for t in [−1, 1]⁴, at middle + t·half width, its angle exceeds that of `middle` by
/// slope·t, up to `radius`.
struct DirectionRange {
  Vec2d middle;
  std::array<double, kBoxSides> slope{};
  double radius = 0;
  /// Of each side roughly what it adds to the radius, which chooses where to divide.
  std::array<double, kBoxSides> doubt{};
  Interval diagonal;   ///< d
  bool closes = true;  ///< false where no linkage of the box closes at this crank angle
};

enum class DirectedLink { coupler, rocker };

/// Enclosures over one box. What all crank angles share is computed once.
class BoxDirections {
 public:
  explicit BoxDirections(const ProportionBox& box);

  /// At crank angle `theta` (radians from A→D, of a few turns at most) plus the phase: along B→C or
  /// D→C, in the frame's axes.
  DirectionRange at(double theta, DirectedLink link) const;

 private:
  struct Place;  ///< what depends on the crank angle
  using Slopes = std::array<Interval, kBoxSides>;

  /// `half`: the direction at half the middle's crank angle.
  void place_triangle(Place& place, double d0, const Vec2d& half) const;
  DirectionRange unknown(DirectionRange range) const;
  void enclose(const Place& place, double sense, DirectionRange& range) const;
  std::array<double, kBoxSides> angle_changes(const Place& place) const;
  Slopes angle_slopes(const Place& place, const Interval& per_square) const;

  ProportionBox box_;
  std::array<double, kBoxSides> middle_{}, half_{};
  bool turning_;
  double side_of_half_;  ///< the derivative of |2k − 1| by k, over 2
  Interval k_, product_, inner_, first_cos_, first_sin_, difference_, inverse_, second_sin_;
  // At the middle.
  double inner0_ = 0, cos0_ = 0, sin0_ = 0, difference0_ = 0, inverse0_ = 0, second_sin0_ = 0;
};

/// The two parts of a box.
std::pair<ProportionBox, ProportionBox> halves(const ProportionBox& box, int side);

/// The side whose halving promises most: that with the greatest part in what the directions are
/// off their linear form by.
int worst_side(const ProportionBox& box, const std::vector<DirectionRange>& directions);

}  // namespace cognate::synthesis
