/// @file Helical, bevel and worm gears by their virtual spur gears.
///
/// Geometry of Li & Xu 2011, 5.5 to 5.7 (ISO 21771, ISO 23509 for the straight bevel, Tredgold's
/// approximation): each is reduced to spur gears, to which spur_gear.hpp and spur_pair.hpp apply.
/// Angles in radians. Numbers that make no gear give infinities and what is not a number, as the
/// formulas do.
#pragma once

#include <array>

#include "analysis/gear/spur_pair.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {

/// A gear whose rack's teeth are inclined by `helix` on the reference cylinder. Module, rack and
/// shift are those of the normal section.
struct HelicalGear {
  SpurGear normal;
  double helix = 0;
  double face_width = 0;
};

/// Its transverse section: m_t = m_n/cos β, tan α_t = tan α_n/cos β, h_t* = h_n* cos β, x_t = x_n
/// cos β. The fillet is that of a circular corner as deep; the rack's own is there an ellipse.
SpurGear transverse(const HelicalGear& gear);
double virtual_teeth(const HelicalGear& gear);  ///< z/cos³β
double overlap_ratio(const HelicalGear& gear);  ///< b sin|β|/(π m_n)
double base_helix(const HelicalGear& gear);     ///< sin β_b = sin β cos α_n
double lead(const HelicalGear& gear);           ///< 2π r/tan|β|; infinite without helix

/// cos β_y, where tan β_y = tan β r_y/r, of teeth whose transverse section is `section`: across
/// them they are by it thinner than the arc of the section at `radius` (ISO 21771).
double helix_cosine(const SpurGear& section, double helix, double radius);

/// Straight bevel gears whose axes meet at `shaft_angle`. Module: outer, transverse.
struct BevelPair {
  std::array<double, 2> teeth{};
  double module = 1;
  double shaft_angle = kRightAngle;
  double face_width = 0;
  BasicRack rack;
  std::array<double, 2> profile_shift{};  ///< x₂ = −x₁ keeps the cones
};

struct BevelGear {
  double cone_angle = 0;  ///< δ of the pitch cone
  double cone_distance = 0;
  double tip_angle = 0, root_angle = 0;  ///< of the cones of tip and root (common apex)
  double outer_tip_diameter = 0, outer_root_diameter = 0;
  double mean_module = 0;  ///< transverse, at half the face width
  SpurGear virtual_gear;   ///< z/cos δ teeth on the back cone
};

/// tan δ₁ = sin Σ/(z₂/z₁ + cos Σ), δ₂ = Σ − δ₁. A cone of a right angle or more (Σ > π/2 and
/// cos Σ ≤ −z₁/z₂) is a face gear or an internal one: its virtual gear has no positive number of
/// teeth.
BevelGear bevel_gear(const BevelPair& pair, int index);

/// The virtual gears in mesh, on the back cones developed into the plane, without backlash.
SpurPair virtual_pair(const BevelPair& pair);

/// A cylindrical worm and its wheel, axes at a right angle. Module: axial.
struct WormPair {
  double starts = 1;
  double wheel_teeth = 0;
  double module = 1;
  double diameter_quotient = 10;  ///< q = d₁/m
  double wheel_shift = 0;         ///< x₂: a = ½ m (q + z₂ + 2 x₂)
  BasicRack rack;                 ///< axial section
};

struct WormGeometry {
  double lead_angle = 0;  ///< tan γ = z₁/q
  double lead = 0;        ///< π m z₁
  double centre_distance = 0;
  double worm_reference_diameter = 0, worm_tip_diameter = 0, worm_root_diameter = 0;
  double wheel_reference_diameter = 0, wheel_throat_diameter = 0, wheel_root_diameter = 0;
  double sliding_speed_ratio = 0;  ///< over the worm's pitch line speed: 1/cos γ
  double normal_pressure_angle = 0;
};

WormGeometry geometry(const WormPair& pair);

/// Efficiency of the worm driving, tan γ/tan(γ + ρ′), where tan ρ′ = μ/cos α_n; 0 where it cannot
/// turn the wheel.
double efficiency(const WormPair& pair, double friction);

/// Whether the wheel cannot drive the worm: γ ≤ ρ′.
bool locks_itself(const WormPair& pair, double friction);

}  // namespace cognate::gear
