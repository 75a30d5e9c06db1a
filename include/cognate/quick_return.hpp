/// @file Quick returns: a stroke back in less time than forth.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/quick_return/problem.hpp"
