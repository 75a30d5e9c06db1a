/// @file Closed curves from what a file draws.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "problems/path/curve/closed_curve.hpp"
#include "problems/path/curve/svg_path_data.hpp"

namespace cognate::problems::reading {

/// The polyline through `vertices`, closed; what repeats its neighbour counts once. Else what is
/// wrong and what is requested: fewer than three different vertices, or so little extent beside the
/// distance from the origin that digits are lost.
tl::expected<ClosedCurve, std::string> closed_polyline(const std::vector<Vec2d>& vertices);

/// The one closed subpath of SVG path data with y turned upwards, each curve as so many chords that
/// the arc length is true to 1e-6 where there are few curves. It is closed by Z, or where its end
/// is its beginning to 1e-6 of its extent.
tl::expected<ClosedCurve, PathDataFault> closed_outline(std::string_view path_data);

}  // namespace cognate::problems::reading
