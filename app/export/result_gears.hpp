/// @file Gears as result files tell of them.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/gear/spur_gear.hpp"
#include "analysis/numbers/vec2.hpp"
#include "app/export/result_document.hpp"

namespace cognate::app {

/// A gear by its transverse section, and where it stands.
struct PlacedGear {
  std::string name;  ///< "pinion" or "wheel"; empty of a gear alone
  gear::SpurGear section;
  Vec2d centre{};
  double angle = 0;         ///< that its first tooth has turned counter-clockwise from the y axis
  double pitch_radius = 0;  ///< of the circle on which the pair rolls; alone the reference circle
};

/// A gear, or the two of a pair in mesh.
struct ResultGears {
  std::string title;
  std::string gearing;
  std::vector<PlacedGear> gears;
  std::vector<std::string> notes;  ///< what is wrong with them
};

/// The gears of a design whose mechanism is of type "gear" or "gear-pair", made anew of its table
/// `mechanism`. The error is a message that begins with the document's name: what is wrong; what is
/// allowed.
tl::expected<ResultGears, std::string> result_gears(const ResultDesign& given);

}  // namespace cognate::app
