/// @file The outline of a gear as its rack cuts it.
#pragma once

#include <vector>

#include "analysis/gear/spur_gear.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::gear {

/// What a piece of an outline is.
enum class OutlinePart { root, fillet, involute, tip };

/// A corner of an outline, and what the chord that leads to it stands for.
struct OutlinePoint {
  Vec2d at{};
  OutlinePart part = OutlinePart::root;
};

/// The right half of one tooth space to the tooth's middle, from the root's middle to the tip's
/// middle: the gear's centre at the origin, the tooth's middle on the y axis, the flank on x ≤ 0,
/// radii never falling. Chords leave the curve by no more than `tolerance`, unless that takes more
/// than 1024 of them for one part.
///
/// Parts: an arc of the root circle, the fillet (the envelope of the rack's rounded tip), the
/// involute from the form circle to the tip, an arc of the tip circle (none where the tooth is
/// pointed below the tip circle: there the tooth ends). The first point's part is the root.
///
/// Empty if the gear can't be made (`tooth_fault`) or the tolerance is not positive.
std::vector<OutlinePoint> tooth_half(const SpurGear& gear, double tolerance);

/// The whole gear, counter-clockwise from the root's middle before the first tooth, whose middle is
/// the y axis; closed by the chord from the last point to the first. `teeth` must be whole.
std::vector<OutlinePoint> gear_outline(const SpurGear& gear, double tolerance);

/// The outline of so many teeth of which `half` is half of one, likewise.
std::vector<OutlinePoint> whole_outline(const std::vector<OutlinePoint>& half, double whole_teeth);

/// The rack's outline over `teeth` teeth to either side, from left to right, when the gear whose
/// centre is the origin has turned counter-clockwise by `angle` (radians) and the rack with it
/// along −x, its pitch line at y = r + x m. At angle 0 a space of the rack is above the tooth's
/// middle at x = 0. Above the pitch line the flanks go on to the depth of the tip, or to where they
/// meet.
std::vector<Vec2d> rack_outline(const SpurGear& gear, double angle, int teeth, double tolerance);

}  // namespace cognate::gear
