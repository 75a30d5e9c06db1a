/// Guide-bars and shapers on a raster: the bar swings by θ = asin((l₁ − e)/l₄) + asin((l₁ + e)/l₄),
/// which grows with the crank and falls with the frame, and pushes a ram by 2 L sin(θ/2).
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/quick_return/designs.hpp"
#include "problems/quick_return/return_raster.hpp"

namespace cognate::problems {
namespace {

constexpr auto kGuideCrank = static_cast<std::size_t>(ReturnLength::crank);
constexpr auto kGuideFrame = static_cast<std::size_t>(ReturnLength::frame);
constexpr auto kShaperBar = static_cast<std::size_t>(ReturnLength::bar);
constexpr auto kShaperRod = static_cast<std::size_t>(ReturnLength::rod);
constexpr auto kShaperHeight = static_cast<std::size_t>(ReturnLength::ram_height);
/// How little of the bound depends on the rod, which only limits speak of.
constexpr double kRodWeight = 1e-9;

double swing_of(double crank, double frame, double offset) {
  const double left = std::clamp((crank - offset) / frame, -1.0, 1.0);
  const double right = std::clamp((crank + offset) / frame, -1.0, 1.0);
  return std::asin(left) + std::asin(right);
}

Range swings(const Range& crank, const Range& frame, double offset) {
  return {swing_of(crank.min, frame.max, offset), swing_of(crank.max, frame.min, offset)};
}

class GuideRaster final : public ReturnRaster {
 public:
  explicit GuideRaster(const QuickReturnProblem& problem)
      : ReturnRaster(problem),
        theta_(synthesis::return_angle(problem.time_ratio).angle),
        offset_(problem.offset.value_or(0)) {}

  std::optional<synthesis::RasterMerit> merit(const ReturnLengths& at) const override {
    const GuideBar bar = mechanism(at);
    const auto found = swing(bar);
    if (!found || !time_ratio(bar)) return std::nullopt;
    const auto pressure = greatest_pressure_angle(bar);
    if (!pressure) return std::nullopt;
    return synthesis::RasterMerit{.error = std::abs(*found - theta_),
                                  .second = *pressure,
                                  .size = at[kGuideCrank] + at[kGuideFrame]};
  }

  std::optional<Design> design(const ReturnLengths& at) const override {
    synthesis::QuickReturnGuide made;
    made.mechanism = mechanism(at);
    const auto limits = bar_limits(made.mechanism);
    if (!limits[0] || !limits[1]) return std::nullopt;
    // Angles there count from A→C, which points down.
    const bool first_is_left = std::sin(limits[0]->crank_angle) < 0;
    made.left = in_one_turn(limits[first_is_left ? 0 : 1]->crank_angle - kRightAngle);
    made.right = in_one_turn(limits[first_is_left ? 1 : 0]->crank_angle - kRightAngle);
    return quick_return_design(problem(), made);
  }

 protected:
  double least_error(const ReturnRanges& all) const override {
    const Range &crank = all[kGuideCrank], &frame = all[kGuideFrame];
    if (crank.min + std::abs(offset_) > frame.max) return kInfinity;
    return distance_from(swings(crank, frame, offset_), theta_);
  }

  bool is_same_design(const ReturnLengths& a, const ReturnLengths& b) const override {
    const std::array one{a[kGuideCrank], a[kGuideFrame]}, other{b[kGuideCrank], b[kGuideFrame]};
    return offset_ == 0 && are_proportional(one, other);
  }

 private:
  GuideBar mechanism(const ReturnLengths& at) const {
    return {{0, at[kGuideFrame]}, {0, 0}, at[kGuideCrank], offset_, Assembly::open};
  }

  double theta_, offset_;
};

class ShaperRaster final : public ReturnRaster {
 public:
  explicit ShaperRaster(const QuickReturnProblem& problem)
      : ReturnRaster(problem), theta_(synthesis::return_angle(problem.time_ratio).angle) {}

  std::optional<synthesis::RasterMerit> merit(const ReturnLengths& at) const override {
    const auto made = shaper(at);
    if (!made) return std::nullopt;
    const double travel = 2 * made->bar * made->crank / made->frame;
    return synthesis::RasterMerit{
        .error = std::max(std::abs(swing_of(made->crank, made->frame, 0) - theta_),
                          std::abs(travel / *problem().stroke - 1)),
        .second = made->pressure,
        .size = made->crank + made->frame + made->bar + made->rod + made->ram_height};
  }

  std::optional<Design> design(const ReturnLengths& at) const override {
    const auto made = shaper(at);
    const auto motion = made ? simulate(*made) : std::nullopt;
    if (!motion) return std::nullopt;
    return quick_return_design(problem(), *made, *motion);
  }

  double weight(std::size_t axis) const override {
    const std::string& name = axes()[axis].name;
    return name == "rod" || name == "ram_height" ? kRodWeight : 1;
  }

 protected:
  double least_error(const ReturnRanges& all) const override {
    const Range &crank = all[kGuideCrank], &frame = all[kGuideFrame], &bar = all[kShaperBar];
    // The block must not slide off the bar.
    if (crank.min > frame.max || bar.max < crank.min + frame.min) return kInfinity;
    const Range travel{2 * bar.min * crank.min / frame.max, 2 * bar.max * crank.max / frame.min};
    return std::max(distance_from(swings(crank, frame, 0), theta_),
                    distance_from(travel, *problem().stroke) / *problem().stroke);
  }

  /// Frame and crank enlarged alike leave bar and ram as they are.
  bool is_same_design(const ReturnLengths& a, const ReturnLengths& b) const override {
    const std::array one{a[kGuideCrank], a[kGuideFrame]}, other{b[kGuideCrank], b[kGuideFrame]};
    return are_proportional(one, other) && a[kShaperBar] == b[kShaperBar] &&
           a[kShaperRod] == b[kShaperRod] && a[kShaperHeight] == b[kShaperHeight];
  }

 private:
  static std::optional<synthesis::Shaper> shaper(const ReturnLengths& at) {
    synthesis::Shaper made{at[kGuideCrank], at[kGuideFrame],   at[kShaperBar],
                           at[kShaperRod],  at[kShaperHeight], 0};
    if (!(made.crank < made.frame)) return std::nullopt;
    const double half_swing = std::asin(made.crank / made.frame);
    if (judge(made, half_swing) != synthesis::ShaperOutcome::solved) return std::nullopt;
    return made;
  }

  double theta_;
};

}  // namespace

std::unique_ptr<ReturnRaster> guide_raster(const QuickReturnProblem& problem) {
  return std::make_unique<GuideRaster>(problem);
}

std::unique_ptr<ReturnRaster> shaper_raster(const QuickReturnProblem& problem) {
  return std::make_unique<ShaperRaster>(problem);
}

}  // namespace cognate::problems
