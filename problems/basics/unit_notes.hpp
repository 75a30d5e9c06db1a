/// @file Doubts about the unit of lengths where forces depend on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "problems/basics/length_unit.hpp"

namespace cognate::problems {

/// What in a file with masses or loads depends on the unit of its lengths.
struct WeighedLengths {
  std::optional<LengthUnit> unit;
  Vec2d gravity{};
  double longest = 0;  ///< link, in the file's unit
};

/// A note where no unit is given though gravity is that of the Earth in mm/s² or a link is longer
/// than 20; and where gravity is that of the Earth in m/s² though another unit is given.
std::vector<std::string> unit_notes(const WeighedLengths& lengths);

}  // namespace cognate::problems
