/// Crank-rockers on a raster. With the triangles A–C–D of the two limits, whose sides are l₂ ± l₁,
/// l₃ and l₄, of angles α± at A and δ± at D: θ = |α₋ − α₊| and φ = |δ₊ − δ₋|.
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/quick_return/designs.hpp"
#include "problems/quick_return/return_raster.hpp"
#include "synthesis/exact/quick_return/quick_return.hpp"

namespace cognate::problems {
namespace {

constexpr auto kCrank = static_cast<std::size_t>(ReturnLength::crank);
constexpr auto kCoupler = static_cast<std::size_t>(ReturnLength::coupler);
constexpr auto kRocker = static_cast<std::size_t>(ReturnLength::rocker);
constexpr auto kFrame = static_cast<std::size_t>(ReturnLength::frame);

double angle_of(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// cos of a triangle's angle between the sides p and q, r being opposite.
double cosine(double p, double q, double r) {
  return (p * p + q * q - r * r) / (2 * p * q);
}

/// All that the angle between the sides p and q can be, exactly: its cosine falls with r, is
/// greatest at corners of (p, q), and least there or where p² = q² − r², or q² = p² − r², on an
/// edge.
Range triangle_angles(const Range& p, const Range& q, const Range& r) {
  double least = kInfinity, greatest = -kInfinity;
  for (const double one : {p.min, p.max}) {
    for (const double other : {q.min, q.max}) {
      least = std::min(least, cosine(one, other, r.max));
      greatest = std::max(greatest, cosine(one, other, r.min));
    }
  }
  const auto look_between = [&](double fixed, const Range& side) {
    const double square = (fixed - r.max) * (fixed + r.max);
    const double at = std::sqrt(std::max(0.0, square));
    if (at > side.min && at < side.max) least = std::min(least, at / fixed);
  };
  for (const double end : {p.min, p.max}) look_between(end, q);
  for (const double end : {q.min, q.max}) look_between(end, p);
  return {angle_of(greatest), angle_of(least)};
}

/// |a − b|.
Range distance_between(const Range& a, const Range& b) {
  const double lower = a.min - b.max, upper = a.max - b.min;
  return {std::max({0.0, lower, -upper}), std::max(-lower, upper)};
}

/// A positive part of a difference of lengths of size `size`, of which nothing is left out but
/// rounding.
Range positive(double lower, double upper, double size) {
  const double least = 1e-15 * size;
  return {std::max(lower, least), std::max(upper, least)};
}

Lengths<double> links_of(const ReturnLengths& at) {
  return {.crank = at[kCrank], .coupler = at[kCoupler], .rocker = at[kRocker], .frame = at[kFrame]};
}

class RockerRaster final : public ReturnRaster {
 public:
  explicit RockerRaster(const QuickReturnProblem& problem)
      : ReturnRaster(problem), theta_(synthesis::return_angle(problem.time_ratio).angle) {}

  std::optional<synthesis::RasterMerit> merit(const ReturnLengths& at) const override {
    const Lengths<double> links = links_of(at);
    const auto outer = outer_limit(links), inner = inner_limit(links);
    const auto ratio = time_ratio(links);
    if (!outer || !inner || !ratio) return std::nullopt;
    const double theta = kPi * (*ratio - 1) / (*ratio + 1);
    const double swing = std::abs(outer->rocker_angle - inner->rocker_angle);
    return synthesis::RasterMerit{
        .error = std::max(std::abs(theta - theta_), std::abs(swing - *problem().swing)),
        .second = -transmission_angles(links).acute_min,
        .size = links.crank + links.coupler + links.rocker + links.frame};
  }

  /// The rocker's pivot in the origin, the bisector of its swing along y, the crank's pivot to its
  /// left, as exact designs have it.
  std::optional<Design> design(const ReturnLengths& at) const override {
    const Lengths<double> links = links_of(at);
    const auto outer = outer_limit(links), inner = inner_limit(links);
    if (!outer || !inner) return std::nullopt;
    const double turn = kRightAngle - 0.5 * (outer->rocker_angle + inner->rocker_angle);
    const double half_swing = 0.5 * std::abs(outer->rocker_angle - inner->rocker_angle);
    synthesis::QuickReturnRocker made;
    made.linkage.pivot_a = -links.frame * Vec2d{std::cos(turn), std::sin(turn)};
    made.linkage.crank = links.crank;
    made.linkage.coupler = links.coupler;
    made.linkage.rocker = links.rocker;
    made.outer = outer->crank_angle + turn;
    made.inner = inner->crank_angle + turn;
    const bool is_near = made.linkage.pivot_a.y < links.rocker * std::cos(half_swing);
    made.arc = is_near ? synthesis::PivotArc::near : synthesis::PivotArc::far;
    return quick_return_design(problem(), made);
  }

 protected:
  double least_error(const ReturnRanges& all) const override {
    const Range &a = all[kCrank], &c = all[kCoupler], &r = all[kRocker], &f = all[kFrame];
    if (!can_turn(a, c, r, f) || breaks_limits(a, c, r, f)) return kInfinity;
    const Range folded = positive(c.min - a.max, c.max - a.min, c.max);
    const Range extended{c.min + a.min, c.max + a.max};
    const Range theta =
        distance_between(triangle_angles(f, folded, r), triangle_angles(f, extended, r));
    const Range swing =
        distance_between(triangle_angles(r, f, extended), triangle_angles(r, f, folded));
    return std::max(distance_from(theta, theta_), distance_from(swing, *problem().swing));
  }

  bool is_same_design(const ReturnLengths& a, const ReturnLengths& b) const override {
    return are_proportional(std::span(a).first(kFrame + 1), std::span(b).first(kFrame + 1));
  }

 private:
  /// Whether any crank of the ranges turns fully while its follower swings (Grashof).
  static bool can_turn(const Range& a, const Range& c, const Range& r, const Range& f) {
    return a.min + f.min <= c.max + r.max && a.min + c.min <= f.max + r.max &&
           a.min + r.min <= c.max + f.max;
  }

  /// Whether every linkage of the ranges breaks a limit of the transmission angle or the ratio of
  /// its links.
  bool breaks_limits(const Range& a, const Range& c, const Range& r, const Range& f) const {
    const Constraints& limits = problem().constraints;
    if (limits.link_ratio_max) {
      const double longest = std::max({c.min, r.min, f.min});
      if (longest > a.max * *limits.link_ratio_max * (1 + kRoundingOfLimits)) return true;
    }
    if (!limits.transmission_angle) return false;
    const Range least = triangle_angles(c, r, positive(f.min - a.max, f.max - a.min, f.max));
    const Range most = triangle_angles(c, r, {f.min + a.min, f.max + a.max});
    return least.max < limits.transmission_angle->min - kRoundingOfLimits ||
           most.min > limits.transmission_angle->max + kRoundingOfLimits;
  }

  static constexpr double kRoundingOfLimits = 1e-8;
  double theta_;
};

}  // namespace

std::unique_ptr<ReturnRaster> rocker_raster(const QuickReturnProblem& problem) {
  return std::make_unique<RockerRaster>(problem);
}

}  // namespace cognate::problems
