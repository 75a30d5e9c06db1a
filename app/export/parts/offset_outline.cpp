#include "app/export/parts/offset_outline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/cam/profile.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

/// A side of an outline: a line, or an arc about `centre`.
struct Side {
  Vec2d from{}, to{};
  Vec2d from_way{}, to_way{};  ///< unit tangents at the ends
  double angle = 0;            ///< of an arc, counter-clockwise; 0 of a line
  Vec2d centre{};
  double radius = 0;

  bool is_arc() const { return angle != 0; }
};

Vec2d turned(const Vec2d& way, double angle) {
  return Vec2d{std::cos(angle), std::sin(angle)} * way;
}

Side side_between(const PlanCorner& corner, const Vec2d& to) {
  const Vec2d chord = to - corner.at;
  const double length = norm(chord);
  const Vec2d way = (1 / length) * chord;
  Side side{corner.at, to, way, way};
  if (corner.bulge == 0) return side;
  side.angle = 4 * std::atan(corner.bulge);
  side.from_way = turned(way, -0.5 * side.angle);
  side.to_way = turned(way, 0.5 * side.angle);
  const double bulge = corner.bulge;
  side.radius = 0.25 * length * (1 + bulge * bulge) / std::abs(bulge);
  side.centre =
      corner.at + (0.25 * length * (1 - bulge * bulge) / bulge) * perp(way) + 0.5 * length * way;
  return side;
}

/// The sides of a closed outline, without those that have no length.
std::vector<Side> sides_of(const PlanOutline& outline) {
  std::vector<Side> sides;
  const auto& corners = outline.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d& to = corners[(i + 1) % corners.size()].at;
    if (norm(to - corners[i].at) > 0) sides.push_back(side_between(corners[i], to));
  }
  return sides;
}

Vec2d outward(const Vec2d& way) {
  return -perp(way);
}

/// Where the line through `at` along `way` meets the circle, next to `at`.
std::optional<Vec2d> line_and_circle(const Vec2d& at, const Vec2d& way, const Vec2d& centre,
                                     double radius) {
  const Vec2d from = at - centre;
  const double along = dot(from, way), across = cross(way, from);
  const double square = (radius - across) * (radius + across);
  if (square < 0) return std::nullopt;
  const double half = std::sqrt(square);
  const double step = -along + (along > 0 ? half : -half);
  return at + step * way;
}

/// Where two circles meet, next to `near`.
std::optional<Vec2d> circle_and_circle(const Side& a, double radius_a, const Side& b,
                                       double radius_b, const Vec2d& near) {
  const Vec2d way = b.centre - a.centre;
  const double apart = norm(way);
  if (!(apart > 1e-12 * (radius_a + radius_b))) return near;  // arcs of one circle
  const double along = 0.5 * (apart + (radius_a - radius_b) * (radius_a + radius_b) / apart);
  const double square = (radius_a - along) * (radius_a + along);
  if (square < 0) return std::nullopt;
  const Vec2d unit = (1 / apart) * way;
  const double side = dot(near - a.centre, perp(unit)) < 0 ? -1 : 1;
  return a.centre + along * unit + (side * std::sqrt(square)) * perp(unit);
}

class OutlineOffset {
 public:
  OutlineOffset(const PlanOutline& outline, double distance, double slack)
      : outline_(outline), distance_(distance), slack_(slack), sides_(sides_of(outline)) {}

  std::optional<PlanOutline> make() {
    const std::size_t count = sides_.size();
    if (count < 2) return std::nullopt;
    joints_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto joint = joint_after(sides_[i], sides_[(i + 1) % count]);
      if (!joint) return std::nullopt;
      joints_[i] = *joint;
    }
    PlanOutline made{outline_.layer, {}, true};
    for (std::size_t i = 0; i < count; ++i) {
      if (!append(sides_[i], joints_[(i + count - 1) % count], joints_[i], made)) {
        return std::nullopt;
      }
    }
    return crosses_itself(made) ? std::nullopt : std::optional(std::move(made));
  }

 private:
  /// Where one side ends and the next begins: apart where an arc lies between them.
  struct Joint {
    Vec2d end{}, begin{};
    double bulge = 0;
  };

  double radius(const Side& side) const {
    return side.angle > 0 ? side.radius + distance_ : side.radius - distance_;
  }

  std::optional<Joint> joint_after(const Side& side, const Side& next) const {
    const Vec2d at = side.to;
    const Vec2d end = at + distance_ * outward(side.to_way);
    const Vec2d begin = at + distance_ * outward(next.from_way);
    const double cosine = dot(side.to_way, next.from_way);
    const double turn = std::atan2(cross(side.to_way, next.from_way), cosine);
    constexpr double kSmooth = 1e-9;
    if (std::abs(turn) < kSmooth) return Joint{end, end};
    if (turn * distance_ > 0 && !is_mitred(side, next, turn)) {
      return Joint{end, begin, std::tan(0.25 * turn)};
    }
    const auto meeting = meeting_of(side, next, end, cosine);
    return meeting ? std::optional(Joint{*meeting, *meeting}) : std::nullopt;
  }

  bool is_mitred(const Side& side, const Side& next, double turn) const {
    const double excess = std::abs(distance_) * (1 / std::cos(0.5 * turn) - 1);
    return !side.is_arc() && !next.is_arc() && excess >= 0 && excess <= slack_;
  }

  /// Where the moved sides meet.
  std::optional<Vec2d> meeting_of(const Side& side, const Side& next, const Vec2d& end,
                                  double cosine) const {
    const Vec2d begin = next.from + distance_ * outward(next.from_way);
    if (side.is_arc() && next.is_arc()) {
      return circle_and_circle(side, radius(side), next, radius(next), 0.5 * (end + begin));
    }
    if (side.is_arc()) return line_and_circle(begin, next.from_way, side.centre, radius(side));
    if (next.is_arc()) return line_and_circle(end, side.to_way, next.centre, radius(next));
    const Vec2d normals = outward(side.to_way) + outward(next.from_way);
    if (!(1 + cosine > 1e-9)) return std::nullopt;
    return side.to + (distance_ / (1 + cosine)) * normals;
  }

  /// False where nothing is left of the side.
  bool append(const Side& side, const Joint& before, const Joint& after, PlanOutline& made) const {
    const Vec2d from = before.begin, to = after.end;
    double bulge = 0;
    if (!side.is_arc()) {
      if (!(dot(to - from, side.from_way) > 0)) return false;
    } else {
      if (!(radius(side) > 0)) return false;
      const Vec2d a = from - side.centre, b = to - side.centre;
      double angle = std::atan2(cross(a, b), dot(a, b));
      if (angle - side.angle > kPi) angle -= kTurn;
      if (side.angle - angle > kPi) angle += kTurn;
      if (!(angle * side.angle > 0)) return false;
      bulge = std::tan(0.25 * angle);
    }
    made.corners.push_back({from, bulge});
    if (after.bulge != 0) made.corners.push_back({to, after.bulge});
    return true;
  }

  static bool crosses_itself(const PlanOutline& made) {
    std::vector<cam::ProfilePoint> points;
    const auto add = [&](const Vec2d& at) { points.emplace_back().at = at; };
    const auto& corners = made.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      add(corners[i].at);
      const Vec2d& to = corners[(i + 1) % corners.size()].at;
      if (corners[i].bulge == 0 || !(norm(to - corners[i].at) > 0)) continue;
      const Side arc = side_between(corners[i], to);
      const int steps = static_cast<int>(std::ceil(std::abs(arc.angle) / 0.1));
      for (int k = 1; k < steps; ++k) {
        add(arc.centre + turned(arc.from - arc.centre, arc.angle * k / steps));
      }
    }
    return cam::crosses_itself(points);
  }

  const PlanOutline& outline_;
  double distance_, slack_;
  std::vector<Side> sides_;
  std::vector<Joint> joints_;  ///< after each side
};

}  // namespace

std::optional<PlanOutline> offset_outline(const PlanOutline& outline, double distance,
                                          double slack) {
  if (distance == 0) return outline;
  return OutlineOffset(outline, distance, slack).make();
}

PlanOutline rounded_outline(const std::string& layer, const std::vector<Vec2d>& hull,
                            double distance) {
  PlanOutline outline{layer, {}, true};
  const std::size_t count = hull.size();
  if (count < 2) return outline;
  const auto along = [&](std::size_t i) {
    const Vec2d way = hull[(i + 1) % count] - hull[i % count];
    return (1 / norm(way)) * way;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d here = along(i), next = along(i + 1);
    const Vec2d out = (-distance) * perp(here);
    // The turn from one side to the next is half a turn at most: an arc about the corner.
    double turn = std::atan2(cross(here, next), dot(here, next));
    if (turn < 0) turn = -turn;
    if (distance == 0) {
      outline.corners.push_back({hull[i]});
      continue;
    }
    outline.corners.push_back({hull[i] + out});
    outline.corners.push_back({hull[(i + 1) % count] + out, std::tan(turn / 4)});
  }
  return outline;
}

}  // namespace cognate::app
