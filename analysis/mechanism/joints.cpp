#include "analysis/mechanism/joints.hpp"

namespace cognate {
namespace {

Joint revolute(int first, int second, const Attached<double>& at) {
  return {JointType::revolute, first, second, at, {1, 0}};
}

/// A slide of body `second` along the first axis of `along`, at that body's origin.
Joint prismatic(int first, int second, int along) {
  return {JointType::prismatic, first, second, {along, {0, 0}}, {1, 0}};
}

std::vector<Joint> joints_of(const Crank<double>& crank) {
  return {revolute(0, 1, {0, crank.pivot})};
}

std::vector<Joint> joints_of(const DrivingSlider<double>&) {
  return {prismatic(0, 1, 1)};
}

std::vector<Joint> joints_of(const FloatingLink<double>& link) {
  return {revolute(2, 1, {1, {0, 0}}), revolute(3, 1, {1, {link.length, 0}}), prismatic(0, 2, 2),
          prismatic(0, 3, 3)};
}

std::vector<Joint> joints_of(const DrivingRod<double>&) {
  return {prismatic(2, 1, 1)};
}

// The dyads, whose bodies are n and n + 1.

std::vector<Joint> joints_of(const Rrr<double>& dyad, int n) {
  return {revolute(dyad.first.body, n, dyad.first), revolute(n, n + 1, {n, {dyad.first_length, 0}}),
          revolute(dyad.second.body, n + 1, dyad.second)};
}

std::vector<Joint> joints_of(const Rrp<double>& dyad, int n) {
  return {revolute(dyad.point.body, n, dyad.point), revolute(n, n + 1, {n, {dyad.length, 0}}),
          prismatic(dyad.guide.body, n + 1, n + 1)};
}

std::vector<Joint> joints_of(const Rpr<double>& dyad, int n) {
  return {revolute(dyad.block.body, n, dyad.block), prismatic(n, n + 1, n),
          revolute(dyad.pivot.body, n + 1, dyad.pivot)};
}

std::vector<Joint> joints_of(const Prp<double>& dyad, int n) {
  return {prismatic(dyad.first.body, n, n), revolute(n, n + 1, {n, {0, 0}}),
          prismatic(dyad.second.body, n + 1, n + 1)};
}

std::vector<Joint> joints_of(const Rpp<double>& dyad, int n) {
  return {revolute(dyad.point.body, n, dyad.point), prismatic(n, n + 1, n),
          prismatic(dyad.guide.body, n + 1, n + 1)};
}

std::vector<Joint> joints_of(const Cylinder<double>& dyad, int n) {
  return {revolute(dyad.base.body, n, dyad.base), revolute(1, n + 1, {1, {0, 0}}),
          revolute(dyad.pivot.body, n + 1, dyad.pivot)};
}

std::vector<Joint> joints_of(const Group& group, int) {
  std::vector<Joint> joints;
  for (const GroupJoint& joint : group.joints) {
    joints.push_back({joint.slides ? JointType::prismatic : JointType::revolute, joint.first.body,
                      joint.second.body, joint.second, joint.along_second});
  }
  return joints;
}

std::vector<Joint> joints_of(const GroupRest&, int) {
  return {};
}

int bodies_of(const Dyad<double>& dyad) {
  if (const auto* group = std::get_if<Group>(&dyad)) return static_cast<int>(group->drawn.size());
  return std::holds_alternative<GroupRest>(dyad) ? 0 : 2;
}

void append(JointList& list, int first_body, int bodies, const std::vector<Joint>& joints) {
  list.groups.push_back(
      {first_body, bodies, static_cast<int>(list.joints.size()), static_cast<int>(joints.size())});
  list.joints.insert(list.joints.end(), joints.begin(), joints.end());
}

}  // namespace

JointList joints(const Mechanism<double>& mechanism) {
  JointList list;
  append(list, 1, drive_bodies(mechanism),
         std::visit([](const auto& member) { return joints_of(member); }, mechanism.drive));
  for (int i = 0; i < static_cast<int>(mechanism.dyads.size()); ++i) {
    const int n = first_body(mechanism, i);
    const Dyad<double>& dyad = mechanism.dyads[static_cast<std::size_t>(i)];
    append(list, n, bodies_of(dyad),
           std::visit([n](const auto& group) { return joints_of(group, n); }, dyad));
  }
  return list;
}

}  // namespace cognate
