/// @file Gears as result files tell of them.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/gear_plan.hpp"
#include "app/export/result_document.hpp"

namespace cognate::app {

/// A gear, or the two of a pair in mesh.
struct ResultGears {
  std::string title;
  std::string gearing;
  std::vector<GearPose> gears;
  std::vector<std::string> notes;  ///< what is wrong with them
};

/// The gears of a design whose mechanism is of type "gear" or "gear-pair", made anew of its table
/// `mechanism`. The error is a message that begins with the document's name: what is wrong; what is
/// allowed.
tl::expected<ResultGears, std::string> result_gears(const ResultDesign& given);

}  // namespace cognate::app
