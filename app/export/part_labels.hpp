/// @file Where the names of parts are written.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/export/link_parts.hpp"

namespace cognate::app {

/// The lower left corner of a line of text and its height.
struct PartLabel {
  Vec2d at{};
  double height = 0;
};

/// The greatest height of a part's label, and that of one beside its part.
double label_height(const PartOrder& order);

/// Where `text` can be written along the x axis within `part`, turned by `direction`, clear of its
/// rim, holes and slots: as high as possible, and as near to the middle. Empty where it cannot.
std::optional<PartLabel> label_within(const LinkPart& part, const Vec2d& direction,
                                      const PartOrder& order, const std::string& text);

}  // namespace cognate::app
