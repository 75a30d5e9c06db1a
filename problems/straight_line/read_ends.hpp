/// @file `target.ends`: where a straight line lies in the plane.
#pragma once

#include "problems/straight_line/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `target.ends`, with the length and the direction that they are, which the file may say only if
/// they are the same. The other keys of `goal` have been read.
void read_ends(TableReader& target, StraightLineGoal& goal);

}  // namespace cognate::problems::reading
