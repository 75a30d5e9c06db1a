/// @file Inverse dynamics: the forces in the joints and the drive of a moving mechanism.
#pragma once

#include <vector>

#include "analysis/mechanism/joints.hpp"

namespace cognate {

/// Mass properties of a body: mass (kg), centre of mass in the body's axes (m), moment of inertia
/// about it (kg·m²).
struct Inertia {
  double mass = 0;
  Vec2d centre{};
  double moment = 0;
};

/// A load that acts now: a force (N, global axes) at a point of a body, and a torque (N·m) on it.
struct Load {
  Attached<double> at{};
  Vec2d force{};
  double torque = 0;
};

/// How the drive moves: rad/s and rad/s², or m/s and m/s².
struct DriveRate {
  double speed = 0;
  double acceleration = 0;
};

/// What body `first` of a joint exerts on body `second`: a force (N, global axes) and, in a
/// prismatic joint, a moment (N·m) about the joint's point `at`.
struct Reaction {
  Vec2d force{};
  double moment = 0;
};

/// Forces in joints and drive at one position.
struct Forces {
  std::vector<Reaction> reactions;  ///< one for each joint of joints(mechanism)
  double drive = 0;  ///< driving torque (N·m, counter-clockwise) or force (N, along the guide)
  Vec2d shaking_force{};      ///< that the frame receives from all joints on it and the drive (N)
  double shaking_moment = 0;  ///< of those about the global origin, driving torque included (N·m)
};

}  // namespace cognate
