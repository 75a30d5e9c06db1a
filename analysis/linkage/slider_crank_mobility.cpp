#include "analysis/linkage/slider_crank_mobility.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/reach.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/half_angle.hpp"

namespace cognate {
namespace {

/// SliderCrankDimensions times a power of two, which rounds nothing, so that the longest is in [1,
/// 2).
struct SliderCrankDimensions {
  double crank, coupler, offset;
  double unit;  ///< what they are to be multiplied by
};

SliderCrankDimensions normalised(const SliderCrank& mechanism) {
  const double longest = std::max({mechanism.crank, mechanism.coupler, std::abs(mechanism.offset)});
  const double unit = std::ldexp(1.0, std::ilogb(longest));
  return {mechanism.crank / unit, mechanism.coupler / unit, mechanism.offset / unit, unit};
}

/// l₂ ± e ± l₁: `left` is the room that the coupler has beyond the crank at θ = π/2, `right` at
/// θ = −π/2; negative where the crank cannot pass there. With x = l₁ sin θ − e, l₂ − x is left +
/// l₁(1 − sin θ) and l₂ + x is right + l₁(1 + sin θ).
struct Room {
  double left, right, reach_left, reach_right;
};

Room room(const SliderCrankDimensions& d) {
  return {compensated_sum(d.coupler, d.offset, -d.crank, 0.0),
          compensated_sum(d.coupler, -d.offset, -d.crank, 0.0),
          compensated_sum(d.coupler, d.offset, d.crank, 0.0),
          compensated_sum(d.coupler, -d.offset, d.crank, 0.0)};
}

/// How far θ is beyond π/2 and −π/2 where the ranges end.
double gap_left(const Room& r) {
  return angle_of_half(-r.left, r.reach_left);
}
double gap_right(const Room& r) {
  return angle_of_half(-r.right, r.reach_right);
}

/// l₂ sin α and l₂ cos α; empty where the links do not reach the line.
struct Rise {
  double across, along;
};

std::optional<Rise> rise(const SliderCrankDimensions& d, double crank_angle) {
  const Room r = room(d);
  const double sine = std::sin(crank_angle / 2 - kPi / 4),
               cosine = std::cos(crank_angle / 2 - kPi / 4);
  const double below = r.left + 2 * d.crank * sine * sine;
  const double above = r.right + 2 * d.crank * cosine * cosine;
  if (!suffices(below) || !suffices(above)) return std::nullopt;
  return Rise{d.crank * std::sin(crank_angle) - d.offset, root(below, above)};
}

/// How far along the slide line the point at the distance `a` + `b` ≥ 0 from the pivot is.
std::optional<double> along_line(double a, double b, double offset) {
  const double beyond = compensated_sum(a, b, -std::abs(offset), 0.0);
  if (!suffices(beyond)) return std::nullopt;
  return root(beyond, compensated_sum(a, b, std::abs(offset), 0.0));
}

std::optional<double> outer_reach(const SliderCrankDimensions& d) {
  return along_line(d.crank, d.coupler, d.offset);
}

std::optional<double> inner_reach(const SliderCrankDimensions& d) {
  return along_line(std::max(d.crank, d.coupler), -std::min(d.crank, d.coupler), d.offset);
}

PressureAngles with_steepest(double min, double max) {
  return {min, max, std::max(std::abs(min), std::abs(max))};
}

}  // namespace

SliderCrankClass mobility_class(const SliderCrank& mechanism) {
  const auto [l1, l2, e, unit] = normalised(mechanism);
  const double width = -std::abs(e);
  if (suffices(compensated_sum(l2, -l1, width, 0.0))) return SliderCrankClass::rotating_crank;
  if (suffices(compensated_sum(l1, -l2, width, 0.0))) return SliderCrankClass::rotating_coupler;
  return SliderCrankClass::no_rotation;
}

std::string_view name(SliderCrankClass mobility) {
  switch (mobility) {
    case SliderCrankClass::rotating_crank:
      return "rotating-crank";
    case SliderCrankClass::rotating_coupler:
      return "rotating-coupler";
    case SliderCrankClass::no_rotation:
      break;
  }
  return "no-rotation";
}

bool can_assemble(const SliderCrank& mechanism) {
  const Room r = room(normalised(mechanism));
  return suffices(r.reach_left) && suffices(r.reach_right);
}

bool crank_rotates(const SliderCrank& mechanism) {
  return mobility_class(mechanism) == SliderCrankClass::rotating_crank;
}

bool is_change_point(const SliderCrank& mechanism) {
  const auto [l1, l2, e, unit] = normalised(mechanism);
  return std::abs(compensated_sum(std::max(l1, l2), -std::min(l1, l2), -std::abs(e), 0.0)) <=
         kReachRounding;
}

std::vector<SliderPosition> change_points(const SliderCrank& mechanism) {
  const Room r = room(normalised(mechanism));
  std::vector<SliderPosition> found;
  if (!is_change_point(mechanism)) return found;
  if (std::abs(r.left) <= kReachRounding) found.push_back({kRightAngle, 0});
  if (std::abs(r.right) <= kReachRounding) found.push_back({-kRightAngle, 0});
  return found;
}

std::vector<CrankRange> crank_ranges(const SliderCrank& mechanism) {
  if (!can_assemble(mechanism)) return {};
  const Room r = room(normalised(mechanism));
  const bool passes_left = suffices(r.left), passes_right = suffices(r.right);
  if (passes_left && passes_right) return {{0, kTurn}};
  const double left = gap_left(r), right = gap_right(r);
  if (passes_right) return {{-1.5 * kPi + left, 0.5 * kPi - left}};
  if (passes_left) return {{-0.5 * kPi + right, 1.5 * kPi - right}};
  return {{-0.5 * kPi + right, 0.5 * kPi - left}, {0.5 * kPi + left, 1.5 * kPi - right}};
}

std::vector<SliderPosition> dead_points(const SliderCrank& mechanism) {
  if (crank_rotates(mechanism) || !can_assemble(mechanism)) return {};
  const SliderCrankDimensions d = normalised(mechanism);
  const Room r = room(d);
  std::vector<SliderPosition> found;
  // l₁² − (l₂ ± e)² = l₁² cos² θ where the ranges end.
  if (!suffices(r.left)) {
    const double left = gap_left(r), s = d.unit * root(-r.left, r.reach_left);
    found.push_back({0.5 * kPi - left, s});
    found.push_back({0.5 * kPi + left, -s});
  }
  if (!suffices(r.right)) {
    const double right = gap_right(r), s = d.unit * root(-r.right, r.reach_right);
    found.push_back({-0.5 * kPi + right, s});
    found.push_back({1.5 * kPi - right, -s});
  }
  return found;
}

std::optional<double> displacement(const SliderCrank& mechanism, double crank_angle) {
  const SliderCrankDimensions d = normalised(mechanism);
  const auto at = rise(d, crank_angle);
  if (!at) return std::nullopt;
  return d.unit * (d.crank * std::cos(crank_angle) + sign(mechanism.assembly) * at->along);
}

std::optional<double> pressure_angle(const SliderCrank& mechanism, double crank_angle) {
  const auto at = rise(normalised(mechanism), crank_angle);
  if (!at) return std::nullopt;
  return std::atan2(at->across, at->along);
}

std::optional<SliderPosition> outer_limit(const SliderCrank& mechanism) {
  const SliderCrankDimensions d = normalised(mechanism);
  const auto along = outer_reach(d);
  if (!along) return std::nullopt;
  const double s = sign(mechanism.assembly) * *along;
  return SliderPosition{std::atan2(d.offset, s), d.unit * s};
}

std::optional<SliderPosition> inner_limit(const SliderCrank& mechanism) {
  const SliderCrankDimensions d = normalised(mechanism);
  if (d.crank == d.coupler) return std::nullopt;
  const auto along = inner_reach(d);
  if (!along) return std::nullopt;
  // A coupler that is the longer points from B over A to C; a shorter one back towards A.
  const double ahead = d.coupler > d.crank ? 1 : -1;
  const double s = ahead * sign(mechanism.assembly) * *along;
  return SliderPosition{std::atan2(-ahead * d.offset, -ahead * s), d.unit * s};
}

std::optional<double> stroke(const SliderCrank& mechanism) {
  const SliderCrankDimensions d = normalised(mechanism);
  const auto outer = outer_reach(d);
  if (!outer) return std::nullopt;
  const auto inner = inner_reach(d);
  if (!inner) return d.unit * 2 * *outer;
  if (*outer == 0) return 0;
  // The difference of the roots by that of their squares, 4 l₁ l₂.
  return d.unit * (4 * d.crank * d.coupler / (*outer + *inner));
}

std::optional<double> stroke(const SliderCrank& mechanism, const CrankRange& range) {
  const auto from = displacement(mechanism, range.from), to = displacement(mechanism, range.to);
  if (!from || !to) return std::nullopt;
  double least = std::min(*from, *to), greatest = std::max(*from, *to);
  for (const auto& limit : {outer_limit(mechanism), inner_limit(mechanism)}) {
    if (!limit) continue;
    const double ahead = std::remainder(limit->crank_angle - range.from, kTurn);
    const double along = ahead < 0 ? ahead + kTurn : ahead;
    if (along > range.to - range.from) continue;
    least = std::min(least, limit->displacement);
    greatest = std::max(greatest, limit->displacement);
  }
  return greatest - least;
}

std::optional<double> time_ratio(const SliderCrank& mechanism) {
  const SliderCrankDimensions d = normalised(mechanism);
  if (!crank_rotates(mechanism) || d.crank >= d.coupler) return std::nullopt;
  const auto outer = outer_reach(d);
  const auto inner = inner_reach(d);
  if (!outer || !inner) return std::nullopt;
  const double e = std::abs(d.offset);
  const double delta = std::atan2(e, *inner) - std::atan2(e, *outer);
  return (kPi + delta) / (kPi - delta);
}

std::optional<PressureAngles> pressure_angles(const SliderCrank& mechanism) {
  if (!can_assemble(mechanism)) return std::nullopt;
  const SliderCrankDimensions d = normalised(mechanism);
  const Room r = room(d);
  double min = -kRightAngle, max = kRightAngle;
  if (suffices(r.left)) max = std::atan2(d.crank - d.offset, root(r.left, r.reach_right));
  if (suffices(r.right)) min = std::atan2(-d.crank - d.offset, root(r.right, r.reach_left));
  return with_steepest(min, max);
}

std::optional<PressureAngles> pressure_angles(const SliderCrank& mechanism,
                                              const CrankRange& range) {
  const auto from = pressure_angle(mechanism, range.from), to = pressure_angle(mechanism, range.to);
  if (!from || !to) return std::nullopt;
  double min = std::min(*from, *to), max = std::max(*from, *to);
  for (double k = std::ceil(range.from / kPi - 0.5); (k + 0.5) * kPi < range.to; ++k) {
    const auto inside = pressure_angle(mechanism, (k + 0.5) * kPi);
    if (!inside) return std::nullopt;
    min = std::min(min, *inside);
    max = std::max(max, *inside);
  }
  return with_steepest(min, max);
}

}  // namespace cognate
