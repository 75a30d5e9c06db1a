/// @file Three-pin links drawn anew where their dimensions, or the angles of the crank, have
/// changed.
#pragma once

#include <cmath>
#include <span>

#include "synthesis/chain/sweep.hpp"

namespace cognate::synthesis {

/// Has the three-pin links of a chain stand in `design` where they do with the crank in the
/// direction `crank`; as they were where the chain does not close there.
inline void draw_anew(std::span<const PlacedLine> lines, const Vec2d& crank, ChainDesign& design) {
  const std::vector<double> side(design.side.begin(), design.side.end());
  const ChainView<double> view{lines.data(), static_cast<int>(lines.size()),
                               design.parameters.data(), side.data()};
  if (!has_three_pin_link(view)) return;
  ChainPlace<double> at;
  place(view, crank, at);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Vec2d& pin = at.at[k + kFirstPin - kDrawnLine];
    if (lines[k].line.type != LineType::drawn || !std::isfinite(pin.x)) continue;
    double* own = design.parameters.data() + lines[k].parameter;
    own[0] = pin.x;
    own[1] = pin.y;
  }
}

}  // namespace cognate::synthesis
