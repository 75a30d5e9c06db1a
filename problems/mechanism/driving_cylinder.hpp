/// @file Whether a cylinder drives a mechanism.
#pragma once

#include <variant>

#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

/// Whether a cylinder drives it, whose rod and barrel are one part between the same layers.
inline bool has_driving_cylinder(const NamedMechanism& mechanism) {
  return std::holds_alternative<DrivingRod<double>>(mechanism.mechanism.drive);
}

}  // namespace cognate::problems
