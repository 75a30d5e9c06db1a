#include "problems/cam/extremes.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems {
namespace {

using cam::Quantity;
using cam::Stretch;
using cam::TurnExtremes;

FoundAt found(const cam::PlacedExtreme& extreme) {
  return {extreme.value, extreme.place.angle};
}

/// Of the two the one that is farther from 0, with its own sign.
FoundAt larger(const TurnExtremes& all) {
  return std::abs(all.least.value) > std::abs(all.greatest.value) ? found(all.least)
                                                                  : found(all.greatest);
}

FoundAt with_size(FoundAt signed_value) {
  return {std::abs(signed_value.value), signed_value.angle};
}

double root(const cam::PlacedExtreme& square) {
  return square.value < 0 ? 0 : std::sqrt(square.value);
}

}  // namespace

const TurnExtremes& CamExtremes::whole(Quantity quantity) const {
  auto& known = known_[static_cast<std::size_t>(quantity)];
  if (!known) {
    known = turn_extremes(cam_.programme, Stretch::whole, cam_.system, quantity)
                .value_or(TurnExtremes{});
  }
  return *known;
}

const std::array<std::optional<TurnExtremes>, 3>& CamExtremes::pressure_of_strokes() const {
  if (!pressure_) {
    const auto over = [&](Stretch stretch) {
      return turn_extremes(cam_.programme, stretch, cam_.system, Quantity::pressure_angle);
    };
    pressure_ = {over(Stretch::rises), over(Stretch::falls), over(Stretch::dwells)};
  }
  return *pressure_;
}

FoundAt CamExtremes::pressure_angle() const {
  FoundAt greatest;
  for (const auto& stroke : pressure_of_strokes()) {
    if (!stroke) continue;
    const FoundAt here = with_size(larger(*stroke));
    if (here.value > greatest.value) greatest = here;
  }
  return greatest;
}

std::optional<FoundAt> CamExtremes::pressure_angle(Stretch stretch) const {
  const auto& [rises, falls, dwells] = pressure_of_strokes();
  if (stretch == Stretch::rises && rises) return with_size(larger(*rises));
  if (stretch == Stretch::falls && falls) return with_size(larger(*falls));
  return std::nullopt;
}

std::optional<FoundAt> CamExtremes::working_pressure_angle(Stretch stretch) const {
  const auto& [rises, falls, dwells] = pressure_of_strokes();
  if (stretch == Stretch::rises && rises) return found(rises->greatest);
  if (stretch == Stretch::falls && falls) {
    return FoundAt{-falls->least.value, falls->least.place.angle};
  }
  return std::nullopt;
}

std::optional<FoundAt> CamExtremes::smooth_convex_radius() const {
  const auto& follower = cam_.system.follower;
  if (is_flat(follower.type)) return found(whole(Quantity::face_radius).least);
  const auto& sharpest = whole(Quantity::pitch_curvature).greatest;
  if (!(sharpest.value > 0)) return std::nullopt;
  return FoundAt{1 / sharpest.value - follower.dimensions.roller_radius, sharpest.place.angle};
}

std::optional<FoundAt> CamExtremes::convex_radius() const {
  const auto& follower = cam_.system.follower;
  auto least = smooth_convex_radius();
  for (const cam::Jump& corner : corners()) {
    if (corner.after > corner.before) continue;
    const double radius =
        is_flat(follower.type) ? corner.after - corner.before : -follower.dimensions.roller_radius;
    if (!least || radius < least->value) least = FoundAt{radius, corner.angle};
  }
  return least;
}

std::optional<FoundAt> CamExtremes::concave_radius() const {
  const auto& follower = cam_.system.follower;
  if (is_flat(follower.type)) return std::nullopt;
  const double roller = follower.dimensions.roller_radius;
  std::optional<FoundAt> least;
  const auto& hollowest = whole(Quantity::pitch_curvature).least;
  if (hollowest.value < 0) least = FoundAt{roller - 1 / hollowest.value, hollowest.place.angle};
  for (const cam::Jump& corner : corners()) {
    if (corner.after > corner.before && (!least || roller < least->value)) {
      least = FoundAt{roller, corner.angle};
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
  const auto all = turn_extremes(cam_.programme, Stretch::whole, along);
  return all ? all->least.value : 0;
}

double CamExtremes::least_profile_radius() const {
  return root(whole(Quantity::squared_radius).least);
}

double CamExtremes::greatest_profile_radius() const {
  return root(whole(Quantity::squared_radius).greatest);
}

double CamExtremes::face_width() const {
  const TurnExtremes& reach = whole(Quantity::reach);
  return reach.greatest.value - reach.least.value;
}

FoundAt CamExtremes::contact_force(bool both_ways) const {
  const TurnExtremes& all = whole(Quantity::contact_force);
  return both_ways ? larger(all) : found(all.greatest);
}

FoundAt CamExtremes::least_demand() const {
  return found(whole(Quantity::demand).least);
}

FoundAt CamExtremes::torque() const {
  return larger(whole(Quantity::torque));
}

FoundAt CamExtremes::stress() const {
  const auto convex = convex_radius(), concave = concave_radius();
  if (convex && convex->value <= 0) return {HUGE_VAL, convex->angle};
  const double roller = cam_.system.follower.dimensions.roller_radius;
  if (cam_.system.groove && concave && concave->value <= 2 * roller) {
    return {HUGE_VAL, concave->angle};
  }
  const auto& square = whole(Quantity::squared_stress).greatest;
  return {root(square), square.place.angle};
}

FoundAt CamExtremes::roller_speed() const {
  return larger(whole(Quantity::roller_speed));
}

FoundAt CamExtremes::motion(double cam::FollowerMotion<double>::*derivative) const {
  const auto all =
      turn_extremes(cam_.programme, Stretch::whole,
                    [derivative](const cam::FollowerMotion<double>& m) { return m.*derivative; });
  return with_size(larger(*all));
}

}  // namespace cognate::problems
