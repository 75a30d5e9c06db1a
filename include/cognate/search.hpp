/// @file A search from many starts over a model, Pareto fronts, and why constraints cannot be met:
/// cognate::synthesis.
#pragma once

#include "synthesis/search/infeasibility.hpp"
#include "synthesis/search/pareto_front.hpp"
#include "synthesis/search/search.hpp"
