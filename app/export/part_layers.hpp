/// @file In which layer each part of a linkage lies, so that the parts pass one another.
#pragma once

#include <string>
#include <vector>

#include "app/export/link_parts.hpp"

namespace cognate::app {

struct PartLayers {
  std::vector<int> layers;  ///< of each part, from 1
  int count = 0;            ///< how many there are
  std::vector<std::string> notes;
};

/// The fewest layers in which parts that overlap anywhere on the way of the drive lie in different
/// ones, and no pin that goes through a layer meets another part there: found by trying layers part
/// by part, with positions at samples of the drive. Where that takes too many trials, or there is
/// no such stack, a note says so, and the parts alone are kept apart.
PartLayers part_layers(const LinkShapes& shown, const LinkParts& made, const PartOrder& order);

}  // namespace cognate::app
