/// @file Functions of a crank's angle that a link of a six-bar or of any chain of dyads follows.
#pragma once

#include "problems/chain/topology.hpp"
#include "problems/chain_function/problem.hpp"
#include "problems/linkage/result.hpp"
