/// @file The kernel's closure and the common formulas it is compared with, behind one signature.
#pragma once

#include <array>
#include <string_view>

#include "tests/stress/exact_closure.hpp"

namespace cognate::stress {

/// Where a form says the links point; `closes` false where it says they cannot.
struct Answer {
  bool closes = false;
  Vec2d coupler, rocker;
};

struct Form {
  std::string_view name;
  Answer (*evaluate)(const Configuration&);
};

/// The kernel: `Closure<double>` on the half angle vector.
Answer kernel(const Configuration& at);

/// Law of cosines in the triangle B–C–D with acos and atan2, as in textbooks.
Answer law_of_cosines(const Configuration& at);

/// Freudenstein's equation as a quadratic in tan(ψ/2) and tan(φ/2); Norton, Design of Machinery,
/// equations 4.10 to 4.13.
Answer half_angle_tangents(const Configuration& at);

/// Circle–circle intersection with h² = d²l₂² − a².
Answer raw_discriminant(const Configuration& at);

/// Circle–circle intersection with the area of B–C–D from its sorted sides; Kahan, "Miscalculating
/// area and angles of a needle-like triangle", 2014.
Answer sorted_sides(const Configuration& at);

inline constexpr std::array<Form, 5> kForms{{{"kernel", kernel},
                                             {"law of cosines", law_of_cosines},
                                             {"half-angle tangents", half_angle_tangents},
                                             {"raw discriminant", raw_discriminant},
                                             {"sorted sides", sorted_sides}}};

}  // namespace cognate::stress
