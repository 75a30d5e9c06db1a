/// @file The crank angles of a linkage whose dimensions are held.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problems/guidance/model.hpp"

namespace cognate::problems {

/// Crank angles of `pair` without jumps by whole turns along the arc on which it closes, where one
/// has them all.
std::vector<double> along_arc(const DyadPair& pair, std::vector<double> crank_angles);

/// The form of `pair` in which each pose has a crank angle of its own. Where limits hold between
/// the ends of the motion, these are variables: the first and last pose, or where no order is
/// demanded those whose `crank_angles`, along an arc, are furthest apart.
MotionForm unpooled_form(const MotionProblem& problem, const DyadPair& pair,
                         std::span<const double> crank_angles);

/// `x` of the model of such a form with its local crank angles where each pose is nearest, by
/// Gauss–Newton steps from those it has; where these break the order or the circuit that the
/// constraints demand, with angles that keep them (see in_order), which poses may then share.
/// Empty where the linkage does not close.
std::optional<std::vector<double>> placed_cranks(const MotionProblem& problem,
                                                 const MotionForm& form, std::vector<double> x);

}  // namespace cognate::problems
