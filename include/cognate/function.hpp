/// @file Function generation: a follower's angle or displacement as a function of the crank's.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/linkage/result.hpp"
