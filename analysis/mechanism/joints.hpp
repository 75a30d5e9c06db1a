/// @file The joints of a mechanism, and which bodies they connect.
#pragma once

#include <vector>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// A pin or a slide.
enum class JointType { revolute, prismatic };

/// A joint between body `first` (nearer to the frame or the drive) and body `second`. A revolute
/// stands at `at`; a prismatic joint slides along the first axis of body `at.body` (`direction` in
/// its axes where the slide is not along the first axis), and `at` is the point about which its
/// moment is reported.
struct Joint {
  JointType type = JointType::revolute;
  int first = 0;
  int second = 0;
  Attached<double> at{};
  Vec2d direction{1, 0};
};

/// Bodies that are determined together, and the joints to the bodies before them:
/// the drive (its bodies and joints, and one more unknown, the driving torque or force), a dyad or
/// a group; none for what says that bodies belong to the group before.
struct JointGroup {
  int first_body = 0;
  int bodies = 0;
  int first_joint = 0;
  int joints = 0;
};

/// The joints of a mechanism, and how they belong together.
struct JointList {
  std::vector<Joint> joints;
  std::vector<JointGroup> groups;  ///< the drive first, then the dyads
};

/// Joints in the order of the bodies: of a crank its pivot; of a driving slider its guide; of a
/// floating link its two pins, then its two guides; of a dyad the outer joint of its first body,
/// the inner joint (first → second body), the outer joint of its second body; of a group those that
/// it lists.
JointList joints(const Mechanism<double>& mechanism);

}  // namespace cognate
