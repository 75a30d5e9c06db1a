#include "analysis/cam/changed_follower.hpp"

#include <cmath>

namespace cognate::cam {
namespace {

constexpr int kMostSteps = 30;
constexpr double kMet = 1e-14;

/// A point of the curve on which the follower's own point lies, as the frame has it at one cam
/// angle, with its derivative by where it is along the curve.
struct CurvePlace {
  Vec2d at;
  Vec2d tangent;
  double stretch = 1;  ///< of the tangent by the raise; not positive beyond an undercut
};

Vec2d turned(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The roller's centre where it touches the raised profile at the normal of cam angle `along`, the
/// cam standing at `angle`.
CurvePlace roller_place(const Cam& cam, double raise, double along, double angle) {
  const auto state = roller_state(cam.system.follower, cam.system.start, cam.programme.at(along));
  const double length = norm(state.tangent);
  const Vec2d normal = (1 / length) * perp(state.tangent);
  const Vec2d turn = turned(angle - along);
  const double stretch = 1 + raise * pitch_curvature(state);
  return {turn * (state.centre + raise * normal), stretch * (turn * state.tangent), stretch};
}

/// Newton's steps from `along` until `miss(along)` = {value, derivative} vanishes, relative to
/// `size`.
template <class Miss>
std::optional<double> solved(const Miss& miss, double along, double size) {
  constexpr double kLongestStep = 0.1;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto [value, rate] = miss(along);
    if (!std::isfinite(value) || !std::isfinite(rate) || rate == 0) return std::nullopt;
    const double way = -value / rate;
    along += std::abs(way) > kLongestStep ? std::copysign(kLongestStep, way) : way;
    if (std::abs(value) <= kMet * size) return along;
  }
  return std::nullopt;
}

struct Residual {
  double value, rate;
};

std::optional<double> of_translating_roller(const Cam& cam, const CamDimensions<double>& changes,
                                            double angle) {
  const auto& d = cam.system.follower.dimensions;
  const double raise = changes.base_radius + changes.roller_radius;
  const double offset = d.offset + changes.offset;
  const auto along = solved(
      [&](double at) {
        const CurvePlace place = roller_place(cam, raise, at, angle);
        return Residual{place.at.x - offset, place.tangent.x};
      },
      angle, d.base_radius);
  if (!along) return std::nullopt;
  const CurvePlace place = roller_place(cam, raise, *along, angle);
  if (!(place.stretch > 0)) return std::nullopt;
  return place.at.y - (cam.system.start + cam.programme.at(angle).displacement);
}

std::optional<double> of_oscillating_roller(const Cam& cam, const CamDimensions<double>& changes,
                                            double angle) {
  const auto& d = cam.system.follower.dimensions;
  const double raise = changes.base_radius + changes.roller_radius;
  const double arm = d.arm + changes.arm;
  const Vec2d pivot{0, d.centre_distance + changes.centre_distance};
  const auto along = solved(
      [&](double at) {
        const CurvePlace place = roller_place(cam, raise, at, angle);
        const Vec2d reach = place.at - pivot;
        const double length = norm(reach);
        return Residual{length - arm, dot(reach, place.tangent) / length};
      },
      angle, d.arm);
  if (!along) return std::nullopt;
  const CurvePlace contact = roller_place(cam, raise, *along, angle);
  if (!(contact.stretch > 0)) return std::nullopt;
  const Vec2d reach = contact.at - pivot;
  const double place = std::atan2(-sign_of(cam.system.follower.side) * reach.x, -reach.y);
  return place - (cam.system.start + cam.programme.at(angle).displacement);
}

/// The face at angle θ has the normal (−sign cos θ, sin θ) and lies a sin θ − f from the centre: so
/// far as the raised profile reaches along that normal.
std::optional<double> of_oscillating_face(const Cam& cam, const CamDimensions<double>& changes,
                                          double angle) {
  const auto& d = cam.system.follower.dimensions;
  const double sign = sign_of(cam.system.follower.side);
  const double distance = d.centre_distance + changes.centre_distance;
  const double face = d.face_offset + changes.face_offset;
  const auto place_at = [&](double along) {
    return cam.system.start + cam.programme.at(along).displacement + sign * (along - angle);
  };
  const auto along = solved(
      [&](double at) {
        const auto motion = cam.programme.at(at);
        const double own = cam.system.start + motion.displacement, place = place_at(at);
        const double turn = 1 + sign * motion.velocity;  // of the normal as the cam has it
        const double reach = d.centre_distance * std::sin(own) - d.face_offset;
        return Residual{reach + changes.base_radius - (distance * std::sin(place) - face),
                        d.centre_distance * std::cos(own) * motion.velocity -
                            sign * distance * std::cos(place) * turn};
      },
      angle, d.centre_distance);
  if (!along) return std::nullopt;
  return place_at(*along) - (cam.system.start + cam.programme.at(angle).displacement);
}

}  // namespace

std::optional<double> misplacement(const Cam& cam, const CamDimensions<double>& changes,
                                   double angle) {
  switch (cam.system.follower.type) {
    case FollowerType::translating_flat:
      return changes.base_radius;
    case FollowerType::oscillating_flat:
      return of_oscillating_face(cam, changes, angle);
    case FollowerType::oscillating_roller:
    case FollowerType::oscillating_knife:
      return of_oscillating_roller(cam, changes, angle);
    default:
      return of_translating_roller(cam, changes, angle);
  }
}

std::array<double, 6> misplacement_rates(const Cam& cam, double angle) {
  const auto& follower = cam.system.follower;
  const auto motion = cam.programme.at(angle);
  if (follower.type == FollowerType::translating_flat) return {1, 0, 0, 0, 0, 0};
  if (follower.type == FollowerType::oscillating_flat) {
    const auto state = face_state(follower, cam.system.start, motion);
    const double place = cam.system.start + motion.displacement;
    return {1 / state.reach, 0, 0, -std::sin(place) / state.reach, 0, 1 / state.reach};
  }
  const auto state = roller_state(follower, cam.system.start, motion);
  const double length = norm(state.tangent);
  if (!has_arm(follower.type)) {
    const double along_normal = length / state.along, slope = state.across / state.along;
    return {along_normal, slope, along_normal, 0, 0, 0};
  }
  // The centre moves by T δ + N raise, T being the tangent: (centre − pivot)·that = arm·δarm.
  const auto& d = follower.dimensions;
  const Vec2d normal = (1 / length) * perp(state.tangent);
  const Vec2d along_arm = (1 / d.arm) * (state.centre - Vec2d{0, d.centre_distance});
  const double sign = sign_of(follower.side);
  const auto rate = [&](double arm, const Vec2d& way) {
    const double shift = (arm - dot(along_arm, way)) / dot(along_arm, state.tangent);
    const Vec2d moved = way + shift * state.tangent;
    return sign * cross(moved, along_arm) / d.arm;
  };
  const double by_raise = rate(0, normal);
  return {by_raise, 0, by_raise, rate(0, {0, -1}), rate(1, {}), 0};
}

}  // namespace cognate::cam
