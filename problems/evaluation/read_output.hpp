/// @file `[output]`: what of an analysis is requested.
#pragma once

#include <string_view>

#include "problems/evaluation/problem.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The key that requests Roberts' cognates.
inline constexpr std::string_view kCognates = "cognates";
inline constexpr std::string_view kCurve = "curve";

/// The quantities that `table` requests, by `want = [...]`, a list of quantities and points, or by
/// a key for each quantity and `points = [...]`; by `instant_geometry` the names of bodies, and
/// `cognates`, and by `foot` a point whose gait is measured. `forces`: whether reactions and torque
/// are requested where the file does not say. `slides`: the drive is no crank.
AnalysisOutput read_output(TableReader& table, const PartNames& names, bool forces, bool slides);

}  // namespace cognate::problems::reading
