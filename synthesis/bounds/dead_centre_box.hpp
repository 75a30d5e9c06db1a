/// @file The crank angle of the rocker's limit positions over a box of proportions.
#pragma once

#include <optional>

#include "synthesis/bounds/proportion_box.hpp"

namespace cognate::synthesis {

enum class LimitOfOutput { outer, inner };  ///< crank and coupler extended or folded

/// The crank angle from A→D at a limit position, over the first three sides of a box.
struct LimitAngle {
  double middle = 0;  ///< at the box's middle
  /// For t in [−1, 1]³ the angle exceeds `middle` by slope·t, up to `radius`.
  std::array<double, 3> slope{};
  double radius = 0;
  double reach = 0;  ///< by how much it may differ from `middle` in all
};

/// Empty where no linkage of the box has that limit position. From the triangle A–C–D with the side
/// A–C = l₁ + l₂ or l₂ − l₁, its terms divided by l₂ + l₃ so that infinite lengths are no
/// exception.
std::optional<LimitAngle> limit_angle(const ProportionBox& box, LimitOfOutput limit);

}  // namespace cognate::synthesis
