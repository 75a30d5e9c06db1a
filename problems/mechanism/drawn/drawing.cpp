#include "problems/mechanism/drawn/drawing.hpp"

#include <algorithm>

#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {

bool joins(const DrawnJoint& joint, std::size_t link) {
  return std::ranges::find(joint.of, link) != joint.of.end();
}

std::vector<std::size_t> joints_of(const Drawing& drawing, std::size_t link) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    if (joins(drawing.joints[i], link)) found.push_back(i);
  }
  return found;
}

std::string joint_names(const Drawing& drawing, const std::vector<std::size_t>& joints) {
  std::string names;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (i > 0) names += i + 1 == joints.size() ? " and " : ", ";
    names += in_quotes(drawing.joints[joints[i]].name);
  }
  return names;
}

}  // namespace cognate::problems::reading
