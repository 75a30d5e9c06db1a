/// @file Path generation: a coupler point through points or along a closed curve.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/problem.hpp"
