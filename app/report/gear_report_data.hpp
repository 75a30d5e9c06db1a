/// @file What the page of gears draws.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/gear/result.hpp"

namespace cognate::app {

/// The gear as a design of one gear (see gear_drawing.hpp) with its rack and metrics; `columns` of
/// the result's table.
nlohmann::ordered_json gear_report_data(const problems::GearProblem& problem,
                                        const problems::GearResult& result);

/// For each design its gears, the path of contact on the line of action (from the point where this
/// touches the pinion's base circle), metrics and constraints; of bevel gears their cones, of a
/// worm its section; `quantities` of the enumeration.
nlohmann::ordered_json gear_pair_report_data(const problems::GearPairProblem& problem,
                                             const problems::GearPairResult& result);

}  // namespace cognate::app
