#include "app/drawing/design_motion.hpp"

#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

/// How much of `crank_angles`, given from A→D, lies in `range`.
int count_inside(const CrankRange& range, std::span<const double> crank_angles) {
  constexpr double kMargin = 1e-7;
  int inside = 0;
  for (const double angle : crank_angles) {
    const double turn = std::remainder(angle - 0.5 * (range.from + range.to), kTurn);
    if (std::abs(turn) <= 0.5 * (range.to - range.from) + kMargin) ++inside;
  }
  return inside;
}

/// The range, from the x axis, to draw; empty when the links never close.
std::vector<CrankRange> drawn_range(const FourBar& linkage, std::span<const double> crank_angles) {
  const auto ranges = crank_ranges(lengths(linkage));
  if (ranges.empty()) return {};
  const double frame = frame_angle(linkage);
  std::vector<double> from_frame;
  for (const double angle : crank_angles) from_frame.push_back(angle - frame);
  CrankRange best = ranges.front();
  for (const CrankRange& range : ranges) {
    if (count_inside(range, from_frame) > count_inside(best, from_frame)) best = range;
  }
  const double whole = kTurn * std::floor((best.from + frame) / (kTurn));
  return {{best.from + frame - whole, best.to + frame - whole}};
}

/// `angle` moved by whole turns to where it is nearest to `before`.
double continued(double angle, double before) {
  return before + std::remainder(angle - before, kTurn);
}

}  // namespace

DesignMotion sample_motion(const FourBar& linkage, std::span<const double> crank_angles,
                           int count) {
  DesignMotion samples;
  samples.full_turn = crank_rotates(lengths(linkage));
  auto ranges = drawn_range(linkage, crank_angles);
  if (ranges.empty()) return samples;
  // A little within a range that ends at dead points, where rounding decides whether it closes.
  const double margin = samples.full_turn ? 0 : 1e-12;
  if (samples.full_turn) ranges.front() = {0, kTurn};
  const double from = ranges.front().from + margin, to = ranges.front().to - margin;
  const Motion motion(linkage);
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const double part = samples.full_turn ? share : 0.5 * (1 - std::cos(kPi * share));
    const double crank = from + part * (to - from);
    const auto pose = motion.at(crank);
    if (!pose) continue;
    const double rocker = samples.rocker.empty()
                              ? pose->rocker_angle
                              : continued(pose->rocker_angle, samples.rocker.back());
    samples.crank.push_back(crank);
    samples.rocker.push_back(rocker);
  }
  return samples;
}

}  // namespace cognate::app
