/// @file Motion generation: a body through poses.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"
