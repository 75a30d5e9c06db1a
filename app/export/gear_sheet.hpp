/// @file Gears as they are cut.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/gear_plan.hpp"
#include "app/export/exported.hpp"
#include "app/export/wheel_bore.hpp"

namespace cognate::app {

/// The plan of gears, its outlines on the layer OUTLINE those that a beam of width `kerf` follows.
struct GearSheet {
  std::vector<GearOutline> outlines;  ///< nominal, of each gear
  std::vector<WheelBore> bores;       ///< of each gear
  std::vector<std::size_t> cuts;      ///< of each gear its outline in the plan
  double kerf = 0;
  Plan plan;
};

/// The gears in mesh, but with a kerf apart, so that no cut crosses another. The error says which
/// option is not possible and what is allowed.
tl::expected<GearSheet, std::string> gear_sheet(const ResultGears& given, double kerf,
                                                const WheelOrder& order, double tolerance);

}  // namespace cognate::app
