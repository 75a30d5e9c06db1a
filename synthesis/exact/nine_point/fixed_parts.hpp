/// @file Parts of a four-bar that are given beside its positions, as equations.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"
#include "synthesis/exact/nine_point/side_condition.hpp"

namespace cognate::synthesis {

/// Dimensions of the four-bar that are known, in the unit and plane of the positions; angles in
/// radians. The first dyad is crank and pivot A, the second rocker and pivot D. `coupler_point`, in
/// the coupler's frame, counts only with `coupler`.
struct FixedParts {
  std::optional<Vec2d> pivot_a, pivot_d, coupler_point;
  std::optional<double> frame_angle, crank, coupler, rocker, frame;
};

/// The same parts in as few conditions: two of frame, its angle and a pivot give the other pivot;
/// what both pivots say already is left out.
FixedParts without_repetition(const FixedParts& given);

/// How many real conditions they are: two for a pivot or the coupler point, one for a length or
/// angle.
int condition_count(const FixedParts& given);

/// The conditions in the coordinates of `system`.
std::vector<SideCondition> side_conditions(const FixedParts& given, const PathSystem& system);

/// Conditions of the same kind and order that `u`, any complex numbers, satisfy.
std::vector<SideCondition> side_conditions_at(const FixedParts& kind,
                                              const PivotUnknowns<std::complex<double>>& u);

}  // namespace cognate::synthesis
