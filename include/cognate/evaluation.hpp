/// @file What a given mechanism does over its drive (kind = "analysis").
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/result.hpp"
