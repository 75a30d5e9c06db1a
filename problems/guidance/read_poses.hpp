/// @file `target.poses` and `target.segments`: where a body is to stand.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "problems/toml/table_reader.hpp"
#include "synthesis/exact/motion/pose.hpp"

namespace cognate::problems::reading {

/// The poses of a file; where it gives segments, those as written too.
struct GivenPoses {
  std::vector<synthesis::Pose> poses;
  std::vector<std::array<Vec2d, 2>> segments;
};

/// At least `least` of them; fewer after a fault.
GivenPoses read_poses(TableReader& target, std::size_t least);

}  // namespace cognate::problems::reading
