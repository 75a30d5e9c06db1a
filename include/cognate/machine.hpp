/// @file Machines: how a driven and loaded mechanism runs.
#pragma once

#include "problems/machine/problem.hpp"
#include "problems/machine/result.hpp"
