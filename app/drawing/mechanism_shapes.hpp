/// @file How the bodies of any mechanism are drawn.
#pragma once

#include <vector>

#include "analysis/mechanism/mechanism.hpp"
#include "app/drawing/mechanism_poses.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::app {

/// The part of a guide on which a block travels, in the axes of the body that carries it.
struct Rail {
  Vec2d from{};
  Vec2d to{};
  int traveller = 0;  ///< the body whose origin travels there, its first axis along the guide
};

/// What to draw of a body, in its axes.
struct BodyShape {
  std::vector<Vec2d> outline;  ///< corners of the convex hull of its points, counter-clockwise: one
                               ///< for a mere pin, two for a bar; none for the frame
  std::vector<Rail> rails;
  bool block = false;  ///< about the origin, along the first axis
};

/// A turning joint; `fixed` where it stands on the frame.
struct Pin {
  Attached<double> at{};
  bool fixed = false;
};

struct MechanismShapes {
  std::vector<BodyShape> bodies;  ///< the frame first
  std::vector<Pin> pins;          ///< each place once
};

/// The shapes of the bodies: each connects the joints and the named points on it, a slider and what
/// turns in a guide has a block, and the rails are as long as the blocks travel in `poses`.
MechanismShapes mechanism_shapes(const problems::NamedMechanism& mechanism,
                                 const MechanismPoses& poses);

}  // namespace cognate::app
