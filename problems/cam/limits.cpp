#include "problems/cam/limits.hpp"

#include <initializer_list>

namespace cognate::problems {
namespace {

void add_pressure(const CamConstraints& c, std::vector<CamLimit>& limits) {
  using cam::MotionPart;
  const auto add = [&](MotionPart stretch, const std::optional<double>& most,
                       std::initializer_list<double> signs) {
    if (!most) return;
    for (const double sign : signs) {
      limits.push_back({CamLimitKind::pressure, stretch, *most, sign});
    }
  };
  add(MotionPart::whole, c.pressure_angle_max, {1, -1});
  add(MotionPart::rises, c.pressure_angle_max_rise, {1, -1});
  add(MotionPart::falls, c.pressure_angle_max_return, {1, -1});
  add(MotionPart::rises, c.pressure_angle_max_rise_working, {1});
  add(MotionPart::falls, c.pressure_angle_max_return_working, {-1});
}

/// The limit of the file; where stress counts no undercut at least, which has no stress.
std::optional<double> least_convex_radius(const CamProblem& problem) {
  const bool stressed =
      problem.constraints.contact_stress_max || problem.objective == CamObjective::contact_stress;
  const auto& radius = problem.constraints.curvature_radius_min;
  return !radius && stressed ? 0.0 : radius;
}

void add_shape(const CamProblem& problem, std::vector<CamLimit>& limits) {
  const CamConstraints& c = problem.constraints;
  const auto add = [&](CamLimitKind kind, const std::optional<double>& bound) {
    if (bound) limits.push_back({kind, cam::MotionPart::whole, *bound, 1});
  };
  const bool flat = is_flat(problem.follower);
  add(flat ? CamLimitKind::face_radius : CamLimitKind::convex_radius, least_convex_radius(problem));
  if (!flat) add(CamLimitKind::concave_radius, c.concave_radius_min);
  if (problem.second.closure == cam::Closure::groove && c.curvature_radius_min) {
    add(CamLimitKind::outer_wall, c.curvature_radius_min);
  }
  add(CamLimitKind::profile_min, c.profile_radius_min);
  add(CamLimitKind::profile_max, c.profile_radius_max);
}

/// A force that is typical of the operation: what separation is relative to.
double typical_demand(const CamProblem& problem) {
  const cam::Operation& o = problem.operation;
  double rise = 0, sharpest = 0;
  for (const auto& segment : problem.motion) {
    rise = std::max(rise, std::abs(segment.rise));
    sharpest = std::max(sharpest, std::abs(segment.rise) / (segment.over * segment.over));
  }
  const double size = std::abs(o.inertia * o.speed * o.speed * o.displacement * sharpest) +
                      std::abs(o.spring_rate * rise) + std::abs(o.preload) + std::abs(o.load);
  return size > 0 ? size : 1;
}

/// What depends on the motion alone: no length could mend it.
void add_motion_limits(const CamProblem& problem, std::vector<CamLimit>& limits) {
  const CamConstraints& c = problem.constraints;
  const auto add = [&](CamLimitKind kind, double bound, double sign = 1) {
    limits.push_back({kind, cam::MotionPart::whole, bound, sign});
  };
  if (problem.has_operation && problem.preload && c.no_separation &&
      problem.second.closure == cam::Closure::force) {
    add(CamLimitKind::separation, typical_demand(problem));
  }
  if (c.torque_max) {
    add(CamLimitKind::torque, *c.torque_max, 1);
    add(CamLimitKind::torque, *c.torque_max, -1);
  }
}

void add_forces(const CamProblem& problem, std::vector<CamLimit>& limits) {
  const CamConstraints& c = problem.constraints;
  const auto add = [&](CamLimitKind kind, double bound, double sign = 1) {
    limits.push_back({kind, cam::MotionPart::whole, bound, sign});
  };
  if (c.contact_force_max) {
    add(CamLimitKind::force, *c.contact_force_max);
    if (problem.second.closure != cam::Closure::force) {
      add(CamLimitKind::force, *c.contact_force_max, -1);
    }
  }
  if (c.contact_stress_max) {
    add(CamLimitKind::stress, *c.contact_stress_max);
    if (problem.second.closure == cam::Closure::groove) {
      add(CamLimitKind::stress, *c.contact_stress_max, -1);
    }
  }
}

}  // namespace

std::vector<CamLimit> cam_limits(const CamProblem& problem) {
  std::vector<CamLimit> limits;
  add_pressure(problem.constraints, limits);
  add_shape(problem, limits);
  add_forces(problem, limits);
  if (!problem.free_motion.empty()) add_motion_limits(problem, limits);
  if (problem.follower != cam::FollowerType::translating_flat) {
    limits.push_back({CamLimitKind::assembly, cam::MotionPart::whole, 0, 1});
  }
  return limits;
}

}  // namespace cognate::problems
