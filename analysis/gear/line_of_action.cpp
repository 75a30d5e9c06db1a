#include "analysis/gear/line_of_action.hpp"

#include <algorithm>
#include <cmath>

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
  line.base_pitch = 2 * std::numbers::pi * base1 / pinion.teeth;
  line.pinion_tip = tangent_length(base1, flank_end_radius(pinion));
  line.wheel_tip = line.length - tangent_length(base2, flank_end_radius(wheel));
  line.pinion_form = form_tangent(pinion);
  line.wheel_form = line.length - form_tangent(wheel);
  line.start = std::max(line.wheel_tip, line.pinion_form);
  line.end = std::max(line.start, std::min(line.pinion_tip, line.wheel_form));
  return line;
}

}  // namespace cognate::gear
