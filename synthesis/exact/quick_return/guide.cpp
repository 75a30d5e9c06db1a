#include "synthesis/exact/quick_return/guide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

/// Whether the analysis kernel finds the desired swing; fills in what it finds.
bool confirm(const ReturnAngle& wanted, QuickReturnGuide& design) {
  const GuideBar& bar = design.mechanism;
  const auto found = swing(bar);
  const auto limits = bar_limits(bar);
  if (!found || !limits[0] || !limits[1] || !time_ratio(bar)) return false;
  design.residual = std::abs(*found - wanted.angle);
  // Angles there count from A→C, which points down.
  constexpr double down = -kRightAngle;
  const bool first_is_left = std::sin(limits[0]->crank_angle) < 0;
  design.left = in_one_turn(limits[first_is_left ? 0 : 1]->crank_angle + down);
  design.right = in_one_turn(limits[first_is_left ? 1 : 0]->crank_angle + down);
  // An arcsine near 90° amplifies the rounding of its argument.
  return design.residual <= 64 * kEpsilon / std::max(kEpsilon, wanted.half_cosine);
}

std::vector<QuickReturnGuide> confirmed(const ReturnAngle& angle, double crank, double frame,
                                        double offset, double condition) {
  std::vector<QuickReturnGuide> found;
  if (!(crank > 0) || !std::isfinite(frame)) return found;
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    if (offset == 0 && assembly == Assembly::crossed) break;
    QuickReturnGuide design;
    design.mechanism = {{0, frame}, {0, 0}, crank, offset, assembly};
    design.mirror = assembly == Assembly::crossed;
    design.condition = condition;
    if (confirm(angle, design)) found.push_back(design);
  }
  return found;
}

}  // namespace

double guide_offset_limit(double time_ratio, double frame) {
  const double cosine = return_angle(time_ratio).half_cosine;
  return frame * cosine * cosine;
}

std::vector<QuickReturnGuide> guides_with_frame(double time_ratio, double frame, double offset) {
  const ReturnAngle angle = return_angle(time_ratio);
  if (std::abs(offset) >= guide_offset_limit(time_ratio, frame)) return {};
  const double reach = frame * angle.half_cosine;
  const double span = std::sqrt((reach - offset) * (reach + offset));
  const double amplified = (reach / span) * (reach / span);
  return confirmed(angle, angle.half_tangent() * span, frame, offset, amplified);
}

std::vector<QuickReturnGuide> guides_with_crank(double time_ratio, double crank, double offset) {
  const ReturnAngle angle = return_angle(time_ratio);
  const double span = crank / angle.half_tangent();
  const double frame = std::hypot(span, offset) / angle.half_cosine;
  if (std::abs(offset) >= guide_offset_limit(time_ratio, frame)) return {};
  return confirmed(angle, crank, frame, offset, 1);
}

}  // namespace cognate::synthesis
