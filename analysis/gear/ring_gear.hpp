/// @file A ring: an internal spur gear as a pinion-shaped tool cuts it.
///
/// Its teeth are the spaces of an external gear of the same teeth, module, rack and shift, whose
/// thickness is the ring's space width: a positive shift makes the ring larger (ISO 21771 writes
/// both with the opposite sign). Lengths in the unit of the module; angles in radians.
#pragma once

#include <vector>

#include "analysis/gear/spur_gear.hpp"
#include "analysis/gear/tooth_outline.hpp"

namespace cognate::gear {

/// `twin` is that external gear; its tip reduction makes the ring's tip circle larger.
struct RingGear {
  SpurGear twin;
  double cutter_teeth = 20;  ///< of the tool, which has no shift and cuts h* + c* deep, sharp-edged
};

double tip_radius(const RingGear& ring);  ///< (z/2 − h_a* + x + tip_reduction) m

/// inv α₀ = inv α + 2 x tan α/(z − z₀) and a₀ = (r_b − r_b0)/cos α₀ of tool and ring. Not numbers
/// where they cannot mesh.
struct Cutting {
  double pressure_angle = 0;
  double centre_distance = 0;
  double tip_radius = 0;      ///< of the tool: (z₀/2 + h_a* + c*) m
  double tip_half_angle = 0;  ///< half the angle that the tool's tooth takes there
};
Cutting cutting_of(const RingGear& ring);

double root_radius(const RingGear& ring);  ///< as cut: a₀ and the tool's tip radius

/// Where the involute ends and the fillet begins, outside: where the tool's tip leaves the line of
/// action.
double form_radius(const RingGear& ring);

/// Arc thickness of the ring's tooth at `radius`, the pitch less the twin's tooth there.
double tooth_thickness(const RingGear& ring, double radius);

/// Why a ring cannot be.
enum class RingFault {
  none,
  no_cutting,    ///< tool and ring do not mesh: too many teeth of the tool, or too small a shift
  pointed_tool,  ///< the tool's teeth end before its tip circle
  no_flank,      ///< form circle inside the tip circle
  inside_base,   ///< the tip circle is inside the base circle, where there is no involute
  pointed        ///< the ring's own teeth end before its tip circle
};
RingFault ring_fault(const RingGear& ring);

/// Half a tooth, as `tooth_half` of external gears has it: from the middle of the root to that of
/// the tip, the tooth's middle on the y axis and the flank on x ≤ 0, radii never rising. The fillet
/// is the path of the tool's corner. Empty where the ring cannot be or `tolerance` is not positive.
std::vector<OutlinePoint> ring_half(const RingGear& ring, double tolerance);

/// The whole inner outline, counter-clockwise from the root's middle before the first tooth, whose
/// middle is the y axis.
std::vector<OutlinePoint> ring_outline(const RingGear& ring, double tolerance);

}  // namespace cognate::gear
