/// @file The links and joints of a linkage with all that lies on them, in their own axes.
#pragma once

#include <string>
#include <vector>

#include "analysis/mechanism/joints.hpp"
#include "app/export/result_linkage.hpp"
#include "app/report/mechanism_poses.hpp"
#include "app/report/mechanism_shapes.hpp"

namespace cognate::app {

/// A turning joint or a named point, in the axes of the link that it is on.
struct LinkPlace {
  std::string name;
  Vec2d at{};
  bool joint = false;
};

struct ShownLink {
  std::string name;
  std::vector<LinkPlace> places;  ///< each place once
  BodyShape shape;
};

struct ShownJoint {
  std::string name;
  JointType type = JointType::revolute;
  int first = 0, second = 0;  ///< the links that it connects
  Attached<double> at{};
};

struct ShownLinks {
  MechanismPoses poses;            ///< of the drive, two turns at most
  std::vector<ShownLink> links;    ///< the frame first
  std::vector<ShownJoint> joints;  ///< in the order of the links
};

/// The links of `linkage`: guides are as long as the blocks travel over the drive, to
/// rounding and no shorter.
ShownLinks shown_links(const ResultLinkage& linkage);

/// What is nearer counts as one place, as a share of the size of a linkage.
inline constexpr double kOnePlace = 1e-9;

/// Half the greatest side of the rectangle about all joints on their way.
double size_of(const ShownLinks& shown);

}  // namespace cognate::app
