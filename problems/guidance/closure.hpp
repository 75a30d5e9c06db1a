/// @file A body held at a crank pin and turned by a second dyad: its angle, and what that depends
/// on.
#pragma once

#include <array>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::problems {

/// The second dyad's dimensions: rr moving pivot u, v, fixed pivot x, y, length; pr moving pivot
/// u, v, angle of the slide line's normal, distance of the line from the origin along it; rp fixed
/// pivot x, y, angle of the normal of the body's line (body axes), its distance from the body's
/// origin.
using SecondDyad = std::array<double, 5>;

/// The dimensions of a dyad, and the dyad of dimensions: any of its points that may be chosen
/// freely on a line is the one nearest to where it stands at `first`, a pose.
SecondDyad second_dyad(const synthesis::GuidingDyad& dyad);
synthesis::GuidingDyad guiding_dyad(synthesis::DyadKind kind, const SecondDyad& second,
                                    const synthesis::Pose& first);

/// The body is to turn to the unit vector E for which Re(k E) = h.
struct TurnCondition {
  Vec2d k;
  double h = 0;

  /// |k|² − h²: negative where no angle does it, 0 at a dead point.
  double discriminant() const;
  /// On the side of `sign`, that of Im(k E).
  Vec2d turn(double sign) const;
};

/// `pin`: where the crank holds the body's point `first` (body axes).
TurnCondition turn_condition(synthesis::DyadKind kind, const SecondDyad& second, const Vec2d& first,
                             const Vec2d& pin);

/// Derivatives of the condition F of motion_model.hpp.
struct TurnSlopes {
  double turn = 0;  ///< by the body's angle
  Vec2d pin, first;
  SecondDyad second{};
};
TurnSlopes turn_slopes(synthesis::DyadKind kind, const SecondDyad& second, const Vec2d& first,
                       const Vec2d& pin, const Vec2d& turn);

/// Where a crank (first dyad, a link) may stand for a second dyad to close, as angles from the x
/// axis: the whole turn, one arc or two. With θ counted from A→D, from the line's normal or from
/// A to the second fixed pivot the condition is in each case lo ≤ cos θ ≤ hi.
std::vector<CrankRange> closing_arcs(synthesis::DyadKind kind, const synthesis::GuidingDyad& crank,
                                     const SecondDyad& second);

}  // namespace cognate::problems
