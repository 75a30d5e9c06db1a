/// @file The outline of a gear as its rack cuts it.
#pragma once

#include <vector>

#include "analysis/gear/spur_gear.hpp"
#include "analysis/vec2.hpp"

namespace cognate::gear {

/// What a point of an outline lies on.
enum class OutlinePart { root, fillet, involute, tip };

struct OutlinePoint {
  Vec2d at{};
  OutlinePart part = OutlinePart::root;
};

/// The right half of one tooth space to the tooth's middle, from the root's middle to the tip's
/// middle: the gear's centre at the origin, the tooth's middle on the y axis, the flank on x ≤ 0,
/// radii increasing but for undercut fillets. Chords leave the curve by no more than `tolerance`.
///
/// Parts: an arc of the root circle, the fillet (the envelope of the rack's rounded tip), the
/// involute from the form circle to the tip, an arc of the tip circle (a point where the tooth is
/// pointed below the tip circle: there the tooth ends).
std::vector<OutlinePoint> tooth_half(const SpurGear& gear, double tolerance);

/// The whole gear, closed, counter-clockwise, the first tooth's middle on the y axis. `teeth` must
/// be whole.
std::vector<OutlinePoint> gear_outline(const SpurGear& gear, double tolerance);

/// The rack's outline over `teeth` teeth to either side, at the roll angle `angle` (radians) of the
/// gear whose centre is the origin: it moves along −x… as the gear would turn counter-clockwise,
/// its pitch line at y = r + x m. At angle 0 a space of the rack is above the tooth's middle at x =
/// 0.
std::vector<Vec2d> rack_outline(const SpurGear& gear, double angle, int teeth, double tolerance);

}  // namespace cognate::gear
