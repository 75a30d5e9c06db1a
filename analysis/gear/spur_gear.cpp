#include "analysis/gear/spur_gear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/gear/involute.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

double squared_sine(const BasicRack& rack) {
  const double sine = std::sin(rack.pressure_angle);
  return sine * sine;
}

/// The corner of a rack's tip.
struct Corner {
  double sine = 0, cosine = 1;  ///< of the pressure angle
  double greatest = 0;
  double radius = 0;
  bool is_usual = false;  ///< begins where the addendum ends
};

Corner corner_of(const BasicRack& rack) {
  Corner corner;
  corner.sine = std::sin(rack.pressure_angle);
  corner.cosine = std::cos(rack.pressure_angle);
  const double depth = rack.addendum + rack.clearance;
  corner.greatest = (kPi / 4 * corner.cosine - depth * corner.sine) / (1 - corner.sine);
  const double usual = rack.clearance / (1 - corner.sine);
  const bool has_room = usual <= corner.greatest || corner.greatest < 0;
  corner.is_usual = !rack.corner_radius && has_room;
  corner.radius = rack.corner_radius.value_or(has_room ? usual : corner.greatest);
  return corner;
}

}  // namespace

double tip_radius(const BasicRack& rack) {
  return corner_of(rack).radius;
}

double greatest_tip_radius(const BasicRack& rack) {
  return corner_of(rack).greatest;
}

double flank_depth(const BasicRack& rack) {
  const Corner corner = corner_of(rack);
  if (corner.is_usual) return rack.addendum;
  return rack.addendum + rack.clearance - corner.radius * (1 - corner.sine);
}

double tip_half_width(const BasicRack& rack) {
  const Corner corner = corner_of(rack);
  return (corner.greatest - corner.radius) * (1 - corner.sine) / corner.cosine;
}

double reference_radius(const SpurGear& gear) {
  return 0.5 * gear.module * gear.teeth;
}

double base_radius(const SpurGear& gear) {
  return reference_radius(gear) * std::cos(gear.rack.pressure_angle);
}

double tip_radius(const SpurGear& gear) {
  return gear.module *
         (0.5 * gear.teeth + gear.rack.addendum + gear.profile_shift - gear.tip_reduction);
}

double root_radius(const SpurGear& gear) {
  return gear.module *
         (0.5 * gear.teeth - gear.rack.addendum - gear.rack.clearance + gear.profile_shift);
}

bool is_undercut(const SpurGear& gear) {
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  const double depth = flank_depth(gear.rack);
  const double room = 0.5 * gear.teeth * squared_sine(gear.rack);
  return depth - gear.profile_shift - room > kRounding * (depth + std::abs(gear.profile_shift));
}

double least_teeth(const BasicRack& rack, double profile_shift) {
  return 2 * (flank_depth(rack) - profile_shift) / squared_sine(rack);
}

double least_profile_shift(const BasicRack& rack, double teeth) {
  return flank_depth(rack) - 0.5 * teeth * squared_sine(rack);
}

double pressure_angle(const SpurGear& gear, double radius) {
  const double base = base_radius(gear);
  return std::atan2(std::sqrt((radius - base) * (radius + base)), base);
}

double base_half_angle(const SpurGear& gear) {
  const double half_thickness = kRightAngle +
                                2 * gear.profile_shift * std::tan(gear.rack.pressure_angle) -
                                gear.coarsening / gear.module;
  return half_thickness / gear.teeth + involute(gear.rack.pressure_angle);
}

double tooth_thickness(const SpurGear& gear, double radius) {
  return 2 * radius * (base_half_angle(gear) - involute(pressure_angle(gear, radius)));
}

double pointed_radius(const SpurGear& gear) {
  const double at_point = std::max(base_half_angle(gear), 0.0);
  return base_radius(gear) * std::hypot(1.0, at_point + involute_angle(at_point));
}

double flank_end_radius(const SpurGear& gear) {
  return std::min(tip_radius(gear), pointed_radius(gear));
}

ToothFault tooth_fault(const SpurGear& gear) {
  // Negated, so that what is not a number is a fault too.
  const double half_width = tip_half_width(gear.rack) + 0.5 * gear.coarsening / gear.module;
  if (!(half_width >= 0)) return ToothFault::rack_overlaps;
  if (!(root_radius(gear) > 0)) return ToothFault::no_root;
  if (!(form_radius(gear) < flank_end_radius(gear))) return ToothFault::no_flank;
  return waist_thickness(gear) > 0 ? ToothFault::none : ToothFault::cut_through;
}

}  // namespace cognate::gear
