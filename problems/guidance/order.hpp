/// @file Poses met in order on one circuit: at which crank angles a mechanism comes nearest to
/// them.
#pragma once

#include <optional>
#include <vector>

#include "problems/guidance/model.hpp"

namespace cognate::problems {

/// A form and the variables of its model.
struct OrderedMotion {
  MotionForm form;
  std::vector<double> x;
};

/// `motion` with crank angles that the constraints on circuit and order allow, all of them on one
/// circuit and, where order is demanded, following one another in one sense, once round at most.
/// Of the angles that its stations have and some evenly spread ones, those with the least sum of
/// squared errors are taken; neighbours that take the same angle become one station, as the
/// pooling of adjacent violators does (Barlow, Bartholomew, Bremner & Brunk 1972, "Statistical
/// inference under order restrictions").
///
/// Without an order the stations furthest apart become the form's ends.
///
/// Empty where the angles are in order as they are (and limits between the ends of the motion, if
/// there are any, are the model's already), where the poses are on two sides, and where no
/// such angles exist.
std::optional<OrderedMotion> in_order(const MotionProblem& scaled, const OrderedMotion& motion);

/// `motion`, a minimum of its model, with each station parted in two where its first poses would be
/// nearer at an earlier crank angle and its last ones at a later one: where the multiplier of their
/// order is negative. Empty where no station is to be parted, as at a minimum among all motions in
/// order.
std::optional<OrderedMotion> parted(const MotionProblem& scaled, const OrderedMotion& motion);

}  // namespace cognate::problems
