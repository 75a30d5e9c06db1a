#include "problems/gear/quantities.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/gear/involute.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::problems {
namespace {

using gear::HelicalGear;
using gear::SpurGear;

/// Pins of this diameter, in modules, touch near the reference circle (DIN 3960).
constexpr double kPinDiameter = 1.728;

bool is_odd(double teeth) {
  return std::fmod(teeth, 2) == 1;
}

/// Whether the flank at the end of this tangent to the base circle is involute.
bool is_involute(const SpurGear& section, double tangent) {
  const double radius = std::hypot(gear::base_radius(section), tangent);
  return tangent > 0 && gear::tooth_fault(section) == gear::ToothFault::none &&
         tangent >= gear::form_tangent(section) && radius <= gear::flank_end_radius(section);
}

/// s_n, the arc on the reference circle across the teeth.
double normal_thickness(const HelicalGear& gear) {
  const SpurGear section = gear::transverse(gear);
  return gear::tooth_thickness(section, gear::reference_radius(section)) * std::cos(gear.helix);
}

double addendum(const HelicalGear& gear) {
  const SpurGear section = gear::transverse(gear);
  return gear::tip_radius(section) - gear::reference_radius(section);
}

/// Of the circle of the centres of pins of `diameter`; not a number where they fall through.
double pin_radius(const HelicalGear& gear, double diameter) {
  const SpurGear& normal = gear.normal;
  const SpurGear section = gear::transverse(gear);
  const double alpha = normal.rack.pressure_angle, z = normal.teeth;
  const double space =
      0.5 * kPi - 2 * normal.profile_shift * std::tan(alpha) + normal.coarsening / normal.module;
  const double inv = gear::involute(section.rack.pressure_angle) +
                     diameter / (normal.module * z * std::cos(alpha)) - space / z;
  return inv > 0 ? gear::base_radius(section) / std::cos(gear::involute_angle(inv)) : NAN;
}

class Quantities {
 public:
  Quantities(const HelicalGear& gear, std::string prefix, std::optional<int> span_teeth)
      : gear_(gear),
        section_(gear::transverse(gear)),
        prefix_(std::move(prefix)),
        span_teeth_(span_teeth) {}

  std::vector<Quantity> all() && {
    add_diameters();
    add_thicknesses();
    add_chords();
    add_limits();
    if (gear_.helix != 0) add_helix();
    add_measurements();
    return std::move(quantities_);
  }

 private:
  template <class Value>
  void add(const char* name, Value value) {
    quantities_.push_back({prefix_ + name, value});
  }

  void add_diameters() {
    add("profile_shift", gear_.normal.profile_shift);
    add("reference_diameter", 2 * gear::reference_radius(section_));
    add("base_diameter", 2 * gear::base_radius(section_));
    add("tip_diameter", 2 * gear::tip_radius(section_));
    add("root_diameter", 2 * gear::root_radius(section_));
    if (gear::tooth_fault(section_) == gear::ToothFault::none) {
      add("form_diameter", 2 * gear::form_radius(section_));
    }
  }

  void add_thicknesses() {
    const double reference = gear::reference_radius(section_), tip = gear::tip_radius(section_);
    const double base = gear::base_radius(section_), root = gear::root_radius(section_);
    const double thickness = gear::tooth_thickness(section_, reference);
    const double pitch = 2 * kPi * reference / section_.teeth;
    add("addendum", tip - reference);
    add("dedendum", reference - root);
    add("tooth_depth", tip - root);
    add("pitch", pitch);
    add("base_pitch", 2 * kPi * base / section_.teeth);
    add("tooth_thickness", thickness);
    add("space_width", pitch - thickness);
    add("base_thickness", gear::tooth_thickness(section_, base));
    if (tip >= gear::base_radius(section_)) {
      add("tip_thickness", gear::tooth_thickness(section_, tip));
    }
    add("pointed_diameter", 2 * gear::pointed_radius(section_));
  }

  void add_chords() {
    const Chord chord = reference_chord(gear_), constant = constant_chord(gear_);
    if (!(chord.thickness > 0)) return;
    add("chordal_thickness", chord.thickness);
    add("chordal_addendum", chord.addendum);
    add("constant_chord", constant.thickness);
    add("constant_chord_addendum", constant.addendum);
  }

  void add_limits() {
    const double normal = std::cos(gear_.helix);  // of a transverse module over a normal one
    add("undercut", gear::is_undercut(section_));
    add("least_teeth", gear::least_teeth(section_.rack, section_.profile_shift));
    add("least_profile_shift", gear::least_profile_shift(section_.rack, section_.teeth) / normal);
  }

  void add_helix() {
    add("virtual_teeth", gear::virtual_teeth(gear_));
    add("base_helix_deg", degrees(gear::base_helix(gear_)));
    add("lead", gear::lead(gear_));
    add("normal_tooth_thickness", normal_thickness(gear_));
    const double tip = gear::tip_radius(section_);
    if (tip < gear::base_radius(section_)) return;
    add("normal_tip_thickness",
        gear::tooth_thickness(section_, tip) * gear::helix_cosine(section_, gear_.helix, tip));
  }

  void add_measurements() {
    const auto span = span_teeth_ ? span_over(gear_, *span_teeth_) : span_measurement(gear_);
    if (span) {
      add("span_teeth", double(span->teeth));
      add("span_measurement", span->length);
    }
    const double pin = kPinDiameter * gear_.normal.module;
    if (!pins_can_be_measured(gear_, pin)) return;
    add("pin_diameter", pin);
    add("measurement_over_pins", measurement_over_pins(gear_, pin));
  }

  const HelicalGear& gear_;
  SpurGear section_;
  std::string prefix_;
  std::optional<int> span_teeth_;
  std::vector<Quantity> quantities_;
};

}  // namespace

std::vector<Quantity> gear_quantities(const HelicalGear& gear, const std::string& prefix,
                                      std::optional<int> span_teeth) {
  return Quantities(gear, prefix, span_teeth).all();
}

Chord reference_chord(const HelicalGear& gear) {
  const double cosine = std::cos(gear.helix);
  const double diameter = 2 * gear::reference_radius(gear::transverse(gear)) / (cosine * cosine);
  const double half = normal_thickness(gear) / diameter;
  const double sine = std::sin(0.5 * half);
  return {diameter * std::sin(half), addendum(gear) + diameter * sine * sine};
}

Chord constant_chord(const HelicalGear& gear) {
  const double alpha = gear.normal.rack.pressure_angle, thickness = normal_thickness(gear);
  const double cosine = std::cos(alpha);
  return {thickness * cosine * cosine, addendum(gear) - 0.5 * thickness * std::sin(alpha) * cosine};
}

std::optional<SpanMeasurement> span_over(const HelicalGear& gear, int teeth) {
  const SpurGear& normal = gear.normal;
  const SpurGear section = gear::transverse(gear);
  const double alpha = normal.rack.pressure_angle, z = normal.teeth;
  if (teeth < 1 || teeth >= z) return std::nullopt;
  const double inv = gear::involute(section.rack.pressure_angle);
  const double thicker = 2 * normal.profile_shift * std::tan(alpha);
  const double base_helix = gear::base_helix(gear);
  const double length =
      normal.module * std::cos(alpha) * (kPi * (teeth - 0.5) + z * inv + thicker) -
      normal.coarsening * std::cos(alpha);
  const bool has_width =
      gear.face_width == 0 || gear.face_width > length * std::abs(std::sin(base_helix));
  if (!has_width || !is_involute(section, 0.5 * length * std::cos(base_helix))) return std::nullopt;
  return {{teeth, length}};
}

std::optional<SpanMeasurement> span_measurement(const HelicalGear& gear) {
  const SpurGear section = gear::transverse(gear);
  const double z = gear.normal.teeth, x = gear.normal.profile_shift;
  const double thicker = 2 * x * std::tan(gear.normal.rack.pressure_angle);
  const double base = gear::base_radius(section);
  // The anvils are to touch at the reference radius and the shift above it.
  const double touched = std::max(gear::reference_radius(section) + x * gear.normal.module, base);
  const double roll = std::sqrt((touched - base) * (touched + base)) / base;
  const double inv = gear::involute(section.rack.pressure_angle);
  const double cosine = std::cos(gear::base_helix(gear));
  const double count = (z * (roll / (cosine * cosine) - inv) - thicker) / kPi + 0.5;
  const int middle = static_cast<int>(std::clamp(std::round(count), 1.0, std::max(1.0, z - 1)));
  for (const int teeth : {middle, middle + 1, middle - 1}) {
    const auto span = span_over(gear, teeth);
    if (span) return span;
  }
  return std::nullopt;
}

std::optional<std::array<int, 2>> span_range(const HelicalGear& gear) {
  std::optional<std::array<int, 2>> range;
  for (int teeth = 1; teeth < gear.normal.teeth; ++teeth) {
    if (!span_over(gear, teeth)) continue;
    if (!range) range = {teeth, teeth};
    (*range)[1] = teeth;
  }
  return range;
}

double measurement_over_pins(const HelicalGear& gear, double diameter) {
  const double across = 2 * pin_radius(gear, diameter);
  const double z = gear.normal.teeth;
  return across * (is_odd(z) ? std::cos(kPi / (2 * z)) : 1) + diameter;
}

bool pins_can_be_measured(const HelicalGear& gear, double diameter) {
  const SpurGear section = gear::transverse(gear);
  const double base = gear::base_radius(section), centre = pin_radius(gear, diameter);
  if (!(centre > base)) return false;
  const double tangent = std::sqrt((centre - base) * (centre + base));
  const double to_flank = 0.5 * diameter * std::cos(gear::base_helix(gear));
  if (!is_involute(section, tangent - to_flank)) return false;
  if (centre - 0.5 * diameter < gear::root_radius(section)) return false;
  // Along the line from pin to pin, or for an odd number of teeth beside it.
  const double z = section.teeth, tip = gear::flank_end_radius(section);
  const double anvil = centre * (is_odd(z) ? std::cos(kPi / (2 * z)) : 1) + 0.5 * diameter;
  const double half_tip = std::max(0.0, 0.5 * gear::tooth_thickness(section, tip) / tip);
  const double aside = std::max(0.0, (is_odd(z) ? 0.5 : 1) * kPi / z - half_tip);
  return anvil > tip * std::cos(aside);
}

}  // namespace cognate::problems
