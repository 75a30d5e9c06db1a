/// @file Problem files of every kind.
#pragma once

#include "problems/kinds.hpp"
#include "problems/read.hpp"
