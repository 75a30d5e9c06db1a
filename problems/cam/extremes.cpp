#include "problems/cam/extremes.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems {
namespace {

using cam::CamQuantity;
using cam::MotionPart;
using cam::TurnExtremes;

ValueAt found(const cam::ExtremeAt& extreme) {
  return {extreme.value, extreme.place.angle};
}

/// Of the two the one that is farther from 0, with its own sign.
ValueAt larger(const TurnExtremes& all) {
  return std::abs(all.least.value) > std::abs(all.greatest.value) ? found(all.least)
                                                                  : found(all.greatest);
}

ValueAt with_size(ValueAt signed_value) {
  return {std::abs(signed_value.value), signed_value.angle};
}

double root(const cam::ExtremeAt& square) {
  return square.value < 0 ? 0 : std::sqrt(square.value);
}

}  // namespace

const TurnExtremes& CamExtremes::whole(CamQuantity quantity) const {
  auto& known = known_[static_cast<std::size_t>(quantity)];
  if (!known) {
    known = turn_extremes(cam_.programme, MotionPart::whole, cam_.system, quantity)
                .value_or(TurnExtremes{});
  }
  return *known;
}

const std::array<std::optional<TurnExtremes>, 3>& CamExtremes::pressure_of_strokes() const {
  if (!pressure_) {
    const auto over = [&](MotionPart stretch) {
      return turn_extremes(cam_.programme, stretch, cam_.system, CamQuantity::pressure_angle);
    };
    pressure_ = {over(MotionPart::rises), over(MotionPart::falls), over(MotionPart::dwells)};
  }
  return *pressure_;
}

ValueAt CamExtremes::pressure_angle() const {
  ValueAt greatest;
  for (const auto& stroke : pressure_of_strokes()) {
    if (!stroke) continue;
    const ValueAt here = with_size(larger(*stroke));
    if (here.value > greatest.value) greatest = here;
  }
  return greatest;
}

std::optional<ValueAt> CamExtremes::pressure_angle(MotionPart stretch) const {
  const auto& [rises, falls, dwells] = pressure_of_strokes();
  if (stretch == MotionPart::rises && rises) return with_size(larger(*rises));
  if (stretch == MotionPart::falls && falls) return with_size(larger(*falls));
  return std::nullopt;
}

std::optional<ValueAt> CamExtremes::working_pressure_angle(MotionPart stretch) const {
  const auto& [rises, falls, dwells] = pressure_of_strokes();
  if (stretch == MotionPart::rises && rises) return found(rises->greatest);
  if (stretch == MotionPart::falls && falls) {
    return ValueAt{-falls->least.value, falls->least.place.angle};
  }
  return std::nullopt;
}

std::optional<ValueAt> CamExtremes::smooth_convex_radius() const {
  const auto& follower = cam_.system.follower;
  if (is_flat(follower.type)) return found(whole(CamQuantity::face_radius).least);
  const auto& sharpest = whole(CamQuantity::pitch_curvature).greatest;
  if (!(sharpest.value > 0)) return std::nullopt;
  return ValueAt{1 / sharpest.value - follower.dimensions.roller_radius, sharpest.place.angle};
}

std::optional<ValueAt> CamExtremes::convex_radius() const {
  const auto& follower = cam_.system.follower;
  auto least = smooth_convex_radius();
  for (const cam::Jump& corner : corners()) {
    if (corner.after > corner.before) continue;
    const double radius =
        is_flat(follower.type) ? corner.after - corner.before : -follower.dimensions.roller_radius;
    if (!least || radius < least->value) least = ValueAt{radius, corner.angle};
  }
  return least;
}

std::optional<ValueAt> CamExtremes::concave_radius() const {
  const auto& follower = cam_.system.follower;
  if (is_flat(follower.type)) return std::nullopt;
  const double roller = follower.dimensions.roller_radius;
  std::optional<ValueAt> least;
  const auto& hollowest = whole(CamQuantity::pitch_curvature).least;
  if (hollowest.value < 0) least = ValueAt{roller - 1 / hollowest.value, hollowest.place.angle};
  for (const cam::Jump& corner : corners()) {
    if (corner.after > corner.before && (!least || roller < least->value)) {
      least = ValueAt{roller, corner.angle};
    }
  }
  return least;
}

const std::vector<cam::Jump>& CamExtremes::corners() const {
  if (!corners_) {
    corners_ = jumps(cam_.programme);
    std::erase_if(*corners_, [](const cam::Jump& jump) { return jump.order != 1; });
  }
  return *corners_;
}

double CamExtremes::least_along() const {
  const auto along = [&](const cam::FollowerMotion<double>& m) {
    return pressure_parts(cam_.system, m).along;
  };
  const auto all = turn_extremes(cam_.programme, MotionPart::whole, along);
  return all ? all->least.value : 0;
}

double CamExtremes::least_profile_radius() const {
  return root(whole(CamQuantity::squared_radius).least);
}

double CamExtremes::greatest_profile_radius() const {
  return root(whole(CamQuantity::squared_radius).greatest);
}

double CamExtremes::face_width() const {
  const TurnExtremes& reach = whole(CamQuantity::reach);
  return reach.greatest.value - reach.least.value;
}

ValueAt CamExtremes::contact_force(bool both_ways) const {
  const TurnExtremes& all = whole(CamQuantity::contact_force);
  if (!both_ways) return found(all.greatest);
  const ValueAt either = larger(all);
  return {std::abs(either.value), either.angle};
}

ValueAt CamExtremes::least_demand() const {
  return found(whole(CamQuantity::demand).least);
}

ValueAt CamExtremes::torque() const {
  return larger(whole(CamQuantity::torque));
}

ValueAt CamExtremes::stress() const {
  const auto convex = convex_radius(), concave = concave_radius();
  if (convex && convex->value <= 0) return {HUGE_VAL, convex->angle};
  const double roller = cam_.system.follower.dimensions.roller_radius;
  if (cam_.system.groove && concave && concave->value <= 2 * roller) {
    return {HUGE_VAL, concave->angle};
  }
  const auto& square = whole(CamQuantity::squared_stress).greatest;
  return {root(square), square.place.angle};
}

ValueAt CamExtremes::roller_speed() const {
  return larger(whole(CamQuantity::roller_speed));
}

ValueAt CamExtremes::motion(double cam::FollowerMotion<double>::*derivative) const {
  const auto all =
      turn_extremes(cam_.programme, MotionPart::whole,
                    [derivative](const cam::FollowerMotion<double>& m) { return m.*derivative; });
  return with_size(larger(*all));
}

}  // namespace cognate::problems
