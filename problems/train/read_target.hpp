/// @file `[target]`, `[bounds]` and `[solve]` of a gear train that is to be found.
#pragma once

#include "problems/toml/table_reader.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems::reading {

TrainTarget read_train_target(TableReader& document);

/// How many products of that many teeth, each from `bounds`, a search may hold.
inline constexpr double kMostProducts = 8e6;

/// In how many ways `pairs` teeth can be taken, their order aside.
double product_count(const std::array<int, 2>& bounds, int pairs);

}  // namespace cognate::problems::reading
