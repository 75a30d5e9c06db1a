#include "analysis/gear/fillet.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/gear/involute.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::gear {
namespace {

/// The zero of `f` between `low` and `high`; the end at which |f| is less if its sign is the same.
template <class Function>
double zero_between(const Function& f, double low, double high) {
  const double at_low = f(low);
  const double at_high = f(high);
  if (at_low * at_high < 0) return better_end(f, bracket_zero(f, low, at_low, high, at_high));
  return std::abs(at_low) <= std::abs(at_high) ? low : high;
}

/// Where the fillet of an undercut gear cuts the involute. At the pressure angle the fillet starts
/// on the other branch of the involute, in the space; where it meets the base circle it is in the
/// tooth.
double undercut_end(const SpurGear& gear, const Fillet& fillet) {
  const double base = fillet.pitch_radius * std::cos(gear.rack.pressure_angle);
  const auto above_base = [&](double theta) { return fillet.radius(theta) - base; };
  const double at_base = zero_between(above_base, gear.rack.pressure_angle, kRightAngle);
  const double base_angle = kPi / gear.teeth - base_half_angle(gear);
  const auto into_tooth = [&](double theta) {
    const double cosine = std::min(base / fillet.radius(theta), 1.0);
    return fillet.angle(theta) - base_angle - involute(std::acos(cosine));
  };
  return zero_between(into_tooth, gear.rack.pressure_angle, at_base);
}

}  // namespace

double Fillet::roll_angle(double theta) const {
  return -(centre.y / std::tan(theta) + centre.x) / pitch_radius;
}

double Fillet::radius(double theta) const {
  const double sine = std::sin(theta);
  const double from_pitch_point = corner_radius - centre.y / sine;
  return std::hypot(from_pitch_point * std::cos(theta), pitch_radius - from_pitch_point * sine);
}

double Fillet::angle(double theta) const {
  const double sine = std::sin(theta);
  const double from_pitch_point = corner_radius - centre.y / sine;
  return std::atan2(from_pitch_point * std::cos(theta), pitch_radius - from_pitch_point * sine) -
         roll_angle(theta);
}

Fillet fillet_of(const SpurGear& gear) {
  const BasicRack& rack = gear.rack;
  Fillet fillet;
  fillet.pitch_radius = 0.5 * gear.teeth;
  fillet.corner_radius = tip_radius(rack);
  fillet.centre = {tip_half_width(rack) + 0.5 * gear.coarsening / gear.module,
                   gear.profile_shift - rack.addendum - rack.clearance + fillet.corner_radius};
  fillet.end = is_undercut(gear) ? undercut_end(gear, fillet) : rack.pressure_angle;
  return fillet;
}

double form_radius(const SpurGear& gear) {
  if (!is_undercut(gear)) return std::hypot(base_radius(gear), form_tangent(gear));
  const Fillet fillet = fillet_of(gear);
  return gear.module * fillet.radius(fillet.end);
}

double form_tangent(const SpurGear& gear) {
  if (is_undercut(gear)) {
    const double base = base_radius(gear), form = form_radius(gear);
    return std::sqrt(std::max(form - base, 0.0) * (form + base));
  }
  const double sine = std::sin(gear.rack.pressure_angle);
  const double length =
      0.5 * gear.teeth * sine - (flank_depth(gear.rack) - gear.profile_shift) / sine;
  return gear.module * std::max(length, 0.0);
}

double waist_thickness(const SpurGear& gear) {
  const Fillet fillet = fillet_of(gear);
  const double half_pitch = kPi / gear.teeth;
  // The tangent leans outwards by this angle against the tooth's middle line.
  const auto lean = [&](double theta) { return theta - half_pitch - fillet.roll_angle(theta); };
  double narrowest = fillet.end;
  if (lean(narrowest) < 0) narrowest = zero_between(lean, narrowest, kRightAngle);
  const double half_angle = half_pitch - fillet.angle(narrowest);
  return 2 * gear.module * fillet.radius(narrowest) * std::sin(half_angle);
}

}  // namespace cognate::gear
