/// @file A link with three pins among the parts of a mechanism: the group of four bodies that its
/// lines make, and back.
#pragma once

#include <string>
#include <vector>

#include "analysis/mechanism/group.hpp"
#include "problems/chain/places.hpp"
#include "problems/chain/topology.hpp"

namespace cognate::problems {

/// The names of its links, of which `last` is the last line: those that hold its three pins, then
/// its own: "BC", "DE", "GF", "CEF".
std::vector<std::string> three_pin_names(const Topology& topology, int last);

/// Both forms of the group.
struct ThreePinGroup {
  Group group;
  GroupDescription description;
};

/// The link whose last line is `last`, drawn with the crank at angle 0. `at`: the points of all
/// lines there; `bodies`: the names of those before it.
ThreePinGroup three_pin_group(const Topology& topology, const ChainPlaces& places, int last,
                              const std::vector<Vec2d>& at, const std::vector<std::string>& bodies);

/// The parameters of the six lines of a link, as `three_pin_group` made it of them.
std::vector<double> three_pin_parameters(const Group& group);

}  // namespace cognate::problems
