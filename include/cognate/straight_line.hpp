/// @file Straight lines: coupler points on a straight segment.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/straight_line/problem.hpp"
