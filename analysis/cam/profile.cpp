#include "analysis/cam/profile.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cam {
namespace {

ProfilePoint roller_point(const CamCurve& curve, const FollowerMotion<double>& motion) {
  const auto state = roller_state(curve.cam.follower, curve.cam.start, motion);
  const double length = norm(state.tangent);
  const Vec2d normal = (1 / length) * perp(state.tangent);
  return {0, state.centre + curve.distance * normal, normal, pitch_curvature(state)};
}

ProfilePoint face_point(const CamCurve& curve, const FollowerMotion<double>& motion) {
  const auto state = face_state(curve.cam.follower, curve.cam.start, motion);
  return {0, state.contact + curve.distance * state.normal, state.normal, 1 / state.radius};
}

/// The share of a piece at which a step of the polygon begins and ends.
struct Step {
  double from;
  double to;
};

class PolygonMaker {
 public:
  PolygonMaker(const CamCurve& curve, double tolerance, std::size_t most)
      : curve_(curve), tolerance_(tolerance), most_(most) {}

  std::vector<ProfilePoint> make() {
    const int count = static_cast<int>(curve_.programme.pieces().size());
    for (int piece = 0; piece < count; ++piece) {
      const ProfilePoint begin = curve_point(curve_, piece, 0);
      const ProfilePoint end = curve_point(curve_, piece, 1);
      turn_to(begin);
      add(begin);
      // Three parts, so that no symmetry hides a bend from the test at the middle.
      ProfilePoint from = begin;
      for (const Step step : {Step{0, 0.31}, Step{0.31, 0.67}, Step{0.67, 1}}) {
        const ProfilePoint to = step.to == 1 ? end : curve_point(curve_, piece, step.to);
        refine(piece, step, from, to, 0);
        add(to);
        from = to;
      }
    }
    if (!points_.empty()) turn_to(ProfilePoint(points_.front()));
    if (points_.size() > 1 && same(points_.front(), points_.back())) points_.pop_back();
    return std::move(points_);
  }

 private:
  static bool same(const ProfilePoint& a, const ProfilePoint& b) {
    return norm(a.at - b.at) <= 1e-13 * (norm(a.at) + norm(b.at));
  }

  void add(const ProfilePoint& point) {
    if (points_.empty() || !same(points_.back(), point)) points_.push_back(point);
  }

  /// Adds the arc between two normals at one place of the pitch curve, where a curve outside it
  /// (distance > 0) rounds a convex corner, or one inside a concave one.
  void turn_to(const ProfilePoint& next) {
    if (points_.empty()) return;
    const ProfilePoint last = points_.back();
    const double angle = std::atan2(cross(last.normal, next.normal), dot(last.normal, next.normal));
    const double radius = std::abs(curve_.distance);
    const bool opens = angle * curve_.distance < 0;  // clockwise along the curve is convex
    if (!opens || std::abs(angle) * radius <= tolerance_) return;
    const Vec2d corner = last.at - curve_.distance * last.normal;
    const double step = 2 * std::acos(std::max(-1.0, 1 - std::min(1.0, tolerance_ / radius)));
    const int parts = static_cast<int>(std::clamp(std::ceil(std::abs(angle) / step), 1.0, 1e5));
    for (int i = 1; i < parts; ++i) {
      const double part = angle * i / parts;
      const Vec2d normal = last.normal * unit_vector(part);
      add({last.angle, corner + curve_.distance * normal, normal, 1 / curve_.distance});
    }
  }

  /// Adds the points strictly inside a step that is not yet straight enough.
  void refine(int piece, Step step, const ProfilePoint& from, const ProfilePoint& to, int depth) {
    constexpr int kDeepest = 24;
    if (depth == kDeepest || points_.size() >= most_) return;
    if (depth > 0 && is_straight(piece, step, from, to)) return;
    const double middle = 0.5 * (step.from + step.to);
    const ProfilePoint point = curve_point(curve_, piece, middle);
    refine(piece, {step.from, middle}, from, point, depth + 1);
    add(point);
    refine(piece, {middle, step.to}, point, to, depth + 1);
  }

  /// Whether the curve stays within the tolerance of its chord: its height over it is looked at in
  /// seven places, with a reserve for what lies between them.
  bool is_straight(int piece, Step step, const ProfilePoint& from, const ProfilePoint& to) const {
    constexpr int kPlaces = 7;
    constexpr double kReserve = 0.9;
    const Vec2d chord = to.at - from.at;
    const double length = norm(chord);
    for (int i = 1; i <= kPlaces; ++i) {
      const double t = std::lerp(step.from, step.to, double(i) / (kPlaces + 1));
      const Vec2d at = curve_point(curve_, piece, t).at - from.at;
      const double along =
          length > 0 ? std::clamp(dot(at, chord) / (length * length), 0.0, 1.0) : 0;
      if (norm(at - along * chord) > kReserve * tolerance_) return false;
    }
    return true;
  }

  const CamCurve& curve_;
  double tolerance_;
  std::size_t most_;
  std::vector<ProfilePoint> points_;
};

}  // namespace

ProfilePoint curve_point(const CamCurve& curve, int piece, double t) {
  const auto& part = curve.programme.pieces()[static_cast<std::size_t>(piece)];
  const FollowerMotion<double> motion = motion_at(part, t);
  ProfilePoint point =
      is_flat(curve.cam.follower.type) ? face_point(curve, motion) : roller_point(curve, motion);
  point.angle = std::min(part.begin + t * part.span, kTurn);
  const Vec2d direction = unit_vector(point.angle);
  point.at = in_cam(point.at, direction);
  point.normal = in_cam(point.normal, direction);
  point.curvature = point.curvature / (1 + curve.distance * point.curvature);
  return point;
}

std::vector<ProfilePoint> polygon(const CamCurve& curve, double chord_tolerance, std::size_t most) {
  return PolygonMaker(curve, chord_tolerance, most).make();
}

}  // namespace cognate::cam
