#include "problems/evaluation/tolerance_scope.hpp"

#include <algorithm>

#include "analysis/mechanism/joints.hpp"
#include "problems/evaluation/output_travel.hpp"
#include "problems/mechanism/joint_names.hpp"
#include "problems/tolerance/dimensions.hpp"

namespace cognate::problems {
namespace {

/// The names of turning joints that are a point's.
std::vector<std::string> pins(const NamedMechanism& mechanism) {
  const JointList list = joints(mechanism.mechanism);
  const std::vector<std::string> names = joint_names(mechanism);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < list.joints.size(); ++i) {
    const bool turns = list.joints[i].type == JointType::revolute;
    if (turns && std::ranges::find(all, names[i]) == all.end()) all.push_back(names[i]);
  }
  return all;
}

}  // namespace

reading::ToleranceScope tolerance_scope(const NamedMechanism& mechanism) {
  reading::ToleranceScope scope{
      .dimensions = dimension_groups(mechanism), .joints = pins(mechanism), .points = {}};
  for (const NamedPoint& point : mechanism.points) {
    if (point.at.body != 0) scope.points.push_back(point.name);
  }
  if (!output_travel(mechanism).slides) scope.unit = "deg";
  return scope;
}

bool judges_angle(const AnalysisProblem& problem) {
  // A problem of a user's own may have no such body.
  const auto output = static_cast<std::size_t>(problem.mechanism.output);
  if (!problem.tolerances || output >= problem.mechanism.bodies.size()) return false;
  return problem.tolerances->of.empty() && !output_travel(problem.mechanism).slides;
}

}  // namespace cognate::problems
