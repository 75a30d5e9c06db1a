#include "analysis/cam/changed_follower.hpp"

#include <cmath>

namespace cognate::cam {
namespace {

constexpr int kMostSteps = 30;
constexpr double kMet = 1e-14;
/// Newton's steps square what they leave: after one from a miss and with a way within these, the
/// rest is rounding.
constexpr double kNearlyMet = 1e-9, kShortWay = 1e-7;
constexpr double kLongestStep = 0.1;

Vec2d turned(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

struct Residual {
  double value, rate;
};

/// One of Newton's steps for a residual that is to vanish relative to `size`.
struct NewtonStep {
  double way = 0;
  bool is_last = false;
};

/// Empty where the residual leads nowhere.
std::optional<NewtonStep> newton_step(const Residual& miss, double size) {
  if (!std::isfinite(miss.value) || !std::isfinite(miss.rate) || miss.rate == 0) return {};
  const double way = -miss.value / miss.rate, left = std::abs(miss.value);
  if (std::abs(way) > kLongestStep) return NewtonStep{std::copysign(kLongestStep, way), false};
  const bool is_near = left <= kNearlyMet * size && std::abs(way) <= kShortWay;
  return NewtonStep{way, is_near || left <= kMet * size};
}

}  // namespace

/// A point of the curve on which the follower's own point lies, as the frame has it, with its
/// derivative by where it is along the curve.
struct ChangedFollower::CurvePlace {
  Vec2d at;
  Vec2d tangent;
  double stretch = 1;  ///< of the tangent by the raise; not positive beyond an undercut
};

ChangedFollower::ChangedFollower(const Cam& cam, double angle)
    : cam_(cam), angle_(angle), motion_(cam.programme.at(angle)) {
  if (!is_flat(cam.system.follower.type)) {
    state_ = roller_state(cam.system.follower, cam.system.start, motion_);
  }
}

/// The roller's centre where it touches the raised profile at the normal of a state, turned into
/// the frame.
ChangedFollower::CurvePlace ChangedFollower::raised(const RollerState<double>& state, double raise,
                                                    const Vec2d& turn) const {
  const Vec2d normal = (1 / std::sqrt(squared_norm(state.tangent))) * perp(state.tangent);
  const double stretch = 1 + raise * pitch_curvature(state);
  return {turn * (state.centre + raise * normal), stretch * (turn * state.tangent), stretch};
}

/// At the normal of the cam angle `along`, the cam standing at its angle.
ChangedFollower::CurvePlace ChangedFollower::raised_at(double along, double raise) const {
  const auto state =
      roller_state(cam_.system.follower, cam_.system.start, cam_.programme.at(along));
  return raised(state, raise, turned(angle_ - along));
}

/// Newton's steps along the raised curve, from where the roller touches as designed, until
/// `miss(place)` vanishes relative to `size`. Empty where it does not, or the curve is undercut.
template <class Miss>
std::optional<Vec2d> ChangedFollower::touching(double raise, double size, const Miss& miss) const {
  double along = angle_;
  CurvePlace place = raised(state_, raise, {1, 0});
  for (int step = 0; step < kMostSteps; ++step) {
    const auto next = newton_step(miss(place), size);
    if (!next) return std::nullopt;
    if (next->is_last) {
      if (!(place.stretch > 0)) return std::nullopt;
      return place.at + next->way * place.tangent;
    }
    along += next->way;
    place = raised_at(along, raise);
  }
  return std::nullopt;
}

std::optional<double> ChangedFollower::of_translating_roller(
    const CamDimensions<double>& changes) const {
  const auto& d = cam_.system.follower.dimensions;
  const double offset = d.offset + changes.offset;
  const auto centre = touching(changes.base_radius + changes.roller_radius, d.base_radius,
                               [&](const CurvePlace& place) {
                                 return Residual{place.at.x - offset, place.tangent.x};
                               });
  if (!centre) return std::nullopt;
  return centre->y - (cam_.system.start + motion_.displacement);
}

std::optional<double> ChangedFollower::of_oscillating_roller(
    const CamDimensions<double>& changes) const {
  const auto& d = cam_.system.follower.dimensions;
  const double arm = d.arm + changes.arm;
  const Vec2d pivot{0, d.centre_distance + changes.centre_distance};
  const auto centre =
      touching(changes.base_radius + changes.roller_radius, d.arm, [&](const CurvePlace& place) {
        const Vec2d reach = place.at - pivot;
        const double length = std::sqrt(squared_norm(reach));
        return Residual{length - arm, dot(reach, place.tangent) / length};
      });
  if (!centre) return std::nullopt;
  const Vec2d reach = *centre - pivot;
  const double place = std::atan2(-sign_of(cam_.system.follower.side) * reach.x, -reach.y);
  return place - (cam_.system.start + motion_.displacement);
}

/// The face at angle θ has the normal (−sign cos θ, sin θ) and lies a sin θ − f from the centre: so
/// far as the raised profile reaches along that normal.
std::optional<double> ChangedFollower::of_oscillating_face(
    const CamDimensions<double>& changes) const {
  const auto& d = cam_.system.follower.dimensions;
  const double sign = sign_of(cam_.system.follower.side);
  const double distance = d.centre_distance + changes.centre_distance;
  const double face = d.face_offset + changes.face_offset;
  double along = angle_;
  FollowerMotion<double> motion = motion_;
  for (int step = 0; step < kMostSteps; ++step) {
    const double own = cam_.system.start + motion.displacement;
    const double place = own + sign * (along - angle_);
    const double turn = 1 + sign * motion.velocity;  // of the normal as the cam has it
    const double reach = d.centre_distance * std::sin(own) - d.face_offset;
    const Residual miss{reach + changes.base_radius - (distance * std::sin(place) - face),
                        d.centre_distance * std::cos(own) * motion.velocity -
                            sign * distance * std::cos(place) * turn};
    const auto next = newton_step(miss, d.centre_distance);
    if (!next) return std::nullopt;
    if (next->is_last) {
      return place + sign * turn * next->way - (cam_.system.start + motion_.displacement);
    }
    along += next->way;
    motion = cam_.programme.at(along);
  }
  return std::nullopt;
}

std::optional<double> ChangedFollower::misplacement(const CamDimensions<double>& changes) const {
  switch (cam_.system.follower.type) {
    case FollowerType::translating_flat:
      return changes.base_radius;
    case FollowerType::oscillating_flat:
      return of_oscillating_face(changes);
    case FollowerType::oscillating_roller:
    case FollowerType::oscillating_knife:
      return of_oscillating_roller(changes);
    default:
      return of_translating_roller(changes);
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
