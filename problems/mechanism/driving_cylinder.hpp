/// @file Whether a cylinder drives a mechanism.
#pragma once

#include <algorithm>
#include <variant>

#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

/// Whether a cylinder drives it, whose rod and barrel are no plates.
inline bool has_driving_cylinder(const NamedMechanism& mechanism) {
  return std::ranges::any_of(mechanism.mechanism.dyads, [](const Dyad<double>& dyad) {
    return std::holds_alternative<Cylinder<double>>(dyad);
  });
}

}  // namespace cognate::problems
