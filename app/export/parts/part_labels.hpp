/// @file The names of parts on the parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/drawing/plan.hpp"
#include "app/export/parts/link_parts.hpp"

namespace cognate::app {

/// The lower left corner of a line of text and its height; no text where that is 0.
struct PartLabel {
  Vec2d at{};
  double height = 0;
  Vec2d direction{1, 0};  ///< of the line; only strokes have another
};

/// Where `text` can be written along the x axis within `part`, turned by `direction`, clear of its
/// rim, holes and slots: as high as possible, and as near to the middle. Empty where it cannot.
std::optional<PartLabel> label_within(const LinkPart& part, const Vec2d& direction,
                                      const PartOrder& order, const std::string& text);

/// The height of a label beside its part.
double label_height(const PartOrder& order);

/// How wide `text` is as `order` wants it written.
double label_width(const PartOrder& order, const std::string& text, double height);

/// Writes `text` at `label`: on LABELS as text, or on ENGRAVE as open outlines.
void add_label(const PartOrder& order, const PartLabel& label, const std::string& text, Plan& plan);

}  // namespace cognate::app
