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
/// Empty where the angles are in order as they are (and limits between the ends of the motion, if
/// there are any, are the model's already), where the poses are on two sides, and where no
/// such angles exist.
std::optional<OrderedMotion> in_order(const MotionProblem& scaled, const OrderedMotion& motion);

}  // namespace cognate::problems
