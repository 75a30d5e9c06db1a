#include "problems/cam/cam_extremes.hpp"

#include <cmath>
#include <limits>

namespace cognate::problems {
namespace {

using cam::Quantity;
using cam::Stretch;
using cam::TurnExtremes;

TurnExtremes extremes(const cam::Cam& cam, Quantity quantity) {
  return turn_extremes(cam.programme, Stretch::whole, cam.system, quantity)
      .value_or(TurnExtremes{});
}

FoundAt found(const cam::PlacedExtreme& extreme) {
  return {extreme.value, extreme.place.angle};
}

/// Of the two the one that is farther from 0, with its own sign.
FoundAt larger(const TurnExtremes& all) {
  return std::abs(all.least.value) > std::abs(all.greatest.value) ? found(all.least)
                                                                  : found(all.greatest);
}

FoundAt root(const cam::PlacedExtreme& square) {
  return {std::sqrt(std::max(0.0, square.value)), square.place.angle};
}

}  // namespace

FoundAt greatest_pressure_angle(const cam::Cam& cam) {
  FoundAt greatest = larger(extremes(cam, Quantity::pressure_angle));
  greatest.value = std::abs(greatest.value);
  return greatest;
}

std::optional<FoundAt> pressure_angle_of(const cam::Cam& cam, Stretch stretch) {
  const auto all = turn_extremes(cam.programme, stretch, cam.system, Quantity::pressure_angle);
  if (!all) return std::nullopt;
  if (stretch != Stretch::falls) return found(all->greatest);
  return FoundAt{-all->least.value, all->least.place.angle};
}

std::optional<FoundAt> least_convex_radius(const cam::Cam& cam) {
  if (is_flat(cam.system.follower.type)) return found(extremes(cam, Quantity::face_radius).least);
  const auto sharpest = extremes(cam, Quantity::pitch_curvature).greatest;
  if (!(sharpest.value > 0)) return std::nullopt;
  return FoundAt{1 / sharpest.value - cam.system.follower.dimensions.roller_radius,
                 sharpest.place.angle};
}

std::optional<FoundAt> least_concave_radius(const cam::Cam& cam) {
  if (is_flat(cam.system.follower.type)) return std::nullopt;
  const auto hollowest = extremes(cam, Quantity::pitch_curvature).least;
  if (!(hollowest.value < 0)) return std::nullopt;
  return FoundAt{cam.system.follower.dimensions.roller_radius - 1 / hollowest.value,
                 hollowest.place.angle};
}

FoundAt least_profile_radius(const cam::Cam& cam) {
  return root(extremes(cam, Quantity::squared_radius).least);
}

FoundAt greatest_profile_radius(const cam::Cam& cam) {
  return root(extremes(cam, Quantity::squared_radius).greatest);
}

double face_width(const cam::Cam& cam) {
  const auto reach = extremes(cam, Quantity::reach);
  return reach.greatest.value - reach.least.value;
}

FoundAt greatest_force(const cam::Cam& cam, bool both_ways) {
  const TurnExtremes all = extremes(cam, Quantity::contact_force);
  return both_ways ? larger(all) : found(all.greatest);
}

FoundAt least_demand(const cam::Cam& cam) {
  return found(extremes(cam, Quantity::demand).least);
}

FoundAt greatest_torque(const cam::Cam& cam) {
  return larger(extremes(cam, Quantity::torque));
}

FoundAt greatest_stress(const cam::Cam& cam) {
  return root(extremes(cam, Quantity::squared_stress).greatest);
}

FoundAt greatest_roller_speed(const cam::Cam& cam) {
  return larger(extremes(cam, Quantity::roller_speed));
}

}  // namespace cognate::problems
