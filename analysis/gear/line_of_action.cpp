#include "analysis/gear/line_of_action.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

/// The length of the tangent to the base circle that ends at `radius`.
double tangent_length(double base, double radius) {
  return std::sqrt((radius - base) * (radius + base));
}

}  // namespace

LineOfAction line_of_action(const SpurPair& pair) {
  const auto& [pinion, wheel] = pair.gears;
  const double base1 = base_radius(pinion);
  const double base2 = base_radius(wheel);
  LineOfAction line;
  line.length = tangent_length(base1 + base2, pair.centre_distance);
  line.pressure_angle = std::atan2(line.length, base1 + base2);
  line.pitch_point = line.length * (base1 / (base1 + base2));
  line.base_pitch = kTurn * base1 / pinion.teeth;
  line.pinion_tip = tangent_length(base1, flank_end_radius(pinion));
  line.wheel_tip = line.length - tangent_length(base2, flank_end_radius(wheel));
  line.pinion_form = form_tangent(pinion);
  line.wheel_form = line.length - form_tangent(wheel);
  line.start = std::max(line.wheel_tip, line.pinion_form);
  line.end = std::max(line.start, std::min(line.pinion_tip, line.wheel_form));
  return line;
}

std::optional<DistanceRange> distances_in_contact(const std::array<SpurGear, 2>& gears,
                                                  double ratio) {
  const double path = ratio * kTurn * base_radius(gears[0]) / gears[0].teeth;
  double tips = 0, forms = 0;
  for (const SpurGear& gear : gears) {
    const double tip = tangent_length(base_radius(gear), flank_end_radius(gear));
    const double form = form_tangent(gear);
    if (!(tip - form >= path)) return std::nullopt;
    tips += tip;
    forms += form;
  }
  const double base = sum_of_base_radii(gears);
  // Teeth that are so thin that they never touch do not overlap anywhere.
  const double without = centre_distance_without_backlash(gears);
  const double least = std::max(std::hypot(forms + path, base), std::isnan(without) ? 0 : without);
  const double greatest = std::hypot(tips - path, base);
  return least <= greatest ? std::optional(DistanceRange{least, greatest}) : std::nullopt;
}

double specific_sliding(double own, double other, double module) {
  constexpr double kNothing = 1e-6;
  if (std::abs(own) <= kNothing * module) return -kInfinity;
  return 1 - other / own;
}

}  // namespace cognate::gear
