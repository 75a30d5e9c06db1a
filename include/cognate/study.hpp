/// @file Studies: a base file with other numbers.
#pragma once

#include "problems/study/read.hpp"
#include "problems/study/study.hpp"
