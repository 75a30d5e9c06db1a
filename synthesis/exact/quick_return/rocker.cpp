#include "synthesis/exact/quick_return/rocker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/arc.hpp"

namespace cognate::synthesis {
namespace {

constexpr std::array kArcs{PivotArc::near, PivotArc::far};

/// At K = 1 both arcs are the same line: it is then searched once, as the near one.
std::span<const PivotArc> distinct_arcs(const RockerTask& task) {
  return std::span(kArcs).first(task.time_ratio == 1 ? 1 : 2);
}

bool on_arc(const RockerArc& arc, double q) {
  return q > 0 && q < arc.end();
}

/// λ with a λ² + b λ + c = 0, the discriminant taken for zero where rounding explains its sign.
struct Roots {
  int count = 0;
  std::array<double, 2> at{};
};

Roots real_roots(double a, double b, double c) {
  const double half = 0.5 * b;
  double discriminant = half * half - a * c;
  const double scale = half * half + std::abs(a * c);
  if (discriminant < -8 * kEpsilon * scale) return {};
  discriminant = std::max(0.0, discriminant);
  const double sum = -(half + std::copysign(std::sqrt(discriminant), half));
  Roots roots;
  if (std::abs(a) > 0 && std::isfinite(sum / a)) roots.at[roots.count++] = sum / a;
  if (sum != 0 && (roots.count == 0 || roots.at[0] != c / sum)) roots.at[roots.count++] = c / sum;
  return roots;
}

/// A line in units of h about the middle of C₁C₂: the points foot·normal + λ·perp(normal).
struct ScaledLine {
  Vec2d normal;
  double foot = 0;
};

ScaledLine scaled(const PivotLine& line, const RockerArc& arc) {
  const double size = std::hypot(line.a, line.b);
  const Vec2d normal{line.a / size, line.b / size};
  return {normal, (line.c / size - normal.y * arc.y0()) / arc.h()};
}

/// Where the line crosses the circle sin θ (x² + y² − 1) = 2 s cos θ · y of an arc: a line at K
/// = 1.
Roots crossings(const ScaledLine& line, const ReturnAngle& angle, PivotArc arc) {
  const double sine = angle.sine();
  // No point of the arc is farther away than 2h/sin θ, and no square of a greater number is needed.
  if (sine * std::abs(line.foot) > 4) return {};
  const double curved = sine == 0 ? 0 : sine * (line.foot - 1) * (line.foot + 1);
  const double twice = 2 * sign(arc) * angle.cosine();
  const Vec2d& n = line.normal;
  return real_roots(sine, -twice * n.x, curved - twice * line.foot * n.y);
}

/// The elliptic coordinates of a point in units of h about the middle of C₁C₂.
ArcPoint elliptic(const Vec2d& at) {
  const double coupler = 0.5 * (std::hypot(at.x + 1, at.y) + std::hypot(at.x - 1, at.y));
  return {std::abs(at.x) / coupler, coupler, std::abs(at.y)};
}

void add_crossing(const RockerArc& arc, const Vec2d& at, const ScaledLine& line,
                  RockerSolutions& found) {
  const ArcPoint point = elliptic(at);
  const int side = at.x < 0 ? -1 : 1;
  const double q = (point.coupler - 1) * (point.coupler + 1);
  const auto design =
      on_arc(arc, q) ? arc.confirmed(point, side, RockerGiven::line, line.normal) : std::nullopt;
  if (design) {
    found.designs.push_back(*design);
  } else if (q > 0) {
    ++found.circuit_defects;
  }
}

/// A horizontal line finds both images at once: the right one is then the mirror of the left, and
/// follows it.
void mark_mirrors(RockerSolutions& found) {
  for (QuickReturnRocker& design : found.designs) {
    const Vec2d& a = design.linkage.pivot_a;
    design.mirror = a.x > 0 && std::ranges::any_of(found.designs, [&](const auto& other) {
                      const Vec2d& b = other.linkage.pivot_a;
                      return std::hypot(a.x + b.x, a.y - b.y) <= 64 * kEpsilon * norm(a);
                    });
  }
  std::ranges::stable_sort(found.designs, {}, [](const QuickReturnRocker& design) {
    return std::pair(design.arc, design.mirror);
  });
}

}  // namespace

std::optional<ArcLimits> arc_limits(const RockerTask& task, PivotArc arc) {
  const RockerArc pivots(task, arc);
  if (!(pivots.end() > 0)) return std::nullopt;
  return pivots.limits();
}

RockerSolutions rockers_with_crank(const RockerTask& task, double crank) {
  RockerSolutions found;
  for (const PivotArc arc : distinct_arcs(task)) {
    const RockerArc pivots(task, arc);
    const auto q = pivots.of_crank(crank);
    if (!q) {
      const bool the_one = std::abs(crank - pivots.h()) <= 16 * kEpsilon * pivots.h();
      if (the_one) found.degeneracy = RockerDegeneracy::any_coupler;
      continue;
    }
    if (!on_arc(pivots, *q)) continue;
    ArcPoint point = pivots.at(*q);
    point.crank = crank / pivots.h();
    add_pair(pivots, point, RockerGiven::crank, found);
  }
  return found;
}

RockerSolutions rockers_with_coupler(const RockerTask& task, double coupler) {
  RockerSolutions found;
  for (const PivotArc arc : distinct_arcs(task)) {
    const RockerArc pivots(task, arc);
    const auto q = pivots.of_coupler(coupler);
    if (!q || !on_arc(pivots, *q)) continue;
    ArcPoint point = pivots.at(*q);
    point.coupler = coupler / pivots.h();
    add_pair(pivots, point, RockerGiven::coupler, found);
  }
  return found;
}

RockerSolutions rockers_with_frame(const RockerTask& task, double frame) {
  RockerSolutions found;
  for (const PivotArc arc : distinct_arcs(task)) {
    const RockerArc pivots(task, arc);
    const auto q = pivots.of_frame(frame);
    if (!q) {
      found.degeneracy = RockerDegeneracy::one_frame;
      continue;
    }
    if (on_arc(pivots, *q)) add_pair(pivots, pivots.at(*q), RockerGiven::frame, found);
  }
  return found;
}

RockerSolutions rockers_on_line(const RockerTask& task, const PivotLine& line) {
  RockerSolutions found;
  for (const PivotArc arc : distinct_arcs(task)) {
    const RockerArc pivots(task, arc);
    const ScaledLine own = scaled(line, pivots);
    if (pivots.angle().half_sine == 0 && own.normal.x == 0 && std::abs(own.foot) <= 16 * kEpsilon) {
      found.degeneracy = RockerDegeneracy::line_is_the_arc;
      return found;
    }
    const Roots roots = crossings(own, pivots.angle(), arc);
    for (int i = 0; i < roots.count; ++i) {
      const Vec2d at = own.foot * own.normal + roots.at[i] * perp(own.normal);
      const bool on_this_arc = task.time_ratio == 1 || sign(arc) * at.y > 0;
      if (on_this_arc) add_crossing(pivots, at, own, found);
    }
  }
  mark_mirrors(found);
  return found;
}

}  // namespace cognate::synthesis
