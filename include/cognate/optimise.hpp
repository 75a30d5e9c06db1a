/// @file Models of a user's own, and the solvers for them: cognate::synthesis.
#pragma once

#include "synthesis/optimise/loss.hpp"
#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"
