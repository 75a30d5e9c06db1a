/// @file The coordinate by which the output of a mechanism is counted.
#pragma once

#include "analysis/mechanism/travel.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

/// The angle of an output that turns (radians), the displacement along its slide of one that does
/// not.
Travel output_travel(const NamedMechanism& mechanism);

}  // namespace cognate::problems
