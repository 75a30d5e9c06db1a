/// @file An external involute spur gear as a rack cuts it, in its transverse section.
///
/// The gear is that of Li & Xu 2011, chapter 5, with profile shift (ISO 21771): its flank is an
/// involute above the form circle and the envelope of the rack's rounded tip, a trochoid's
/// parallel, below. Lengths in the unit of the module; angles in radians.
#pragma once

#include <optional>

#include "analysis/numbers/constants.hpp"

namespace cognate::gear {

/// The rack that cuts, with its lengths in modules (ISO 53). `addendum` is the depth to which the
/// mating gear's tip reaches below the pitch line; `clearance`: how much deeper the rack's is.
struct BasicRack {
  double pressure_angle = kPi / 9;
  double addendum = 1;
  double clearance = 0.25;
  std::optional<double> corner_radius{};  ///< of its tip, in modules, where it is not the usual one
};

/// Radius of the rack's tip corner in modules: the one given, else the usual one. That meets the
/// straight flank where the addendum ends and the tip line tangentially, c*/(1 − sin α) (0.38 of
/// the standard rack), or is the greatest if that is less.
double tip_radius(const BasicRack& rack);

/// The greatest radius for which the tip has room, which rounds it fully: (π/4 − (h* + c*) tan α)
/// cos α/(1 − sin α). Negative: the flanks meet before the tip.
double greatest_tip_radius(const BasicRack& rack);

/// The depth at which the straight flank ends and the corner begins: h* + c* − ρ* (1 − sin α), that
/// is the addendum unless the corner is given or fully round.
double flank_depth(const BasicRack& rack);

/// Half the width, in modules, of the straight part of the rack's tip. Negative: there is no such
/// rack, its rounded corners overlap.
double tip_half_width(const BasicRack& rack);

/// `teeth` is a whole number but for virtual gears. `tip_reduction`: by how many modules the tip
/// circle is smaller than (z/2 + h_a* + x) m. `coarsening`: by how much the tooth is thinner at the
/// reference circle than m (π/2 + 2 x tan α), a length: the tool's tooth is as much thicker, its
/// depth the same.
struct SpurGear {
  double teeth = 0;
  double module = 1;
  double profile_shift = 0;
  BasicRack rack;
  double tip_reduction = 0;
  double coarsening = 0;
};

double reference_radius(const SpurGear& gear);  ///< m z / 2
double base_radius(const SpurGear& gear);       ///< r cos α
double tip_radius(const SpurGear& gear);        ///< (z/2 + h_a* + x − tip_reduction) m
double root_radius(const SpurGear& gear);       ///< (z/2 − h_a* − c* + x) m

/// The radius at which the involute begins: where the end of the rack's straight flank leaves it;
/// of an undercut gear where the trochoid of the rack's tip cuts the involute. It is that of the
/// flank as cut, not (z/2 − h_a*) m, which is less or even inside the base circle.
double form_radius(const SpurGear& gear);

/// The length of the tangent to the base circle that ends on the form circle, which is the radius
/// of curvature with which the involute begins. Known to rounding of the module also where that
/// circle hardly differs from the base circle and its radius no longer decides.
double form_tangent(const SpurGear& gear);

/// Whether the rack's straight flank reaches beyond the point where the base circle touches the
/// line of action: h_f* − x > ½ z sin²α, to rounding, where h_f* is its depth.
bool is_undercut(const SpurGear& gear);

/// z_min = 2 (h_f* − x)/sin²α: from this number of teeth on nothing is undercut.
double least_teeth(const BasicRack& rack, double profile_shift);

/// x_min = h_f* − ½ z sin²α.
double least_profile_shift(const BasicRack& rack, double teeth);

/// α_y of the involute at `radius`, cos α_y = r_b/r_y. Not a number inside the base circle.
double pressure_angle(const SpurGear& gear, double radius);

/// Half the angle that a tooth takes at its base circle, were its involutes to reach there:
/// s/(2 r) + inv α.
double base_half_angle(const SpurGear& gear);

/// Arc thickness of the tooth at `radius`: r_y (s/r + 2 (inv α − inv α_y)), also where form or tip
/// circle leave no involute. Negative beyond the radius where the flanks meet, not a number inside
/// the base circle.
double tooth_thickness(const SpurGear& gear, double radius);

/// Where the flanks of a tooth meet, inv α_p = s/(2 r) + inv α; the base radius where the tooth has
/// no thickness there already.
double pointed_radius(const SpurGear& gear);

/// Where the involute ends: the lesser of tip and pointed radius.
double flank_end_radius(const SpurGear& gear);

/// The thickness of the tooth, along a straight line across it, where its fillets leave least of
/// it: at the form circle, or below of an undercut gear. Negative: they cut the tooth off.
double waist_thickness(const SpurGear& gear);

/// Why a gear with finite, positive teeth, module and pressure angle can't be made.
enum class ToothFault {
  none,
  rack_overlaps,  ///< the rounded corners of the rack's tip
  no_root,        ///< the root circle has no radius
  no_flank,       ///< the involute would begin above the tip, or where the tooth is pointed already
  cut_through     ///< by fillets that meet within the tooth
};

ToothFault tooth_fault(const SpurGear& gear);

}  // namespace cognate::gear
