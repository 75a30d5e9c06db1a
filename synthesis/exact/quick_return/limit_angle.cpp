#include "synthesis/exact/quick_return/limit_angle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/arc.hpp"

namespace cognate::synthesis {
namespace {

/// λ > 0 with a λ² − 2 b λ + c = 0, a ≥ 0; a discriminant that rounding explains counts as 0.
struct PositiveRoots {
  int count = 0;
  std::array<double, 2> at{};

  void add(double root) {
    if (std::isfinite(root) && root > 0) at[static_cast<std::size_t>(count++)] = root;
  }
};

PositiveRoots positive_roots(double a, double b, double c) {
  double discriminant = b * b - a * c;
  if (discriminant < -8 * kEpsilon * (b * b + std::abs(a * c))) return {};
  discriminant = std::max(0.0, discriminant);
  const double sum = b + std::copysign(std::sqrt(discriminant), b);
  PositiveRoots roots;
  if (sum == 0) return roots;
  const double first = c / sum, second = sum / a;
  roots.add(first);
  if (second != first) roots.add(second);
  return roots;
}

/// Of A from the bisector of the swing, in (0, π).
double pivot_angle(double swing, const RockerLimitAngle& given) {
  const double half = 0.5 * swing;
  return kPi - given.angle + (given.limit == RockerLimit::outer ? -half : half);
}

/// A pivot left of the bisector: where it stands over h from the middle of C₁C₂.
ArcPoint arc_point(const Vec2d& at) {
  const double coupler = 0.5 * (std::hypot(at.x + 1, at.y) + std::hypot(at.x - 1, at.y));
  return {std::abs(at.x) / coupler, coupler, std::abs(at.y)};
}

bool is_between_limits(const RockerArc& arc, const ArcPoint& point) {
  const double q = (point.coupler - 1) * (point.coupler + 1);
  return q > 0 && q < arc.end();
}

/// Adds the linkage whose frame is λ rockers long on the ray at `angle`, and its mirror image.
void add_on_ray(const RockerArc& arc, PivotArc side_of_limits, double angle, double ratio,
                bool one_line, RockerSolutions& found) {
  const double frame = ratio * arc.rocker() / arc.h();
  const Vec2d at{-frame * std::sin(angle), frame * std::cos(angle) - arc.y0() / arc.h()};
  if (!one_line && !(sign(side_of_limits) * at.y > 0)) return;
  const ArcPoint point = arc_point(at);
  if (!is_between_limits(arc, point)) return;
  const Vec2d gradient = (1 / frame) * Vec2d{std::cos(angle), std::sin(angle)};
  for (const int side : {-1, 1}) {
    const Vec2d own{-side * gradient.x, gradient.y};
    if (const auto design = arc.confirmed(point, side, RockerGiven::limit, own)) {
      found.designs.push_back(*design);
    }
  }
}

/// The other limit of a rocker of which one is known, seen from A with D on the x axis.
struct OtherLimit {
  double reach = 0;                   ///< of A from it
  double angle = 0;                   ///< of the rocker
  double by_theta = 0, by_angle = 0;  ///< derivatives of the reach
};

/// The spectral norm of the derivatives of (l₁, l₂) by θ and the angle, over l₂; at least 1.
double condition_of(const OtherLimit& other, double known_by_angle, double coupler) {
  // l₁, l₂ = (reach ± known)/2 up to sign, an orthogonal map scaled by √½.
  const double a = other.by_theta, b = other.by_angle, c = known_by_angle;
  const double sum = a * a + b * b + c * c, determinant = a * c;
  const double root = std::sqrt(std::max(0.0, sum * sum - 4 * determinant * determinant));
  return std::max(1.0, std::sqrt(0.25 * (sum + root)) / coupler);
}

class FrameAtLimit {
 public:
  FrameAtLimit(const RockerFrameTask& task, const RockerLimitAngle& given)
      : task_(task), given_(given), theta_(return_angle(task.time_ratio).angle) {
    // As the chord of the triangle whose angle at D is π − β, to all digits.
    const double half = 0.5 * given.angle, sine = std::sin(half), cosine = std::cos(half);
    const double sum = task.frame + task.rocker, difference = task.frame - task.rocker;
    known_ = std::hypot(sum * cosine, difference * sine);
    direction_ = std::atan2(task.rocker * std::sin(given.angle),
                            task.frame + task.rocker * std::cos(given.angle));
    known_by_angle_ = -task.frame * task.rocker * std::sin(given.angle) / known_;
    // Of the direction, by the rocker's angle: the part of its motion across AC₁.
    turn_ = task.rocker * std::cos(given.angle - direction_) / known_;
  }

  RockerSolutions solutions() {
    if (!(known_ > 0)) return {};
    add_turned(theta_, 1);
    if (theta_ > 0) add_turned(-theta_, -1);
    std::ranges::stable_sort(found_.designs, {}, [](const auto& design) { return design.arc; });
    return found_;
  }

 private:
  void add_turned(double by, double sense) {
    const double direction = direction_ + by;
    const double foot = task_.frame * std::cos(direction);
    const double power = (task_.frame - task_.rocker) * (task_.frame + task_.rocker);
    PositiveRoots roots = positive_roots(1, foot, power);
    if (by == 0) {
      // Both limits lie on one ray, and one of the roots is the limit that is known.
      roots = {};
      roots.add(power / known_);
    }
    for (int i = 0; i < roots.count; ++i) {
      const double reach = roots.at[static_cast<std::size_t>(i)];
      const double rate = -task_.frame * std::sin(direction) * reach / (reach - foot);
      add({reach,
           std::atan2(reach * std::sin(direction), reach * std::cos(direction) - task_.frame),
           sense * rate, turn_ * rate});
    }
  }

  void add(const OtherLimit& other) {
    const bool outer = given_.limit == RockerLimit::outer;
    const double longer = outer ? known_ : other.reach, shorter = outer ? other.reach : known_;
    const double first = outer ? given_.angle : other.angle;
    const double last = outer ? other.angle : given_.angle;
    // Both limits on one side of A–D, the extended one nearer to the direction A→D.
    // A crank as short as rounding makes it is none.
    const bool has_crank = longer - shorter > 1e-12 * longer;
    if (!(has_crank && first > 0 && last > first && last < kPi)) return;
    const double swing = last - first, half = 0.5 * swing;
    const double alpha = pivot_angle(swing, {RockerLimit::outer, first});
    const double h = task_.rocker * std::sin(half), y0 = task_.rocker * std::cos(half);
    const double height = task_.frame * std::cos(alpha) - y0;
    const PivotArc arc = height > 0 && task_.time_ratio > 1 ? PivotArc::far : PivotArc::near;
    const RockerArc pivots({task_.time_ratio, task_.rocker, swing}, arc);
    const ArcPoint point{0.5 * (longer - shorter) / h, 0.5 * (longer + shorter) / h,
                         std::abs(height) / h};
    for (const int side : {-1, 1}) {
      auto design = pivots.confirmed(point, side, RockerGiven::coupler);
      if (!design) continue;
      design->condition = condition_of(other, known_by_angle_, design->linkage.coupler);
      if (std::isfinite(design->condition)) found_.designs.push_back(*design);
    }
  }

  RockerFrameTask task_;
  RockerLimitAngle given_;
  double theta_;
  double known_ = 0, direction_ = 0, known_by_angle_ = 0, turn_ = 0;
  RockerSolutions found_;
};

}  // namespace

RockerSolutions rockers_at_limit(const RockerTask& task, const RockerLimitAngle& given) {
  RockerSolutions found;
  const double alpha = pivot_angle(task.swing, given), half = 0.5 * task.swing;
  if (!(alpha > half && alpha < kPi - half)) return found;
  const ReturnAngle theta = return_angle(task.time_ratio);
  const bool one_line = task.time_ratio == 1;
  for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
    if (arc == PivotArc::far && one_line) break;
    const RockerArc pivots(task, arc);
    const double s = sign(arc);
    const PositiveRoots roots =
        positive_roots(theta.sine(), std::cos(alpha) * std::sin(theta.angle + s * half),
                       std::sin(theta.angle + s * task.swing));
    for (int i = 0; i < roots.count; ++i) {
      add_on_ray(pivots, arc, alpha, roots.at[static_cast<std::size_t>(i)], one_line, found);
    }
  }
  return found;
}

RockerSolutions rockers_with_frame_at_limit(const RockerFrameTask& task,
                                            const RockerLimitAngle& given) {
  if (!(given.angle > 0 && given.angle < kPi)) return {};
  return FrameAtLimit(task, given).solutions();
}

std::optional<LimitAngleRange> limit_angle_range(const RockerTask& task, PivotArc arc,
                                                 RockerLimit limit) {
  if (!(RockerArc(task, arc).end() > 0)) return std::nullopt;
  const ReturnAngle theta = return_angle(task.time_ratio);
  const double half = 0.5 * task.swing;
  // The steepest ray from D that meets the circle: it touches it, or D lies within.
  double steepest = kPi - half;
  const bool outside = theta.angle >= task.swing * (1 - 8 * kEpsilon);  // D, of the near circle
  if (arc == PivotArc::far || outside) {
    const double centre = theta.sine() / std::tan(half) + sign(arc) * theta.cosine();
    steepest = centre > 1 ? std::asin(1 / centre) : kRightAngle;
  }
  if (task.time_ratio == 1) steepest = kRightAngle;
  const double least = limit == RockerLimit::outer ? kPi - half - steepest : kPi + half - steepest;
  const double most = limit == RockerLimit::outer ? kPi - task.swing : kPi;
  return LimitAngleRange{least, most};
}

}  // namespace cognate::synthesis
