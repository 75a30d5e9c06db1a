/// @file Mechanisms with two sliding and two turning joints, as data.
#pragma once

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A crank whose pin runs in the slot of a yoke that slides on the frame. With the slot across the
/// slide the yoke's displacement is the crank's cosine from `direction`: the sine mechanism.
struct ScotchYoke {
  Vec2d pivot;
  double crank = 0;       ///< positive
  double offset = 0;      ///< distance of the slide line from the pivot, positive to its left
  Vec2d direction{1, 0};  ///< unit vector of the slide line
  Vec2d slot{0, 1};       ///< unit vector of the slot from `direction`; not parallel to it
};

/// A lever with a slot, turning about a pivot, drives the pin of a slider on a line of the frame.
/// With the lever leaning by ψ from the perpendicular on that line towards `direction`, the slider
/// stands at |offset|·tan ψ.
struct TangentGenerator {
  Vec2d pivot;
  double offset = 0;  ///< distance of the slide line from the pivot, positive to its left; not 0
  Vec2d direction{1, 0};  ///< unit vector of the slide line
};

/// A link whose two pins slide on two crossing lines of the frame: its points trace ellipses.
struct EllipticTrammel {
  Vec2d centre;             ///< where the lines cross
  double length = 0;        ///< between the pins, positive
  Vec2d direction{1, 0};    ///< unit vector of the line of the first pin
  Vec2d second_line{0, 1};  ///< unit vector of the other line from `direction`; not parallel to it
};

/// Two parallel shafts, each with a slot, and a disc between them with a tongue in either: it turns
/// the driven shaft exactly as the driving one.
struct OldhamCoupling {
  Vec2d pivot_a;     ///< of the driving shaft
  Vec2d pivot_d;     ///< of the driven shaft
  Vec2d slot{0, 1};  ///< unit vector of the second tongue from the first; not parallel to it
};

/// A crank and an RPP dyad: body 1 is the crank, 2 the block on its pin, 3 the yoke.
Mechanism<double> as_mechanism(const ScotchYoke& mechanism);

/// A crank as long as the offset and a PRP dyad: body 1 is the lever (its first axis along the
/// slot), 2 the block in the slot, 3 the slider.
Mechanism<double> as_mechanism(const TangentGenerator& mechanism);

/// A floating link: body 1 is the link (its origin at the first pin, its first axis towards the
/// second), 2 and 3 the blocks.
Mechanism<double> as_mechanism(const EllipticTrammel& mechanism);

/// A crank as long as the distance of the shafts and an RPP dyad: body 1 is the driving shaft (its
/// first axis along its slot), 2 the driven shaft (its first axis along its slot), 3 the disc (its
/// origin where the tongues cross).
Mechanism<double> as_mechanism(const OldhamCoupling& mechanism);

}  // namespace cognate
