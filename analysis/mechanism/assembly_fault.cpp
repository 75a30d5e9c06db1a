#include "analysis/mechanism/assembly_fault.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/mechanism/dyad_reach.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate {
namespace {

AssemblyFault fault_of(const Rrr<double>& dyad, const Reach& reach) {
  const double longer = std::max(dyad.first_length, dyad.second_length);
  const double shorter = std::min(dyad.first_length, dyad.second_length);
  // Which lies between longer − shorter and longer + shorter.
  if (reach.distance > longer) {
    return {AssemblyFaultKind::too_far_apart, 0, reach.distance, dyad.first_length,
            dyad.second_length};
  }
  return {AssemblyFaultKind::too_near, 0, reach.distance, longer, shorter};
}

AssemblyFault fault_of(const Rrp<double>& dyad, const Reach& reach) {
  return {AssemblyFaultKind::guide_too_far, 0, reach.distance, dyad.length, 0};
}

AssemblyFault fault_of(const Rpr<double>& /*dyad*/, const Reach& reach) {
  return {AssemblyFaultKind::inside_offset, 0, reach.distance, reach.least, 0};
}

AssemblyFault fault_of(const Prp<double>& /*dyad*/, const Reach& reach) {
  return {AssemblyFaultKind::parallel_guides, 0, reach.distance, 0, 0};
}

AssemblyFault fault_of(const Rpp<double>& /*dyad*/, const Reach& reach) {
  return {AssemblyFaultKind::parallel_guides, 0, reach.distance, 0, 0};
}

AssemblyFault fault_of(const Cylinder<double>& dyad, const Reach& reach) {
  const double length = reach.most - dyad.length;
  return fault_of(Rrr<double>{dyad.base, dyad.pivot, length, dyad.length}, reach);
}

AssemblyFault fault_of(const Group& /*group*/, const Reach& /*reach*/) {
  return {AssemblyFaultKind::group_open, 0, 0, 0, 0};
}

AssemblyFault fault_of(const GroupRest& /*rest*/, const Reach& /*reach*/) {
  return {AssemblyFaultKind::group_open, 0, 0, 0, 0};
}

bool is_placed(const BodyMotion<double, 0>& body) {
  return std::isfinite(body.direction.x) && std::isfinite(body.origin[0].x) &&
         std::isfinite(body.origin[0].y);
}

}  // namespace

std::optional<AssemblyFault> assembly_fault(const Mechanism<double>& mechanism, double drive,
                                            std::span<const double> sides) {
  MechanismMotion<0> motion(mechanism);
  std::ranges::copy(sides, motion.sides().begin());
  motion.move_to(drive);
  const bool is_rod = std::holds_alternative<DrivingRod<double>>(mechanism.drive);
  for (int i = 1; !is_rod && i <= drive_bodies(mechanism); ++i) {
    if (is_placed(motion.bodies()[static_cast<std::size_t>(i)])) continue;
    return AssemblyFault{AssemblyFaultKind::parallel_supports, -1, 0, 0, 0};
  }
  for (std::size_t i = 0; i < mechanism.dyads.size(); ++i) {
    const auto next = static_cast<std::size_t>(first_body(mechanism, static_cast<int>(i)));
    const bool is_group = std::holds_alternative<Group>(mechanism.dyads[i]);
    const bool closes = !is_group && motion.closures()[i].discriminant >= 0 &&
                        is_placed(motion.bodies()[next]) && is_placed(motion.bodies()[next + 1]);
    if (closes) continue;
    const Reach reach = cognate::reach(mechanism.dyads[i], motion.bodies().first(next), drive);
    AssemblyFault fault =
        std::visit([&](const auto& group) { return fault_of(group, reach); }, mechanism.dyads[i]);
    fault.dyad = static_cast<int>(i);
    return fault;
  }
  return std::nullopt;
}

std::optional<AssemblyFault> assembly_fault(const Mechanism<double>& mechanism, double drive) {
  return assembly_fault(mechanism, drive, sides(mechanism));
}

}  // namespace cognate
