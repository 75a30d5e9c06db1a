/// @file Bodies that a link of a six-bar or of any chain of dyads carries through poses.
#pragma once

#include "problems/chain/topology.hpp"
#include "problems/chain_motion/problem.hpp"
#include "problems/linkage/result.hpp"
