#include "analysis/gear/rack_pair.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/gear/line_of_action.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

double tip_height(const RackPair& pair) {
  return (pair.pinion.rack.addendum - pair.tip_reduction) * pair.pinion.module;
}

double root_depth(const RackPair& pair) {
  return (pair.pinion.rack.addendum + pair.pinion.rack.clearance) * pair.pinion.module;
}

double passing_of(double length, double module) {
  return length > 1e-9 * module ? length : 0;
}

}  // namespace

double rack_distance(const SpurGear& pinion, double backlash) {
  return reference_radius(pinion) + pinion.profile_shift * pinion.module +
         0.5 * backlash / std::tan(pinion.rack.pressure_angle);
}

PairGeometry geometry(const RackPair& pair) {
  const SpurGear& pinion = pair.pinion;
  const double alpha = pinion.rack.pressure_angle, module = pinion.module;
  const double sine = std::sin(alpha), reference = reference_radius(pinion);
  const double base = base_radius(pinion), tip = flank_end_radius(pinion);
  const double beyond = pair.distance - reference;  // of the reference line from the pitch line
  const double pitch_point = reference * sine;      // from the base circle's tangent point
  const double rack_tip = pitch_point - (tip_height(pair) - beyond) / sine;
  const double rack_form = pitch_point + (flank_depth(pinion.rack) * module + beyond) / sine;
  const double pinion_tip = std::sqrt((tip - base) * (tip + base));
  const double pinion_form = form_tangent(pinion);
  const double start = std::max(rack_tip, pinion_form);
  const double end = std::max(start, std::min(pinion_tip, rack_form));
  PairGeometry mesh;
  mesh.working_pressure_angle = alpha;
  mesh.path_length = end - start;
  mesh.contact_ratio = mesh.path_length / (kPi * module * std::cos(alpha));
  mesh.approach = pitch_point - start;
  mesh.recess = end - pitch_point;
  const double slack = pair.distance - rack_distance(pinion, 0);
  mesh.backlash = std::abs(slack) <= 4e-15 * pair.distance ? 0 : 2 * slack * std::tan(alpha);
  mesh.normal_backlash = mesh.backlash * std::cos(alpha);
  mesh.greatest_sliding_speed =
      std::max(std::abs(mesh.approach), std::abs(mesh.recess)) / reference;
  GearInMesh& own = mesh.gears[0];
  own.working_radius = reference;
  own.contact_start = std::hypot(base, start);
  own.contact_end = std::hypot(base, end);
  own.interference = passing_of((is_undercut(pinion) ? 0 : pinion_form) - rack_tip, module);
  own.tip_clearance = pair.distance + root_depth(pair) - tip;
  own.sliding_start = specific_sliding(start, pitch_point, module);
  own.sliding_end = specific_sliding(end, pitch_point, module);
  GearInMesh& rack = mesh.gears[1];
  rack.working_radius = rack.contact_start = rack.contact_end = kInfinity;
  rack.interference = passing_of(pinion_tip - rack_form, module);
  rack.tip_clearance = pair.distance - tip_height(pair) - root_radius(pinion);
  rack.sliding_start = 1 - end / pitch_point;
  rack.sliding_end = 1 - start / pitch_point;
  return mesh;
}

std::vector<Vec2d> rack_tooth(const RackPair& pair) {
  const double module = pair.pinion.module, slope = std::tan(pair.pinion.rack.pressure_angle);
  const double quarter = kPi / 4 * module, tip = tip_height(pair), root = root_depth(pair);
  const double half_tip = std::max(0.0, quarter - tip * slope);
  const double half_root = std::min(2 * quarter, quarter + root * slope);
  return {{-2 * quarter, root}, {-half_root, root}, {-half_tip, -tip},
          {half_tip, -tip},     {half_root, root},  {2 * quarter, root}};
}

}  // namespace cognate::gear
