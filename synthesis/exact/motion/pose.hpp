/// @file Poses of a body that is to be guided, and the displacements between them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

/// Where a body stands: its origin in the fixed frame, and the angle of its first axis from the x
/// axis in radians, counter-clockwise. A point p of the body lies at `at` + e^{i·angle} p.
struct Pose {
  Vec2d at;
  double angle = 0;
};

/// The body's point `p` (body axes) in the fixed frame, and back.
Vec2d to_frame(const Pose& pose, const Vec2d& p);
Vec2d to_body(const Pose& pose, const Vec2d& p);

/// A straight line of the plane: through a point, along a unit vector.
struct Line {
  Vec2d point;
  Vec2d direction{1, 0};
};

/// How the plane moves from one pose of a body to another: x → about + shift + e^{i·angle}(x −
/// about), `about` being where the body's origin stood before.
struct Displacement {
  Vec2d about;
  Vec2d shift;          ///< of the body's origin
  double angle = 0;     ///< in [−π, π]
  Vec2d turn_less_one;  ///< e^{i·angle} − 1, without cancellation

  /// From the point x of the fixed frame to where it is displaced.
  Vec2d way(const Vec2d& x) const;
};

/// How the plane moves from one pose to the other.
Displacement displacement(const Pose& from, const Pose& to);

/// The point that a displacement leaves where it is: about + i·shift/(2 tan(angle/2)) + shift/2.
/// Empty for a pure translation (it lies at infinity, across the shift) and where nothing moves.
/// Angles below 1e-14 count as none.
std::optional<Vec2d> pole(const Displacement& displacement);

/// The body given by where two of its points stand: origin at the first, first axis towards the
/// second. `lengths` are their distances, which ought to be one; `spread` is the greatest less the
/// least. Poses are empty unless both lists have one length, and where two points coincide.
struct SegmentPoses {
  std::vector<Pose> poses;
  double length = 0;  ///< the mean distance: the second point is (length, 0) in body axes
  double spread = 0;
};
SegmentPoses poses_of_segment(std::span<const Vec2d> first, std::span<const Vec2d> second);

}  // namespace cognate::synthesis
