/// @file A drawing in layers, independent of the format it is written in.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "problems/basics/length_unit.hpp"

namespace cognate::app {

enum class PlanColour { foreground, accent, grey, red, green };

/// Every shape lies on one of these. Names are those of CAD: capitals, digits and underscores.
struct PlanLayer {
  std::string name;
  PlanColour colour = PlanColour::foreground;
  bool dashed = false;  ///< in pictures
};

/// A corner of an outline. `bulge` is that of DXF: the tangent of a quarter of the angle of the arc
/// from here to the next corner, positive counter-clockwise, 0 for a straight line.
struct PlanCorner {
  Vec2d at{};
  double bulge = 0;
};

struct PlanOutline {
  std::string layer;
  std::vector<PlanCorner> corners;
  bool closed = false;
};

struct PlanCircle {
  std::string layer;
  Vec2d centre{};
  double radius = 0;
};

/// One line of text whose lower left corner is `at`.
struct PlanLabel {
  std::string layer;
  Vec2d at{};
  double height = 0;
  std::string text;
};

/// y points upwards.
struct Plan {
  std::string title;
  std::optional<problems::LengthUnit> length_unit{};
  Vec2d low{}, high{};  ///< corners of the rectangle that it fills
  std::vector<PlanLayer> layers;
  std::vector<PlanOutline> outlines;
  std::vector<PlanCircle> circles;
  std::vector<PlanLabel> labels;
};

/// Makes `low` and `high` the corners of the least rectangle that holds all outlines, circles and
/// labels, or a little more where an arc bulges.
void fit_to_shapes(Plan& plan);

/// How wide a line of text is, about: fonts differ.
double text_width(std::string_view text, double height);

/// A straight line from `from` to `to`.
PlanOutline plan_line(const std::string& layer, const Vec2d& from, const Vec2d& to);

}  // namespace cognate::app
