#include "analysis/mechanism/dyad_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/mechanism/assembly.hpp"

namespace cognate {
namespace {

constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

using Bodies = std::span<const BodyMotion<double, 0>>;

Vec2d place(const Attached<double>& at, Bodies bodies) {
  return point_motion(bodies[static_cast<std::size_t>(at.body)], at.at)[0];
}

Vec2d direction(const Guide<double>& guide, Bodies bodies) {
  return bodies[static_cast<std::size_t>(guide.body)].direction * guide.direction;
}

Reach reach_of(const Rrr<double>& dyad, Bodies bodies) {
  const Vec2d from = place(dyad.first, bodies), to = place(dyad.second, bodies);
  const double sum = dyad.first_length + dyad.second_length;
  return {norm(to - from), std::abs(dyad.first_length - dyad.second_length), sum,
          std::max({norm(from), norm(to), sum})};
}

Reach reach_of(const Rrp<double>& dyad, Bodies bodies) {
  const Vec2d from = place(dyad.point, bodies);
  const Vec2d through = place({dyad.guide.body, dyad.guide.through}, bodies);
  const double h = cross(direction(dyad.guide, bodies), through - from) + dyad.guide.offset;
  return {std::abs(h), 0, dyad.length,
          std::max({norm(from), norm(through), std::abs(dyad.guide.offset), dyad.length})};
}

Reach reach_of(const Rpr<double>& dyad, Bodies bodies) {
  const Vec2d block = place(dyad.block, bodies), pivot = place(dyad.pivot, bodies);
  return {norm(block - pivot), std::abs(dyad.offset), kUnbounded,
          std::max(norm(block), norm(pivot))};
}

Reach reach_of(const Prp<double>& dyad, Bodies bodies) {
  const double sine = cross(direction(dyad.first, bodies), direction(dyad.second, bodies));
  return {std::abs(sine), 0, 1, 1, true};
}

Reach reach_of(const Rpp<double>& dyad, Bodies /*bodies*/) {
  return {std::abs(dyad.slot.y), 0, 1, 1, true};
}

Reach reach_of(const Cylinder<double>& dyad, Bodies bodies, double length) {
  return reach_of(Rrr<double>{dyad.base, dyad.pivot, std::abs(length), dyad.length}, bodies);
}

/// What a group can reach is not known by a formula.
Reach reach_of(const Group&, Bodies) {
  return {.most = kUnbounded};
}

Reach reach_of(const GroupRest&, Bodies) {
  return {.most = kUnbounded};
}

/// Of a² − b² of lengths a and b that may be off by `tolerance` against each other; at least what
/// `least`, the rounding of either, makes of it.
double of_square_difference(double a, double b, double tolerance, double least) {
  return tolerance * std::max(a + b, least);
}

/// Of the product of p = d² − (l₁ − l₂)² and q = (l₁ + l₂)² − d², over (2 l₁ l₂)², where each
/// length may be off by the tolerance of the class: rrr_motion.hpp computes them as accurately.
double four_bar_rounding(const Rrr<double>& dyad, const Crank<double>& crank, const Reach& reach) {
  const double l1 = dyad.first_length, l2 = dyad.second_length, d = reach.distance;
  const Attached<double>& pivot = dyad.first.body == 0 ? dyad.first : dyad.second;
  const double frame = norm(pivot.at - crank.pivot);
  const double tolerance = kChangePointTolerance * std::max({crank.length, l1, l2, frame});
  const double p = (d - reach.least) * (d + reach.least), q = (reach.most - d) * (reach.most + d);
  const double of_p = of_square_difference(d, reach.least, tolerance, tolerance);
  const double of_q = of_square_difference(reach.most, d, tolerance, tolerance);
  const double by_lengths = 0.5 / (l1 * l2);
  return (of_p * std::abs(q) + std::abs(p) * of_q + of_p * of_q) * by_lengths * by_lengths;
}

}  // namespace

Reach reach(const Dyad<double>& dyad, Bodies bodies, double drive) {
  return std::visit(
      [&]<class Group>(const Group& group) {
        if constexpr (std::is_same_v<Group, Cylinder<double>>) {
          return reach_of(group, bodies, drive);
        } else {
          return reach_of(group, bodies);
        }
      },
      dyad);
}

double discriminant_rounding(const Mechanism<double>& mechanism, int index, const Reach& reach) {
  const Dyad<double>& dyad = mechanism.dyads[static_cast<std::size_t>(index)];
  if (const auto* rrr = std::get_if<Rrr<double>>(&dyad)) {
    if (const auto* crank = std::get_if<Crank<double>>(&mechanism.drive)) {
      if (rrr->first.body + rrr->second.body == 1) return four_bar_rounding(*rrr, *crank, reach);
    }
    const double error = kRounding * reach.extent;  // of a coordinate, a length
    return kRounding + 2 * error * reach.distance / (rrr->first_length * rrr->second_length);
  }
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&dyad)) {
    const double length = std::abs(reach.most - cylinder->length);
    return kRounding + 2 * kRounding * reach.extent * reach.distance / (length * cylinder->length);
  }
  // The classes of mechanisms with slides count lengths in parts of a power of two.
  const double unit = std::ldexp(1.0, std::ilogb(reach.extent));
  const double tolerance = kChangePointTolerance * unit;
  if (const auto* rrp = std::get_if<Rrp<double>>(&dyad)) {
    return tolerance * (rrp->length + reach.distance) / (rrp->length * rrp->length);
  }
  if (std::holds_alternative<Rpr<double>>(dyad)) {
    const double of_places = 2 * kChangePointTolerance * reach.extent;
    return of_square_difference(reach.distance, reach.least, tolerance, of_places);
  }
  return kRounding * kRounding;
}

}  // namespace cognate
