/// @file Outlines at a distance from others, as a beam of some width cuts them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/drawing/plan.hpp"

namespace cognate::app {

/// The outline `distance` outside `outline`, which is closed and runs counter-clockwise (inside
/// where the distance is negative): the boundary of all points nearer to it than that. Lines stay
/// lines and arcs stay arcs; about a corner from which the two sides part lies an arc, unless their
/// own intersection is nearer than `slack` to it.
///
/// Empty where a side of the outline vanishes, or the sides of what is left cross each other: a
/// beam of that radius does not fit everywhere.
std::optional<PlanOutline> offset_outline(const PlanOutline& outline, double distance,
                                          double slack = 0);

/// The outline at `distance` about the convex polygon `hull`: lines and arcs, at no
/// distance its corners. None of a mere point.
PlanOutline rounded_outline(const std::string& layer, const std::vector<Vec2d>& hull,
                            double distance);

}  // namespace cognate::app
