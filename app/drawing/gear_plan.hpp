/// @file The outlines of gears, laid out in layers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/gear/rack_pair.hpp"
#include "analysis/gear/ring_gear.hpp"
#include "analysis/gear/spur_gear.hpp"
#include "analysis/gear/tooth_outline.hpp"
#include "app/drawing/plan.hpp"

namespace cognate::app {

/// A gear by its transverse section, and where it stands.
struct GearPose {
  std::string name;  ///< "pinion" or "wheel"; empty of a gear alone
  gear::SpurGear section;
  Vec2d centre{};
  double angle = 0;         ///< that its first tooth has turned counter-clockwise from the y axis
  double pitch_radius = 0;  ///< of the circle on which the pair rolls; alone the reference circle
  std::optional<gear::RingGear> ring{};  ///< of an internal gear, whose twin `section` is
  /// Of a rack that meshes with `section`, its tooth's middle half a pitch and `offset` beside the
  /// y axis.
  std::optional<gear::RackPair> rack{};
  double offset = 0;
  double helix = 0;  ///< β of this gear on its reference cylinder, positive right-handed
};

/// How many teeth of a rack are drawn.
inline constexpr int kRackTeeth = 12;

/// The closed outline of a gear where it stands, counter-clockwise.
struct GearOutline {
  GearPose gear;
  std::vector<gear::OutlinePoint> points;
};

/// The outline of `gear`, whose chords leave the curve by `chord_tolerance` at most; of a ring the
/// inner one, of a rack that of its teeth and of a body above them.
GearOutline gear_outline(const GearPose& gear, double chord_tolerance);

/// The outlines with their arcs of root and tip circles as arcs, on the layer OUTLINE; the circles
/// BASE_CIRCLE, PITCH_CIRCLE, TIP_CIRCLE, ROOT_CIRCLE; a cross at each CENTRE; of a
/// rack its pitch line on PITCH_CIRCLE alone. It is called `title`, or "Gears" where that is empty.
Plan gear_plan(const std::vector<GearOutline>& gears, const std::string& title);

}  // namespace cognate::app
