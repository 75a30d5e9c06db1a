/// Centre distance, profile shifts and backlash: each from the others.
#include <cmath>

#include "analysis/gear/involute.hpp"
#include "problems/gear/gear_pair_design.hpp"

namespace cognate::problems {
namespace {

using gear::SpurGear;

/// More than enough: the steps of Newton's method double the digits.
constexpr int kSteps = 60;

double reference_distance(const std::array<SpurGear, 2>& gears) {
  return gear::reference_radius(gears[0]) + gear::reference_radius(gears[1]);
}

}  // namespace

double centre_distance_with(const std::array<SpurGear, 2>& gears, double backlash) {
  const double closed = gear::centre_distance_without_backlash(gears);
  if (backlash == 0) return closed;
  // j = 2 a′ (inv α′ − c), where c is the involute of the working angle without backlash and
  // a′ = A/cos α′: g(α′) = inv α′ − c − j cos α′/(2A) grows and curves upwards, so that Newton's
  // method from above its root goes down to it.
  const double share =
      backlash / (2 * reference_distance(gears) * std::cos(gears[0].rack.pressure_angle));
  const double bases = gear::base_radius(gears[0]) + gear::base_radius(gears[1]);
  const double sum = gears[0].profile_shift + gears[1].profile_shift;
  const double alpha = gears[0].rack.pressure_angle;
  const double c = std::isfinite(closed)
                       ? gear::involute(std::acos(std::min(1.0, bases / closed)))
                       : gear::involute(alpha) + 2 * sum * std::tan(alpha) /
                                                     (gears[0].teeth + gears[1].teeth);
  if (c + share < 0) return NAN;
  double angle = gear::involute_angle(c + share);
  for (int i = 0; i < kSteps; ++i) {
    const double tangent = std::tan(angle);
    const double slope = tangent * tangent + share * std::sin(angle);
    const double step = (gear::involute(angle) - c - share * std::cos(angle)) / slope;
    if (!(step > 0) || angle - step == angle) break;
    angle -= step;
  }
  return bases / std::cos(angle);
}

double shift_sum_with(const std::array<SpurGear, 2>& gears, double centre_distance,
                      double backlash) {
  const double scale = centre_distance / reference_distance(gears);
  const double alpha = gears[0].rack.pressure_angle;
  return gear::profile_shift_sum(gears, centre_distance) -
         backlash / (2 * scale * gears[0].module * std::tan(alpha));
}

std::optional<double> greatest_continuous_distance(const GearPairDesign& design) {
  const double module = *design.settled.module;
  gear::SpurPair pair = design.pair;
  const auto ratio = [&](double distance) {
    pair.centre_distance = distance;
    return total_contact_ratio(design.settled, module, gear::geometry(pair));
  };
  double low = gear::centre_distance_without_backlash(pair.gears);
  double high = design.pair.centre_distance;
  if (!(low < high) || !(ratio(low) >= 1)) return std::nullopt;
  while (true) {  // the contact ratio falls as the distance grows
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return low;
    (ratio(middle) >= 1 ? low : high) = middle;
  }
}

}  // namespace cognate::problems
