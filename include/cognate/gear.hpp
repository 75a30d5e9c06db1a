/// @file Gears and pairs of them: analysis and design.
#pragma once

#include "problems/gear/problem.hpp"
#include "problems/gear/result.hpp"
