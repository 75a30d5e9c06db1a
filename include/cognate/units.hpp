/// @file Angles, speeds and bounds as people write them.
#pragma once

#include "problems/basics/units.hpp"
