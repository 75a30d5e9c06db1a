/// @file In which plane each part of a linkage lies, so that the parts pass one another.
#pragma once

#include <string>
#include <vector>

#include "app/export/link_parts.hpp"

namespace cognate::app {

struct PartPlanes {
  std::vector<int> planes;  ///< of each part, from 1
  int count = 0;            ///< how many there are
  std::vector<std::string> notes;
};

/// The fewest planes in which parts that overlap anywhere on the way of the drive lie in different
/// ones, and no pin that goes through a plane meets another part there: found by trying planes part
/// by part, with positions at samples of the drive. Where that takes too many trials, or there is
/// no such stack, a note says so, and the parts alone are kept apart.
PartPlanes part_planes(const ShownLinks& shown, const LinkParts& made, const PartOrder& order);

}  // namespace cognate::app
