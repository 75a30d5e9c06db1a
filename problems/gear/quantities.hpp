/// @file What a gear is like by itself, in numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/gear/other_gears.hpp"
#include "problems/basics/quantity.hpp"

namespace cognate::problems {

/// Diameters, tooth thicknesses (arcs of the transverse section), limits of teeth and shift, and
/// what a workshop measures, the span over `span_teeth` teeth where they are given; each name after
/// `prefix`, "pinion.".
std::vector<Quantity> gear_quantities(const gear::HelicalGear& gear, const std::string& prefix,
                                      std::optional<int> span_teeth = {});

/// A chord across a tooth, in the normal section, and how far it lies below the tip.
struct Chord {
  double thickness = 0;
  double addendum = 0;
};

/// The chord of the arc s_n on the reference circle: d_n sin(s_n/d_n) at h_a + ½ d_n (1 −
/// cos(s_n/d_n)), where d_n = d/cos²β (of helical gears the circle that osculates the normal
/// section).
Chord reference_chord(const gear::HelicalGear& gear);

/// The chord between the points in which the reference rack touches both flanks of the tooth in its
/// space: s_n cos²α_n at h_a − ½ s_n sin α_n cos α_n, the same for every number of teeth.
Chord constant_chord(const gear::HelicalGear& gear);

/// The span over `teeth` teeth, W_k = m_n cos α_n (π (k − ½) + z inv α_t + 2 x tan α_n): ISO 21771,
/// and how many teeth so that the anvils touch the middle of the flanks, or one more or less if
/// only then they touch the involute. Empty where they do not, or where the gear is given a face
/// width too narrow for both anvils to reach it, W sin β_b.
struct SpanMeasurement {
  int teeth = 0;
  double length = 0;
};
std::optional<SpanMeasurement> span_measurement(const gear::HelicalGear& gear);

/// The same over so many teeth; empty where it cannot be taken.
std::optional<SpanMeasurement> span_over(const gear::HelicalGear& gear, int teeth);

/// The least and the greatest number of teeth over which a span can be taken.
std::optional<std::array<int, 2>> span_range(const gear::HelicalGear& gear);

/// The distance over two pins (balls of helical gears) of `diameter` in opposite tooth spaces:
/// inv α_K = inv α_t + D/(m_n z cos α_n) − (π/2 − 2 x tan α_n)/z, M = d_b/cos α_K + D, of odd teeth
/// the first part times cos(π/2z). Not a number where such a pin falls through.
double measurement_over_pins(const gear::HelicalGear& gear, double diameter);

/// Whether such pins touch the involute, clear of the root, and flat anvils touch the pins and not
/// the tips beside them.
bool pins_can_be_measured(const gear::HelicalGear& gear, double diameter);

}  // namespace cognate::problems
