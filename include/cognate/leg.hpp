/// @file Walking legs: the gait of a foot, and legs found for one.
#pragma once

#include "analysis/mechanism/gait.hpp"
#include "problems/chain/topology.hpp"
#include "problems/leg/problem.hpp"
#include "problems/linkage/result.hpp"
