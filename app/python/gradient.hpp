/// @file Derivatives of a mechanism's points by the dimensions that its keys name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::python {

/// A number of a key: "crank", "fixed_pivots[0][1]", "direction_deg" (by the degree).
struct Dimension {
  std::string name;
  problems::NamedMechanism moved;  ///< the mechanism with this dimension changed by `step`
  double step = 1;
};

/// All of a mechanism; none of a chain. Numbers of a mechanism are linear in its dimensions (angles
/// enter by their unit vectors, which are moved along their tangents), so that `moved` less the
/// mechanism, over the step, is their derivative but for roundings, however long the step.
std::vector<Dimension> dimensions_of(const problems::NamedMechanism& mechanism);

/// ∂x and ∂y of point `index` by `dimension` at `angles` of the drive, by dual numbers.
void point_gradient(const problems::NamedMechanism& mechanism, const Dimension& dimension,
                    std::size_t index, std::span<const double> angles, std::span<double> x,
                    std::span<double> y);

}  // namespace cognate::python
