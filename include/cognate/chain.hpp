/// @file Paths of six-bars, eight-bars and chains of dyads.
#pragma once

#include "problems/chain/problem.hpp"
#include "problems/chain/topology.hpp"
#include "problems/linkage/result.hpp"
