/// @file Deep groove ball bearings of small bores.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cognate::app {

/// Boundary dimensions in millimetres, those of ISO 15.
struct Bearing {
  std::string_view designation;  ///< "608", "619/5"
  double bore = 0, outside = 0, width = 0;
};

/// The bearing of this designation; empty where the table has none.
std::optional<Bearing> bearing_called(std::string_view designation);

/// Those of the same bore with a smaller outside diameter, the largest first.
std::vector<Bearing> slimmer_bearings(const Bearing& bearing);

/// What is allowed as a designation, in words.
std::string bearing_designations();

}  // namespace cognate::app
