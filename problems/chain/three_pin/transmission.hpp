/// @file The transmission angles of the links that hold a three-pin link, measured by the kernel.
#pragma once

#include <array>

#include "analysis/mechanism/assembly_ranges.hpp"

namespace cognate::problems {

/// Of the group at `dyad`, as `three_pin_group` makes it: of each of the links that hold its three
/// pins the least transmission angle over `motion`, acute, radians. It is the angle between the
/// link and the line from its pin to the pole about which the three-pin link turns if the other
/// two alone hold it.
std::array<double, 3> least_pin_transmission(const Mechanism<double>& mechanism,
                                             const AssemblyRanges& motion, int dyad);

/// Whether the mechanism stands at the end of a whole turn where it stood at its beginning.
bool returns_after_turn(const Mechanism<double>& mechanism, const AssemblyRanges& turn);

}  // namespace cognate::problems
