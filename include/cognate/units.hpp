/// @file Angles, speeds and bounds as people write them.
#pragma once

#include "problems/basics/length_unit.hpp"
#include "problems/basics/units.hpp"
