#include "synthesis/exact/quick_return/arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

/// Where crank and coupler point at a limit: crank angle from the x axis.
double crank_angle(const Vec2d& pivot_a, const Vec2d& limit, bool folded) {
  const Vec2d along = folded ? pivot_a - limit : limit - pivot_a;
  return std::atan2(along.y, along.x);
}

/// How far the angles of the limit triangles may be off: lengths rounded to kEpsilon, over the
/// height of the flatter triangle.
double angle_tolerance(const Lengths<double>& links, const LimitPosition& outer,
                       const LimitPosition& inner) {
  const double longest = std::max({links.crank, links.coupler, links.rocker, links.frame});
  const double flattest =
      std::min(std::abs(std::sin(outer.rocker_angle)), std::abs(std::sin(inner.rocker_angle)));
  const double slope = (longest / links.rocker) * (longest / links.frame) / flattest;
  return 256 * kEpsilon * (1 + slope);
}

/// Errors of swing and θ as the analysis kernel finds them from the lengths; empty where it finds
/// no crank that turns fully between two limits.
struct Errors {
  double largest = 0;
  double tolerance = 0;
};

std::optional<Errors> simulate(const RockerTask& task, const ReturnAngle& wanted,
                               const Lengths<double>& links) {
  const auto outer = outer_limit(links), inner = inner_limit(links);
  const auto ratio = time_ratio(links);
  if (!outer || !inner || !ratio) return std::nullopt;
  const double swing = std::abs(outer->rocker_angle - inner->rocker_angle);
  const double angle = kPi * (*ratio - 1) / (*ratio + 1);
  return Errors{std::max(std::abs(swing - task.swing), std::abs(angle - wanted.angle)),
                angle_tolerance(links, *outer, *inner)};
}

}  // namespace

RockerArc::RockerArc(const RockerTask& task, PivotArc arc)
    : task_(task),
      arc_(arc),
      angle_(return_angle(task.time_ratio)),
      half_swing_(0.5 * task.swing),
      h_(task.rocker * std::sin(half_swing_)),
      y0_(task.rocker * std::cos(half_swing_)) {
  const double turned = half_swing_ + sign(arc) * angle_.angle;
  end_ = std::cos(half_swing_) * std::cos(turned) / (angle_.half_sine * angle_.half_sine);
  frame_slope_ =
      std::sin(turned) / (std::sin(half_swing_) * angle_.half_cosine * angle_.half_cosine);
}

std::optional<double> RockerArc::of_crank(double crank) const {
  const double t = angle_.half_tangent();
  if (t == 0) return std::nullopt;
  const double u = crank / h_;
  return (1 - u) * (1 + u) / (t * t);
}

std::optional<double> RockerArc::of_coupler(double coupler) const {
  const double v = coupler / h_;
  return (v - 1) * (v + 1);
}

std::optional<double> RockerArc::of_frame(double frame) const {
  if (std::abs(frame_slope_ * std::sin(half_swing_)) <= 4 * kEpsilon) return std::nullopt;
  const double longer = (frame - task_.rocker) / h_, sum = (frame + task_.rocker) / h_;
  return longer * sum / frame_slope_;
}

ArcPoint RockerArc::at(double q) const {
  const double t = angle_.half_tangent();
  const double height = t * q;
  return {std::sqrt(std::max(0.0, 1 - t * height)), std::sqrt(1 + q), height};
}

double RockerArc::kappa() const {
  const double turn = sign(arc_) * angle_.angle;
  const double middle = std::cos(half_swing_ + 0.5 * turn);
  return std::sin(half_swing_ + turn) * std::sin(half_swing_) / (middle * middle);
}

ArcLimits RockerArc::limits() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (angle_.half_sine == 0) return {{h_, h_}, {h_, infinite}, {task_.rocker, infinite}};
  const double middle = half_swing_ + 0.5 * sign(arc_) * angle_.angle;
  const double last_frame = task_.rocker * std::abs(std::sin(2 * middle)) / angle_.sine();
  return {{h_ * std::abs(std::sin(middle)) / angle_.half_cosine, h_},
          {h_, h_ * std::cos(middle) / angle_.half_sine},
          {std::min(task_.rocker, last_frame), std::max(task_.rocker, last_frame)}};
}

QuickReturnRocker RockerArc::design(const ArcPoint& point, int side) const {
  QuickReturnRocker result;
  result.arc = arc_;
  result.mirror = side > 0;
  FourBar& linkage = result.linkage;
  linkage.pivot_a = {side * h_ * point.crank * point.coupler, y0_ + sign(arc_) * h_ * point.height};
  linkage.crank = h_ * point.crank;
  linkage.coupler = h_ * point.coupler;
  linkage.rocker = task_.rocker;
  // The limit farther from A, on the other side of the bisector, is the extended one.
  const Vec2d outer{-side * h_, y0_}, inner{side * h_, y0_};
  linkage.assembly =
      cross(-linkage.pivot_a, outer - linkage.pivot_a) > 0 ? Assembly::open : Assembly::crossed;
  result.outer = crank_angle(linkage.pivot_a, outer, false);
  result.inner = crank_angle(linkage.pivot_a, inner, true);
  return result;
}

double RockerArc::condition(const QuickReturnRocker& design, const ArcPoint& point,
                            RockerGiven given, const Vec2d& normal) const {
  if (given == RockerGiven::crank) return pivot_condition(point, PivotGiven::crank);
  if (given == RockerGiven::coupler) return pivot_condition(point, PivotGiven::coupler);
  // Of ln l₄, and of the distance from the line in units of h; seen from the side where
  // `pivot_condition` takes the pivot to be.
  const Vec2d a = (1 / h_) * design.linkage.pivot_a;
  const Vec2d gradient = given == RockerGiven::frame ? (1 / squared_norm(a)) * a : normal;
  const double across = design.linkage.pivot_a.x < 0 ? -1 : 1;
  return pivot_condition(point, PivotGiven::place, {across * gradient.x, sign(arc_) * gradient.y});
}

std::optional<QuickReturnRocker> RockerArc::confirmed(const ArcPoint& point, int side,
                                                      RockerGiven given,
                                                      const Vec2d& normal) const {
  if (!(point.crank > 0)) return std::nullopt;
  QuickReturnRocker result = design(point, side);
  const Lengths<double> links = lengths(result.linkage);
  const auto errors = simulate(task_, angle_, links);
  if (!errors || !(errors->largest <= errors->tolerance)) return std::nullopt;
  result.residual = errors->largest;
  result.condition = condition(result, point, given, normal);
  if (!std::isfinite(result.condition)) return std::nullopt;
  result.transmission = transmission_angles(links);
  return result;
}

void add_pair(const RockerArc& arc, const ArcPoint& point, RockerGiven given,
              RockerSolutions& found) {
  for (const int side : {-1, 1}) {
    if (const auto design = arc.confirmed(point, side, given)) found.designs.push_back(*design);
  }
}

}  // namespace cognate::synthesis
