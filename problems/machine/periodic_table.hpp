/// @file Tables over a turn that begin anew with the next one.
#pragma once

#include <utility>
#include <vector>

#include "problems/toml/interpolation.hpp"

namespace cognate::problems::reading {

/// The function of an angle in radians, of any number of turns, through `table`, (angle, value)
/// with increasing angles less than a turn apart: straight lines from row to row and from the last
/// to the first of the next turn, or, where `smooth`, the cubic of `interpolant`. At a row the
/// slope of straight lines is that of the line that begins there.
Interpolant periodic(const std::vector<std::pair<double, double>>& table, bool smooth);

/// `angle` less whole turns, in [0, 2π).
double within_turn(double angle);

}  // namespace cognate::problems::reading
