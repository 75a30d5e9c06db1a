#include <cmath>

#include "analysis/gear/other_gears.hpp"

namespace cognate::gear {
namespace {

double cone_angle(const BevelPair& pair, int index) {
  const double ratio = pair.teeth[1] / pair.teeth[0];
  const double first = std::atan2(std::sin(pair.shaft_angle), ratio + std::cos(pair.shaft_angle));
  return index == 0 ? first : pair.shaft_angle - first;
}

}  // namespace

BevelGear bevel_gear(const BevelPair& pair, int index) {
  const auto i = static_cast<std::size_t>(index);
  const double m = pair.module;
  const double diameter = m * pair.teeth[i];
  const double addendum = m * (pair.rack.addendum + pair.profile_shift[i]);
  const double dedendum = m * (pair.rack.addendum + pair.rack.clearance - pair.profile_shift[i]);
  BevelGear gear;
  gear.cone_angle = cone_angle(pair, index);
  const double cosine = std::cos(gear.cone_angle);
  gear.cone_distance = 0.5 * diameter / std::sin(gear.cone_angle);
  gear.tip_angle = gear.cone_angle + std::atan(addendum / gear.cone_distance);
  gear.root_angle = gear.cone_angle - std::atan(dedendum / gear.cone_distance);
  gear.outer_tip_diameter = diameter + 2 * addendum * cosine;
  gear.outer_root_diameter = diameter - 2 * dedendum * cosine;
  gear.mean_module = m * (1 - 0.5 * pair.face_width / gear.cone_distance);
  gear.virtual_gear = {.teeth = pair.teeth[i] / cosine,
                       .module = m,
                       .profile_shift = pair.profile_shift[i],
                       .rack = pair.rack};
  return gear;
}

SpurPair virtual_pair(const BevelPair& pair) {
  SpurPair result{{bevel_gear(pair, 0).virtual_gear, bevel_gear(pair, 1).virtual_gear}};
  result.centre_distance = centre_distance_without_backlash(result.gears);
  return result;
}

}  // namespace cognate::gear
