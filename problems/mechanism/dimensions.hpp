/// @file The dimensions by which a mechanism is known: its lengths and offset.
#pragma once

#include <string>
#include <vector>

#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

struct Dimension {
  std::string name;
  double value = 0;
};

/// Crank, coupler, rocker and frame of a four-bar; the lengths and offsets of other types that are
/// not zero for every mechanism of their kind. Those of one type are always the same ones, in the
/// same order; except of a chain, which has the lengths of its links, the frame where it has two
/// pivots, and how far its further points are out on their bodies.
std::vector<Dimension> main_dimensions(const NamedMechanism& mechanism);

}  // namespace cognate::problems
