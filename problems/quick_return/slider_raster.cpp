/// Slider-cranks on a raster: with the limits at h± = √((l₂ ± l₁)² − e²) the stroke is h₊ − h₋, and
/// θ = asin(|e|/(l₂ − l₁)) − asin(|e|/(l₂ + l₁)). θ grows with crank and offset and falls with the
/// coupler; so does the stroke.
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/quick_return/designs.hpp"
#include "problems/quick_return/return_raster.hpp"

namespace cognate::problems {
namespace {

constexpr auto kSliderCrank = static_cast<std::size_t>(ReturnLength::crank);
constexpr auto kSliderCoupler = static_cast<std::size_t>(ReturnLength::coupler);
constexpr auto kSliderOffset = static_cast<std::size_t>(ReturnLength::offset);
/// Pressure angles up to so much over their limit are left to the final check.
constexpr double kPressureRounding = 1e-8;

/// How far crank and coupler of this reach lean from the slide at a limit: by a right angle where
/// they do not get over the offset.
double lean_of(double reach, double offset) {
  return reach > offset ? std::asin(offset / reach) : kRightAngle;
}

/// Where the slider stands if crank and coupler reach so far; 0 where that is short of the slide.
double limit_of(double reach, double offset) {
  return reach > offset ? std::sqrt((reach - offset) * (reach + offset)) : 0;
}

SliderCrank mechanism_of(const ReturnLengths& at) {
  SliderCrank made;
  made.crank = at[kSliderCrank];
  made.coupler = at[kSliderCoupler];
  made.offset = at[kSliderOffset];
  return made;
}

class SliderRaster final : public ReturnRaster {
 public:
  explicit SliderRaster(const QuickReturnProblem& problem)
      : ReturnRaster(problem), theta_(synthesis::return_angle(problem.time_ratio).angle) {}

  std::optional<synthesis::RasterMerit> merit(const ReturnLengths& at) const override {
    const SliderCrank links = mechanism_of(at);
    if (!(links.coupler > links.crank)) return std::nullopt;
    const auto ratio = time_ratio(links);
    const auto travel = stroke(links);
    const auto pressure = pressure_angles(links);
    if (!ratio || !travel || !pressure) return std::nullopt;
    const double theta = kPi * (*ratio - 1) / (*ratio + 1);
    return synthesis::RasterMerit{
        .error = std::max(std::abs(theta - theta_), std::abs(*travel / *problem().stroke - 1)),
        .second = pressure->steepest,
        .size = links.crank + links.coupler + std::abs(links.offset)};
  }

  std::optional<Design> design(const ReturnLengths& at) const override {
    synthesis::QuickReturnSlider made;
    made.mechanism = mechanism_of(at);
    const auto outer = outer_limit(made.mechanism), inner = inner_limit(made.mechanism);
    if (!outer || !inner) return std::nullopt;
    made.outer = outer->crank_angle;
    made.inner = inner->crank_angle;
    return quick_return_design(problem(), made);
  }

 protected:
  double least_error(const ReturnRanges& all) const override {
    const Range &a = all[kSliderCrank], &b = all[kSliderCoupler], &e = all[kSliderOffset];
    const double nearest = std::max({0.0, e.min, -e.max});
    const double farthest = std::max(std::abs(e.min), std::abs(e.max));
    if (a.min + nearest > b.max) return kInfinity;
    const auto& steepest = problem().pressure_angle_max;
    if (steepest && a.min + nearest > b.max * std::sin(*steepest + kPressureRounding)) {
      return kInfinity;
    }
    const Range theta = thetas(a, b, nearest, farthest);
    const Range travel = strokes(a, b, nearest, farthest);
    return std::max(distance_from(theta, theta_),
                    distance_from(travel, *problem().stroke) / *problem().stroke);
  }

  /// The image in the slide line is the same.
  bool is_same_design(const ReturnLengths& a, const ReturnLengths& b) const override {
    return a[kSliderCrank] == b[kSliderCrank] && a[kSliderCoupler] == b[kSliderCoupler] &&
           std::abs(a[kSliderOffset]) == std::abs(b[kSliderOffset]);
  }

 private:
  /// Exact where every corner of the ranges turns fully; else wide enough.
  static Range thetas(const Range& a, const Range& b, double nearest, double farthest) {
    const double least = lean_of(b.max - a.min, nearest) - lean_of(b.max + a.min, nearest);
    const bool is_monotone = b.min - a.max > farthest;
    const double outer =
        is_monotone ? lean_of(b.min + a.max, farthest) : lean_of(b.max + a.max, nearest);
    return {least, lean_of(b.min - a.max, farthest) - outer};
  }

  static Range strokes(const Range& a, const Range& b, double nearest, double farthest) {
    const double least = limit_of(b.max + a.min, nearest) - limit_of(b.max - a.min, nearest);
    const bool is_monotone = b.min - a.max > farthest;
    const double outer =
        is_monotone ? limit_of(b.min + a.max, farthest) : limit_of(b.max + a.max, nearest);
    return {least, outer - limit_of(b.min - a.max, farthest)};
  }

  double theta_;
};

}  // namespace

std::unique_ptr<ReturnRaster> slider_raster(const QuickReturnProblem& problem) {
  return std::make_unique<SliderRaster>(problem);
}

}  // namespace cognate::problems
