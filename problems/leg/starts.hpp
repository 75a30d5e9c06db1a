/// @file Legs from which a fit begins.
#pragma once

#include <optional>
#include <random>

#include "analysis/mechanism/gait.hpp"
#include "problems/leg/model.hpp"

namespace cognate::problems {

/// The gait of a leg in the unit of its space, by its point form.
std::optional<Gait> gait_of(const LegSpace& space, const synthesis::ChainDesign& chain,
                            double duty);

/// A leg with its stance of the duty factor `duty`, as `gait` finds it, and where it may be moved
/// enlarged to the stride; empty where it cannot be assembled all along.
std::optional<LegDesign> with_stance(const LegSpace& space, synthesis::ChainDesign chain,
                                     double duty);
/// The same of the problem's duty factor.
std::optional<LegDesign> with_stance(const LegSpace& space, synthesis::ChainDesign chain);

/// The best of many chains drawn at random: of each, that part of the foot's path which is nearest
/// to a straight line on one side of the rest. A leg that may be moved is turned and enlarged so
/// that this is a stance of the stride.
std::optional<LegDesign> draw_leg(const LegSpace& space, std::mt19937_64& random);

/// Of a space with a published leg: the flattest of many that walk, with nearly its lengths, but
/// with the pivots in any direction from that of the crank and dyads and points on either side.
std::optional<LegDesign> draw_beside_known(const LegSpace& space, std::mt19937_64& random);

}  // namespace cognate::problems
