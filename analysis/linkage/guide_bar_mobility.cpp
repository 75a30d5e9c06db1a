#include "analysis/linkage/guide_bar_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/reach.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/half_angle.hpp"

namespace cognate {
namespace {

/// GuideBarDimensions times a power of two, which rounds nothing, so that the longest is in [1, 2).
struct GuideBarDimensions {
  double crank, frame, offset;
  double unit;  ///< what they are to be multiplied by
};

GuideBarDimensions normalised(const GuideBar& mechanism) {
  const Vec2d frame = mechanism.pivot_c - mechanism.pivot_a;
  const double distance = std::hypot(frame.x, frame.y);
  const double longest = std::max({mechanism.crank, distance, std::abs(mechanism.offset)});
  const double unit = std::ldexp(1.0, std::ilogb(longest));
  return {mechanism.crank / unit, distance / unit, mechanism.offset / unit, unit};
}

/// The longer of frame and crank less the shorter and the offset: negative where the guide line
/// does not reach the crank pin at θ = 0.
double least_room(const GuideBarDimensions& d) {
  return compensated_sum(std::max(d.frame, d.crank), -std::min(d.frame, d.crank),
                         -std::abs(d.offset), 0.0);
}

/// s² at θ = 0 and at θ = π: r² − e² there, factored.
double nearest_square(const GuideBarDimensions& d) {
  const double room = least_room(d);
  return (suffices(room) ? std::max(room, 0.0) : room) *
         compensated_sum(std::max(d.frame, d.crank), -std::min(d.frame, d.crank),
                         std::abs(d.offset), 0.0);
}
double farthest_square(const GuideBarDimensions& d) {
  return compensated_sum(d.frame, d.crank, -d.offset, 0.0) *
         compensated_sum(d.frame, d.crank, d.offset, 0.0);
}

/// s ≥ 0 at a crank angle; empty where the mechanism does not close.
std::optional<double> block_distance(const GuideBarDimensions& d, double crank_angle) {
  const double half = std::sin(crank_angle / 2);
  const double square = nearest_square(d) + 4 * d.crank * d.frame * half * half;
  if (!suffices(square)) return std::nullopt;
  return std::sqrt(std::max(square, 0.0));
}

/// asin(a/b) for |a| ≤ b, by the factors of b² − a² that keep their digits near b.
double arc_sine(double a, double b_less_a, double b_plus_a) {
  return std::atan2(a, root(b_less_a, b_plus_a));
}

/// The sum asin((x − e)/y) + asin((x + e)/y), defined for x + |e| ≤ y.
double sum_of_arc_sines(double x, double y, double e) {
  return arc_sine(x - e, compensated_sum(y, -x, e, 0.0), compensated_sum(y, x, -e, 0.0)) +
         arc_sine(x + e, compensated_sum(y, -x, -e, 0.0), compensated_sum(y, x, e, 0.0));
}

/// The limit with B = A + l₁n (`side` +1) or A − l₁n (−1), n = i·u. From n·(B − C) = e the bar's
/// angle ψ has sin ψ = (e ∓ l₁)/l₄, and cos ψ the sign of −s.
std::optional<BarLimit> limit(const GuideBarDimensions& d, double side, double assembly) {
  const double l1 = side * d.crank;
  const double below = compensated_sum(d.frame, l1, -d.offset, 0.0);
  const double above = compensated_sum(d.frame, -l1, d.offset, 0.0);
  if (!suffices(below) || !suffices(above)) return std::nullopt;
  const double bar = std::atan2(d.offset - l1, -assembly * root(below, above));
  return BarLimit{std::remainder(bar + side * kRightAngle, kTurn), bar};
}

double pressure_at(const GuideBarDimensions& d, double block_distance) {
  return std::atan2(std::abs(d.offset), block_distance);
}

}  // namespace

GuideBarClass mobility_class(const GuideBar& mechanism) {
  const GuideBarDimensions d = normalised(mechanism);
  if (!suffices(least_room(d))) return GuideBarClass::no_rotation;
  return compensated_sum(d.frame, -d.crank, -std::abs(d.offset), 0.0) >= -kReachRounding
             ? GuideBarClass::oscillating
             : GuideBarClass::rotating;
}

std::string_view name(GuideBarClass mobility) {
  switch (mobility) {
    case GuideBarClass::oscillating:
      return "oscillating";
    case GuideBarClass::rotating:
      return "rotating";
    case GuideBarClass::no_rotation:
      break;
  }
  return "no-rotation";
}

bool can_assemble(const GuideBar& mechanism) {
  const GuideBarDimensions d = normalised(mechanism);
  return suffices(compensated_sum(d.frame, d.crank, -std::abs(d.offset), 0.0));
}

bool crank_rotates(const GuideBar& mechanism) {
  return suffices(least_room(normalised(mechanism)));
}

bool is_change_point(const GuideBar& mechanism) {
  return std::abs(least_room(normalised(mechanism))) <= kReachRounding;
}

std::vector<CrankRange> crank_ranges(const GuideBar& mechanism) {
  if (!can_assemble(mechanism)) return {};
  if (crank_rotates(mechanism)) return {{0, kTurn}};
  // 4 l₁ l₄ sin²(θ/2) = e² − (l₄ − l₁)² and 4 l₁ l₄ cos²(θ/2) = (l₄ + l₁)² − e².
  const GuideBarDimensions d = normalised(mechanism);
  const double first = angle_of_half(-nearest_square(d), farthest_square(d));
  return {{first, kTurn - first}};
}

std::optional<double> bar_angle(const GuideBar& mechanism, double crank_angle) {
  const GuideBarDimensions d = normalised(mechanism);
  const auto distance = block_distance(d, crank_angle);
  if (!distance) return std::nullopt;
  const double half = std::sin(crank_angle / 2);
  // B − C = l₁ e^{iθ} − l₄ without the difference of cos θ and 1.
  const Vec2d cb{compensated_sum(d.crank, -d.frame, -2 * d.crank * half * half, 0.0),
                 d.crank * std::sin(crank_angle)};
  const Vec2d bar = cb * Vec2d{sign(mechanism.assembly) * *distance, -d.offset};
  if (squared_norm(cb) <= kReachRounding * kReachRounding) return std::nullopt;
  return std::atan2(bar.y, bar.x);
}

std::array<std::optional<BarLimit>, 2> bar_limits(const GuideBar& mechanism) {
  const GuideBarDimensions d = normalised(mechanism);
  const double assembly = sign(mechanism.assembly);
  return {limit(d, 1, assembly), limit(d, -1, assembly)};
}

std::optional<double> swing(const GuideBar& mechanism) {
  if (mobility_class(mechanism) != GuideBarClass::oscillating) return std::nullopt;
  const GuideBarDimensions d = normalised(mechanism);
  return sum_of_arc_sines(d.crank, d.frame, d.offset);
}

std::optional<double> time_ratio(const GuideBar& mechanism) {
  const auto angle = swing(mechanism);
  if (!angle || *angle >= kPi * (1 - kReachRounding)) return std::nullopt;
  return (kPi + *angle) / (kPi - *angle);
}

std::optional<double> half_turn_time_ratio(const GuideBar& mechanism, double bar_angle) {
  if (mobility_class(mechanism) != GuideBarClass::rotating) return std::nullopt;
  const GuideBarDimensions d = normalised(mechanism);
  // A stands l₄ sin ψ − e to the left of the guide line, by which the crank leads or lags the bar.
  const double advance =
      std::abs(sum_of_arc_sines(d.frame * std::sin(bar_angle), d.crank, d.offset));
  return (kPi + advance) / (kPi - advance);
}

std::optional<BlockTravel> block_travel(const GuideBar& mechanism) {
  if (!can_assemble(mechanism)) return std::nullopt;
  const GuideBarDimensions d = normalised(mechanism);
  return BlockTravel{d.unit * std::sqrt(std::max(nearest_square(d), 0.0)),
                     d.unit * std::sqrt(std::max(farthest_square(d), 0.0))};
}

std::optional<double> pressure_angle(const GuideBar& mechanism, double crank_angle) {
  const GuideBarDimensions d = normalised(mechanism);
  const auto distance = block_distance(d, crank_angle);
  if (!distance) return std::nullopt;
  return pressure_at(d, *distance);
}

std::optional<double> greatest_pressure_angle(const GuideBar& mechanism) {
  if (!can_assemble(mechanism)) return std::nullopt;
  const GuideBarDimensions d = normalised(mechanism);
  return pressure_at(d, std::sqrt(std::max(nearest_square(d), 0.0)));
}

std::optional<double> greatest_pressure_angle(const GuideBar& mechanism, const CrankRange& range) {
  const auto from = pressure_angle(mechanism, range.from), to = pressure_angle(mechanism, range.to);
  if (!from || !to) return std::nullopt;
  const bool passes_frame = std::ceil(range.from / (kTurn)) * (kTurn) < range.to;
  if (passes_frame) return greatest_pressure_angle(mechanism);
  return std::max(*from, *to);
}

}  // namespace cognate
