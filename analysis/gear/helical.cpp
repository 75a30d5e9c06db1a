#include <cmath>

#include "analysis/gear/other_gears.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {

SpurGear transverse(const HelicalGear& gear) {
  const double cosine = std::cos(gear.helix);
  SpurGear section = gear.normal;
  section.module /= cosine;
  section.rack.pressure_angle = std::atan(std::tan(gear.normal.rack.pressure_angle) / cosine);
  section.rack.addendum *= cosine;
  section.rack.clearance *= cosine;
  if (flank_depth(gear.normal.rack) != gear.normal.rack.addendum) {  // a corner as deep
    const double sine = std::sin(gear.normal.rack.pressure_angle);
    const double transverse_sine = std::sin(section.rack.pressure_angle);
    section.rack.corner_radius =
        tip_radius(gear.normal.rack) * cosine * (1 - sine) / (1 - transverse_sine);
  }
  section.profile_shift *= cosine;
  section.tip_reduction *= cosine;
  section.coarsening /= cosine;
  return section;
}

double virtual_teeth(const HelicalGear& gear) {
  const double cosine = std::cos(gear.helix);
  return gear.normal.teeth / (cosine * cosine * cosine);
}

double overlap_ratio(const HelicalGear& gear) {
  return gear.face_width * std::sin(std::abs(gear.helix)) / (kPi * gear.normal.module);
}

double base_helix(const HelicalGear& gear) {
  return std::asin(std::sin(gear.helix) * std::cos(gear.normal.rack.pressure_angle));
}

double lead(const HelicalGear& gear) {
  return kPi * gear.normal.module * gear.normal.teeth / std::sin(std::abs(gear.helix));
}

double helix_cosine(const SpurGear& section, double helix, double radius) {
  return 1 / std::hypot(1.0, std::tan(helix) * radius / reference_radius(section));
}

}  // namespace cognate::gear
