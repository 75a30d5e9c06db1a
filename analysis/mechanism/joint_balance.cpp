#include "analysis/mechanism/joint_balance.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <variant>

#include "analysis/mechanism/group_equations.hpp"

namespace cognate {
namespace {

/// An equation of an inner pin's force F: cross(along, F) = value.
struct PinEquation {
  Vec2d along;
  double value = 0;
};

/// The force for which both hold. Where the two are parallel it is not finite.
Vec2d pin_force(const PinEquation& first, const PinEquation& second) {
  const double scale = 1 / cross(first.along, second.along);
  return scale * (first.value * second.along - second.value * first.along);
}

/// The equation of a body on which `sign` times the inner pin's force acts, at the distance
/// 1/`by_reach` along its first axis: with an outer slide the force along the slide, with an outer
/// pin the moment about it.
PinEquation pin_equation(const LoadedBody& body, bool slides, double by_reach, double sign) {
  if (slides) return {-perp(body.direction), sign * dot(body.direction, body.required.force)};
  return {body.direction, sign * by_reach * body.required.moment};
}

/// `body.required` less what is exerted at `arm` from its origin.
void take(LoadedBody& body, const Vec2d& arm, const Vec2d& force, double moment) {
  body.required.force = body.required.force - force;
  body.required.moment -= moment + cross(arm, force);
}

}  // namespace

struct JointBalance::DyadJointsOf {
  static OuterJoint pin(const Attached<double>& point) {
    return {.body = static_cast<std::size_t>(point.body), .on = point.at};
  }
  static OuterJoint slide(const Guide<double>& guide) {
    return {.body = static_cast<std::size_t>(guide.body), .slides = true};
  }
  DyadJoints operator()(const Rrr<double>& dyad) const {
    return {.outer = {pin(dyad.first), pin(dyad.second)},
            .by_reach = {1 / dyad.first_length, 1 / dyad.second_length}};
  }
  DyadJoints operator()(const Rrp<double>& dyad) const {
    return {.outer = {pin(dyad.point), slide(dyad.guide)}, .by_reach = {1 / dyad.length, 0}};
  }
  DyadJoints operator()(const Rpr<double>& dyad) const {
    return {.inner_slides = true, .outer = {pin(dyad.block), pin(dyad.pivot)}};
  }
  DyadJoints operator()(const Prp<double>& dyad) const {
    return {.outer = {slide(dyad.first), slide(dyad.second)}};
  }
  DyadJoints operator()(const Rpp<double>& dyad) const {
    return {.inner_slides = true, .outer = {pin(dyad.point), slide(dyad.guide)}};
  }
  DyadJoints operator()(const Cylinder<double>& dyad) const {
    return {.outer = {pin(dyad.base), pin(dyad.pivot)}, .by_reach = {0, 1 / dyad.length}};
  }
  DyadJoints operator()(const Group&) const { return {}; }
  DyadJoints operator()(const GroupRest&) const { return {}; }
};

JointBalance::JointBalance(const Mechanism<double>& mechanism)
    : drive_(mechanism.drive),
      drive_bodies_(static_cast<std::size_t>(drive_bodies(mechanism))),
      bodies_(static_cast<std::size_t>(body_count(mechanism))) {
  dyads_.reserve(mechanism.dyads.size());
  for (std::size_t i = 0; i < mechanism.dyads.size(); ++i) {
    dyads_.push_back(std::visit(DyadJointsOf{}, mechanism.dyads[i]));
    const auto* group = std::get_if<Group>(&mechanism.dyads[i]);
    if (!group) continue;
    const auto last = 1 + drive_bodies_ + 2 * i + group->drawn.size();
    groups_.push_back({*group, i, std::vector<BodyMotion<double, 0>>(last)});
  }
}

std::size_t JointBalance::joints() const {
  return drive_joints() + 3 * dyads_.size();
}

/// What the first body exerts on the second: a force at the inner pin, or at the first body's
/// origin a force across its slide and a moment.
Reaction JointBalance::inner_reaction(const DyadJoints& dyad, const LoadedBody& first,
                                      const LoadedBody& second) const {
  if (!dyad.inner_slides) {
    return {pin_force(pin_equation(first, dyad.outer[0].slides, dyad.by_reach[0], -1),
                      pin_equation(second, dyad.outer[1].slides, dyad.by_reach[1], +1))};
  }
  const Vec2d across = perp(first.direction);
  const double moment = -first.required.moment;
  const double normal =
      dyad.outer[1].slides
          ? dot(second.direction, second.required.force) / dot(second.direction, across)
          : (second.required.moment - moment) / cross(first.origin - second.origin, across);
  return {normal * across, moment};
}

/// What is left for an outer pin, which the body then requires of the body before it.
Reaction JointBalance::outer_pin(const OuterJoint& joint, const Vec2d& force) {
  LoadedBody& before = bodies_[joint.body];
  take(before, before.direction * joint.on, -force, 0);
  return {force};
}

/// The same for an outer slide of `body`, with the moment about the body's origin.
Reaction JointBalance::outer_slide(const OuterJoint& joint, const LoadedBody& body,
                                   const Vec2d& force, double moment) {
  LoadedBody& before = bodies_[joint.body];
  const Vec2d across = perp(body.direction);
  const Reaction reaction{dot(across, force) * across, moment};
  take(before, body.origin - before.origin, -reaction.force, -moment);
  return reaction;
}

void JointBalance::solve_dyad(const DyadJoints& dyad, const LoadedBody& first,
                              const LoadedBody& second, std::span<Reaction, 3> reactions) {
  const Reaction inner = inner_reaction(dyad, first, second);
  const Vec2d of_first = first.required.force + inner.force;
  const Vec2d of_second = second.required.force - inner.force;
  reactions[1] = inner;
  // A slider's inner pin is its origin; an inner slide is at the first body's.
  reactions[0] = dyad.outer[0].slides
                     ? outer_slide(dyad.outer[0], first, of_first, first.required.moment)
                     : outer_pin(dyad.outer[0], of_first);
  if (!dyad.outer[1].slides) {
    reactions[2] = outer_pin(dyad.outer[1], of_second);
    return;
  }
  double moment = second.required.moment - inner.moment;
  if (dyad.inner_slides) moment -= cross(first.origin - second.origin, inner.force);
  reactions[2] = outer_slide(dyad.outer[1], second, of_second, moment);
}

void JointBalance::solve_group(GroupJoints& joints, std::span<Reaction> reactions) {
  const auto& [group, dyad, bodies] = joints;
  const std::size_t first = bodies.size() - group.drawn.size();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    joints.bodies[i].origin[0] = bodies_[i].origin;
    joints.bodies[i].direction = bodies_[i].direction;
  }
  const GroupEquations equations(group, first);
  GroupVector required(equations.size());
  for (std::size_t i = 0; i < group.drawn.size(); ++i) {
    const Wrench& wrench = bodies_[first + i].required;
    const auto row = static_cast<Eigen::Index>(3 * i);
    required[row] = wrench.force.x;
    required[row + 1] = wrench.force.y;
    required[row + 2] = wrench.moment / equations.arm();
  }
  const GroupMatrix matrix = equations.matrix<0>(bodies).transpose();
  const GroupVector found = Eigen::PartialPivLU<GroupMatrix>(matrix).solve(required);
  for (std::size_t i = 0; i < group.joints.size(); ++i) {
    const GroupJoint& joint = group.joints[i];
    const auto row = static_cast<Eigen::Index>(2 * i);
    const LoadedBody& second = bodies_[static_cast<std::size_t>(joint.second.body)];
    LoadedBody& before = bodies_[static_cast<std::size_t>(joint.first.body)];
    const Vec2d across = perp(before.direction * joint.along_first);
    reactions[i] = joint.slides ? Reaction{found[row + 1] * across, found[row] * equations.arm()}
                                : Reaction{{found[row], found[row + 1]}};
    if (static_cast<std::size_t>(joint.first.body) >= first) continue;
    const Vec2d at = second.origin + second.direction * joint.second.at;
    take(before, at - before.origin, -reactions[i].force, -reactions[i].moment);
  }
}

double JointBalance::solve_drive(const Crank<double>& crank, std::span<Reaction> reactions) {
  const Wrench& required = bodies_[1].required;
  reactions[0] = {required.force};
  take(bodies_[0], crank.pivot, -required.force, -required.moment);
  return required.moment;
}

double JointBalance::solve_drive(const DrivingSlider<double>&, std::span<Reaction> reactions) {
  const LoadedBody& slider = bodies_[1];
  const double drive = dot(slider.direction, slider.required.force);
  reactions[0] = {slider.required.force - drive * slider.direction, slider.required.moment};
  take(bodies_[0], slider.origin, -slider.required.force, -slider.required.moment);
  return drive;
}

/// The link's pins give its blocks what these require along their guides; the guides' normal forces
/// balance the rest, and the torque the moment.
double JointBalance::solve_drive(const FloatingLink<double>& link, std::span<Reaction> reactions) {
  LoadedBody& bar = bodies_[1];
  const LoadedBody &first = bodies_[2], &second = bodies_[3];
  const Vec2d along_first = -dot(first.direction, first.required.force) * first.direction;
  const Vec2d along_second = -dot(second.direction, second.required.force) * second.direction;
  const Vec2d rest = bar.required.force - along_first - along_second;
  const double scale = 1 / cross(first.direction, second.direction);
  const double first_normal = scale * dot(rest, second.direction);
  const double second_normal = -scale * dot(rest, first.direction);
  reactions[0] = {along_first + first_normal * perp(first.direction)};
  reactions[1] = {along_second + second_normal * perp(second.direction)};
  take(bar, {}, reactions[0].force, 0);
  take(bar, link.length * bar.direction, reactions[1].force, 0);
  const auto guide = [&](const LoadedBody& block, const Vec2d& pin) {
    return outer_slide({.body = 0}, block, block.required.force + pin, block.required.moment);
  };
  reactions[2] = guide(first, reactions[0].force);
  reactions[3] = guide(second, reactions[1].force);
  const double torque = bar.required.moment;
  take(bodies_[0], {}, {}, -torque);
  return torque;
}

/// Cylinder and rod turn together: the moment of both about the cylinder's pivot gives what the
/// rod's pin bears across them, that of the link about its own the rest. `reactions` are the slide
/// of the rod in the cylinder, the cylinder's pivot, the rod's pin and the link's pivot.
double JointBalance::solve_drive(const DrivingRod<double>&, std::span<Reaction> reactions) {
  const LoadedBody &rod = bodies_[1], &cylinder = bodies_[2], &link = bodies_[3];
  const DyadJoints& dyad = dyads_.front();
  const Vec2d along = rod.origin - cylinder.origin;
  const double by_length = 1 / dot(along, cylinder.direction);
  const double turning =
      cylinder.required.moment + rod.required.moment + cross(along, rod.required.force);
  // The pin exerts its force on the link and its opposite on the rod.
  const Vec2d pin = pin_force({cylinder.direction, -by_length * turning},
                              {link.direction, dyad.by_reach[1] * link.required.moment});
  const Vec2d of_rod = rod.required.force + pin;
  const double drive = dot(cylinder.direction, of_rod);
  reactions[0] = {of_rod - drive * cylinder.direction, rod.required.moment};
  reactions[1] = outer_pin(dyad.outer[0], cylinder.required.force + of_rod);
  reactions[2] = {pin};
  reactions[3] = outer_pin(dyad.outer[1], link.required.force - pin);
  return drive;
}

bool JointBalance::solve(Forces& forces) {
  bodies_[0].required = {};
  const std::span<Reaction> reactions = forces.reactions;
  const std::size_t of_drive = drive_joints();
  const std::size_t with_drive = drives_cylinder() ? 1 : 0;
  auto group = groups_.rbegin();
  for (std::size_t i = dyads_.size(); i-- > with_drive;) {
    if (group != groups_.rend() && i < group->dyad + group->group.drawn.size() / 2) {
      if (i > group->dyad) continue;
      solve_group(*group, reactions.subspan(of_drive + 3 * i, group->group.joints.size()));
      ++group;
      continue;
    }
    const LoadedBody* pair = &bodies_[1 + drive_bodies_ + 2 * i];
    solve_dyad(dyads_[i], pair[0], pair[1], reactions.subspan(of_drive + 3 * i).first<3>());
  }
  forces.drive = std::visit(
      [&](const auto& member) {
        return solve_drive(member, reactions.first(of_drive + 3 * with_drive));
      },
      drive_);
  // What the frame requires for its rest is the opposite of what it receives.
  forces.shaking_force = -bodies_[0].required.force;
  forces.shaking_moment = -bodies_[0].required.moment;
  return std::isfinite(forces.drive) && std::isfinite(forces.shaking_force.x) &&
         std::isfinite(forces.shaking_force.y) && std::isfinite(forces.shaking_moment);
}

}  // namespace cognate
