/// @file The links and joints of a linkage with all that lies on them, in their own axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/mechanism/joints.hpp"
#include "app/drawing/linkage_scene.hpp"
#include "app/drawing/mechanism_poses.hpp"
#include "app/drawing/mechanism_shapes.hpp"

namespace cognate::app {

/// A turning joint or a named point, in the axes of the link that it is on.
struct LinkPlace {
  std::string name;
  Vec2d at{};
  bool joint = false;
};

struct LinkShape {
  std::string name;
  std::vector<LinkPlace> places;  ///< each place once
  BodyShape shape;
  int layer = 0;  ///< from 1 above the frame, where layers are assigned; 0 without one
};

struct JointShape {
  std::string name;
  JointType type = JointType::revolute;
  int first = 0, second = 0;  ///< the links that it connects
  Attached<double> at{};
};

/// Of a driving cylinder, from its pivot to the pin of its rod.
struct CylinderLengths {
  double least = 0, greatest = 0;
};

struct LinkShapes {
  MechanismPoses poses;            ///< of the drive, two turns at most
  std::vector<LinkShape> links;    ///< the frame first
  std::vector<JointShape> joints;  ///< in the order of the links
  std::optional<CylinderLengths> cylinder{};
};

/// The links of `linkage`: guides are as long as the blocks travel over the drive, to
/// rounding and no shorter.
LinkShapes link_shapes(const LinkageScene& linkage);

/// What is nearer counts as one place, as a share of the size of a linkage.
inline constexpr double kOnePlace = 1e-9;

/// Half the greatest side of the rectangle about all joints on their way.
double size_of(const LinkShapes& shown);

}  // namespace cognate::app
