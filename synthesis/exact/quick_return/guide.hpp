/// @file Guide-bars of a given time ratio: the bar swings by θ itself.
#pragma once

#include <vector>

#include "analysis/linkage/guide_bar.hpp"
#include "synthesis/exact/quick_return/quick_return.hpp"

namespace cognate::synthesis {

/// An oscillating guide-bar with its guide pivot C in the origin and its crank pivot on the
/// positive y axis, confirmed by the analysis kernel from its dimensions alone. Without offset the
/// bar swings about the y axis, and the crank stands across it at its limits.
struct QuickReturnGuide {
  GuideBar mechanism;
  bool mirror = false;  ///< the image of the first in the y axis; only with an offset
  double left = 0;      ///< crank angle from the x axis where the bar turns back at its left limit
  double right = 0;     ///< at its right one; counter-clockwise from here to `left` the bar is slow
  double residual = 0;  ///< error of θ as simulated, radians
  double condition = 1;  ///< relative change of the length found to that of the length given
};

/// The guide-bar of frame l₄ and offset e, and with an offset its mirror image (the other
/// assembly): l₁ = tan(θ/2) √(l₄² cos²(θ/2) − e²), which is l₄ sin(θ/2) without offset (Li & Xu
/// 2011, section 3). None for K = 1, where the crank would have no length, and for |e| ≥ l₄
/// cos²(θ/2), where it would not turn fully.
std::vector<QuickReturnGuide> guides_with_frame(double time_ratio, double frame, double offset);

/// The same with the crank given: l₄ = √((l₁/tan(θ/2))² + e²)/cos(θ/2). None where this frame
/// violates the condition above.
std::vector<QuickReturnGuide> guides_with_crank(double time_ratio, double crank, double offset);

/// The offsets below which there is a guide-bar of this frame: l₄ cos²(θ/2).
double guide_offset_limit(double time_ratio, double frame);

}  // namespace cognate::synthesis
