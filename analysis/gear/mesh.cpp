#include "analysis/gear/mesh.hpp"

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::gear {

Mesh mesh(const SpurPair& pair) {
  const auto& [pinion, wheel] = pair.gears;
  const double a = pair.centre_distance;
  Mesh result;
  result.line = line_of_action(pair);
  const LineOfAction& line = result.line;
  const double cosine = std::cos(line.pressure_angle);
  const double sine = std::sin(line.pressure_angle);
  result.wheel_centre = {0, a};
  result.direction = {-cosine, sine};
  const Vec2d towards_line{sine, cosine};
  result.base_points = {base_radius(pinion) * towards_line,
                        result.wheel_centre - base_radius(wheel) * towards_line};
  const auto place = [&](double along) { return result.base_points[0] + along * result.direction; };
  result.pitch_point = place(line.pitch_point);
  result.path_start = place(line.start);
  result.path_end = place(line.end);

  // Without backlash a space of the wheel is opposite the pinion's tooth; with it the wheel lags.
  const double half_backlash = 0.5 * geometry_of_line(pair).backlash;
  const double working_radius = a * (wheel.teeth / (pinion.teeth + wheel.teeth));
  result.wheel_angle = kPi * (1 + 1 / wheel.teeth) + half_backlash / working_radius;

  // The involute that touches at u begins u/r_b1 ahead of T₁, which is at π/2 − α′.
  const double first = base_radius(pinion) * (base_half_angle(pinion) + line.pressure_angle);
  const double after_start = std::remainder(first - line.start, line.base_pitch);
  result.contact = line.start + (after_start < 0 ? after_start + line.base_pitch : after_start);
  return result;
}

}  // namespace cognate::gear
