/// @file Legs fitted to their limits, and legs as they are.
#pragma once

#include <limits>

#include "problems/leg/model.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// Violations of the constraints up to these are none; the greater while searching.
inline constexpr double kFeasibleLeg = 0.6 * kLegMargin, kNearlyFeasibleLeg = 3e-3;
inline constexpr double kNoFit = std::numeric_limits<double>::infinity();

/// A leg, in the unit of its space.
struct FittedLeg {
  LegDesign design;
  /// Half band over stride; with LegObjective::duty the share of the turn out of stance, from 1 on
  /// where the flattest stance leaves the band.
  double objective = kNoFit;
  double violation = kNoFit;
  int hits = 1;
  bool is_feasible = false;  ///< with the stance that `gait` finds
};

/// How closely a fit is to be made.
struct FitDepth {
  int nodes, exchanges;
  synthesis::Options options;
};

/// The fit of the problem's objective. The longest stance is sought from a flat one; where the
/// flattest leaves the band, that is kept for further starts.
FittedLeg fitted_leg(const LegSpace& space, const LegDesign& start, const FitDepth& depth,
                     const synthesis::WorkCounter& work);

/// A leg as it is, with the stance that `gait` finds at the duty factor `duty`. No fit where it
/// cannot be assembled all along or leaves the bounds.
FittedLeg measured(const LegSpace& space, const synthesis::ChainDesign& chain, double duty);

/// `fit`, with the answer to whether it is feasible.
FittedLeg judged(const LegSpace& space, FittedLeg fit);

/// Whether `other` is feasible and `fit` is not, or is worse.
bool is_better(const FittedLeg& other, const FittedLeg& fit);

/// The longest stance within the limits that the dimensions of a feasible leg have.
FittedLeg lengthened(const LegSpace& space, const FittedLeg& leg);

}  // namespace cognate::problems
