/// Burmester's curves as polylines.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "synthesis/exact/motion/burmester_curves.hpp"

namespace cognate::synthesis {
namespace {

using Point = BurmesterCurves::Point;

constexpr int kFirstPoints = 48;
constexpr int kDeepest = 40;
/// Beyond so many times the reach a pivot counts as one at infinity.
constexpr double kFarStep = 100;

/// A pivot as far as it can be drawn: at infinity it is empty.
std::optional<Vec2d> fixed_of(const GuidingDyad& dyad) {
  if (dyad.kind == DyadKind::pr) return std::nullopt;
  return dyad.fixed;
}

std::optional<Vec2d> moving_of(const GuidingDyad& dyad) {
  if (dyad.kind == DyadKind::rp) return std::nullopt;
  return dyad.moving;
}

/// Points are put between two others until they are close.
class Tracer {
 public:
  Tracer(const BurmesterCurves& curves, int branch, const Vec2d& centre, double gap, double radius,
         int limit)
      : curves_(curves),
        branch_(branch),
        centre_(centre),
        gap_(gap),
        radius_(radius),
        limit_(static_cast<std::size_t>(std::max(limit, 0))) {}

  std::vector<Point> operator()() {
    std::optional<Point> last;
    for (int k = 0; k <= kFirstPoints; ++k) {
      const std::optional<Point> next = at(static_cast<double>(k) / kFirstPoints);
      if (!next) continue;
      if (last) fill(*last, *next, kDeepest);
      add(*next);
      last = next;
    }
    return std::move(points_);
  }

 private:
  std::optional<Point> at(double parameter) const {
    const DyadSolutions found = curves_.at(branch_, parameter);
    if (found.count == 0) return std::nullopt;
    return Point{parameter, found.storage[0]};
  }

  void add(const Point& point) {
    if (points_.size() < limit_) points_.push_back(point);
  }

  void fill(const Point& from, const Point& to, int depth) {
    if (depth == 0 || points_.size() >= limit_ || are_close(from.dyad, to.dyad)) return;
    const std::optional<Point> middle = at(0.5 * (from.parameter + to.parameter));
    if (!middle) return;
    fill(from, *middle, depth - 1);
    add(*middle);
    fill(*middle, to, depth - 1);
  }

  bool are_close(const GuidingDyad& a, const GuidingDyad& b) const {
    return close(fixed_of(a), fixed_of(b)) && close(moving_of(a), moving_of(b));
  }

  /// Far away the gap may grow with the distance, so that no stretch is stepped over that passes
  /// near the poses.
  bool close(const std::optional<Vec2d>& a, const std::optional<Vec2d>& b) const {
    if (!a && !b) return true;
    if (!a || !b) return norm((a ? *a : *b) - centre_) >= kFarStep * radius_;
    const double nearest = std::min(norm(*a - centre_), norm(*b - centre_));
    return norm(*a - *b) <= std::max(gap_, 0.5 * (nearest - radius_));
  }

  const BurmesterCurves& curves_;
  int branch_;
  Vec2d centre_;
  double gap_, radius_;
  std::size_t limit_;
  std::vector<Point> points_;
};

}  // namespace

std::vector<Point> BurmesterCurves::trace(int branch, double spacing, double reach,
                                          int limit) const {
  const Window size = window();
  return Tracer(*this, branch, size.centre, spacing * size.extent, reach * size.extent, limit)();
}

}  // namespace cognate::synthesis
