#include "analysis/gear/tip_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/gear/fillet.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

/// The corner of a tip seen from the gear whose space it passes. ψ is its angle from the line of
/// centres, to the side to which it moves; β that about the other centre.
struct TipPath {
  double centre_distance = 0;
  double tip_radius = 0;
  double ratio = 0;       ///< by how much the gear turns when the tip does by 1
  double at_contact = 0;  ///< ψ where it touches the involute
  double gear_angle = 0;  ///< of the gear then: of its tooth's middle, to the same side

  /// The angle at the gear's centre from its tooth's middle to the tip at ψ.
  double from_tooth(double psi) const {
    const double sine = std::sin(0.5 * psi);
    const double beta = std::atan2(tip_radius * std::sin(psi),
                                   centre_distance - tip_radius + 2 * tip_radius * sine * sine);
    return beta - gear_angle - ratio * (psi - at_contact);
  }

  /// |ψ| where the tip is at `radius` from the gear's centre, by half of it so that large gears
  /// lose no digits; not a number if it never is.
  double psi_at(double radius) const {
    const double nearest = centre_distance - tip_radius;
    return 2 * std::asin(std::sqrt((radius - nearest) * (radius + nearest) /
                                   (4 * centre_distance * tip_radius)));
  }
};

TipPath tip_path(const SpurPair& pair, const LineOfAction& line, std::size_t own) {
  const SpurGear& gear = pair.gears[own];
  const SpurGear& other = pair.gears[1 - own];
  const double tip = flank_end_radius(other);
  const double contact = own == 0 ? line.wheel_tip : line.length - line.pinion_tip;
  return {pair.centre_distance, tip, other.teeth / gear.teeth,
          line.pressure_angle - pressure_angle(other, tip),
          contact / base_radius(gear) - base_half_angle(gear) - line.pressure_angle};
}

}  // namespace

double tip_room(const SpurPair& pair, const LineOfAction& line, int own) {
  constexpr int kSteps = 24;  // crowded towards the form circle, where room is least
  const SpurGear& gear = pair.gears[static_cast<std::size_t>(own)];
  const TipPath path = tip_path(pair, line, static_cast<std::size_t>(own));
  const Fillet fillet = fillet_of(gear);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i * i) / (kSteps * kSteps);
    const double theta = fillet.end + (kRightAngle - fillet.end) * share;
    const double radius = gear.module * fillet.radius(theta);
    const double psi = path.psi_at(radius);
    if (std::isnan(psi)) break;  // the tip does not come as deep
    const double flank = kPi / gear.teeth - fillet.angle(theta);
    const double nearer = std::min(path.from_tooth(psi), path.from_tooth(-psi));
    least = std::min(least, radius * (nearer - flank));
  }
  return least;
}

}  // namespace cognate::gear
