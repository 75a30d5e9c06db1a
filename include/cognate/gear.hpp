/// @file Gears, pairs and trains of them: analysis and design.
#pragma once

#include "problems/gear/problem.hpp"
#include "problems/gear/result.hpp"
#include "problems/train/problem.hpp"
#include "problems/train/result.hpp"
