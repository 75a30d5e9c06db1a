/// @file Derivatives of a mechanism's points by the dimensions that its keys name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::python {

/// A number of a key, "crank", "fixed_pivots[0][1]", "dyad[1].lengths[0]", "direction_deg" (by the
/// degree), and how the mechanism changes with it.
struct Dimension {
  std::string name;
  std::vector<double> numbers;  ///< derivatives of the mechanism's numbers, in convert's order
  std::vector<Vec2d> points;    ///< derivatives of the points' places on their bodies
};

/// All dimensions of a mechanism, those of its further points included.
std::vector<Dimension> dimensions_of(const problems::NamedMechanism& mechanism);

/// ∂x and ∂y of point `index` by `dimension` at `angles` of the drive, by dual numbers.
void point_gradient(const problems::NamedMechanism& mechanism, const Dimension& dimension,
                    std::size_t index, std::span<const double> angles, std::span<double> x,
                    std::span<double> y);

}  // namespace cognate::python
