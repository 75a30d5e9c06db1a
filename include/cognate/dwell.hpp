/// @file Mechanisms whose output stands still while the crank turns on.
#pragma once

#include "problems/chain/topology.hpp"
#include "problems/dwell/problem.hpp"
#include "problems/linkage/result.hpp"
