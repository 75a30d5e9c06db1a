/// @file The outlines of gears as they are exported.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/gear/tooth_outline.hpp"
#include "app/export/plan.hpp"
#include "app/export/result_gears.hpp"

namespace cognate::app {

/// The closed outline of a gear where it stands, counter-clockwise.
struct DrawnGear {
  PlacedGear gear;
  std::vector<gear::OutlinePoint> points;
};

struct GearDrawing {
  std::string title;
  double chord_tolerance = 0;
  std::vector<DrawnGear> gears;
};

/// The outlines of `given`, whose chords leave the curves by `chord_tolerance` at most (empty: 1e-3
/// of the transverse module). The error says which tolerances are possible.
tl::expected<GearDrawing, std::string> gear_drawing(const ResultGears& given,
                                                    std::optional<double> chord_tolerance);

/// The outlines with their arcs of root and tip circles as arcs, on the layer OUTLINE; the circles
/// BASE_CIRCLE, PITCH_CIRCLE, TIP_CIRCLE, ROOT_CIRCLE; a cross at each CENTRE.
Plan gear_plan(const GearDrawing& drawing);

/// Rows of x, y, radius about the gear's own centre, and the part that the chord to the point
/// stands for: root, fillet, involute, tip.
std::string csv_text(const DrawnGear& gear);

/// The document `cognate-gears/1`: for each gear its circles, its place and its outline.
std::string gears_document(const ResultGears& given, const GearDrawing& drawing);

}  // namespace cognate::app
