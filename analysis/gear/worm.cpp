#include <cmath>

#include "analysis/gear/other_gears.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

double lead_angle(const WormPair& pair) {
  return std::atan(pair.starts / pair.diameter_quotient);
}

double normal_pressure_angle(const WormPair& pair) {
  return std::atan(std::tan(pair.rack.pressure_angle) * std::cos(lead_angle(pair)));
}

/// ρ′ of friction between flanks inclined by the normal pressure angle.
double friction_angle(const WormPair& pair, double friction) {
  return std::atan(friction / std::cos(normal_pressure_angle(pair)));
}

}  // namespace

WormGeometry geometry(const WormPair& pair) {
  const double m = pair.module;
  const double addendum = pair.rack.addendum;
  const double dedendum = pair.rack.addendum + pair.rack.clearance;
  const double q = pair.diameter_quotient;
  const double z = pair.wheel_teeth;
  const double x = pair.wheel_shift;
  WormGeometry result;
  result.lead_angle = lead_angle(pair);
  result.lead = kPi * m * pair.starts;
  result.centre_distance = 0.5 * m * (q + z + 2 * x);
  result.worm_reference_diameter = m * q;
  result.worm_tip_diameter = m * (q + 2 * addendum);
  result.worm_root_diameter = m * (q - 2 * dedendum);
  result.wheel_reference_diameter = m * z;
  result.wheel_throat_diameter = m * (z + 2 * (addendum + x));
  result.wheel_root_diameter = m * (z - 2 * (dedendum - x));
  result.sliding_speed_ratio = 1 / std::cos(result.lead_angle);
  result.normal_pressure_angle = normal_pressure_angle(pair);
  return result;
}

double efficiency(const WormPair& pair, double friction) {
  const double angle = lead_angle(pair);
  const double with_friction = angle + friction_angle(pair, friction);
  return with_friction < kRightAngle ? std::tan(angle) / std::tan(with_friction) : 0;
}

bool locks_itself(const WormPair& pair, double friction) {
  return lead_angle(pair) <= friction_angle(pair, friction);
}

}  // namespace cognate::gear
