#include "problems/cam/read_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems::reading {
namespace {

using cam::FollowerType;

constexpr std::string_view kBase = "base_radius";

bool is_positive(const std::optional<double>& value) {
  return value && *value > 0;
}

bool is_free(const CamProblem& problem, CamDimension dimension) {
  const CamLength& length = problem.length(dimension);
  return length.used && !length.given;
}

// Whether it is given, or has bounds, of which neither allows it to vanish.
bool stays_above_zero(const CamProblem& problem, CamDimension dimension) {
  const CamLength& length = problem.length(dimension);
  return length.used && (length.given ? *length.given > 0 : length.bounds.min > 0);
}

bool stays_finite(const CamProblem& problem, CamDimension dimension) {
  const CamLength& length = problem.length(dimension);
  return length.used && (length.given || std::isfinite(length.bounds.max));
}

bool has_pressure_limit(const CamConstraints& c) {
  return c.pressure_angle_max || c.pressure_angle_max_rise || c.pressure_angle_max_return ||
         c.pressure_angle_max_rise_working || c.pressure_angle_max_return_working;
}

// Limits that are lengths, below which the profile may not go.
bool has_least_radius(const CamConstraints& c) {
  return is_positive(c.curvature_radius_min) || c.profile_radius_min.has_value();
}

// The force on a sliding face is what the motion demands, for any size of the cam.
bool has_force_by_size(const CamProblem& problem) {
  return problem.follower != FollowerType::translating_flat;
}

bool has_force_limit(const CamProblem& problem) {
  const CamConstraints& c = problem.constraints;
  return c.contact_stress_max || (c.contact_force_max && has_force_by_size(problem));
}

// A small cam bends sharply: a face or a roller of some size would undercut it.
bool has_undercut_limit(const CamProblem& problem) {
  if (!problem.constraints.curvature_radius_min) return false;
  return is_flat(problem.follower) || stays_above_zero(problem, CamDimension::roller_radius);
}

bool may_shrink(const CamProblem& problem) {
  const CamConstraints& c = problem.constraints;
  if (problem.objective != CamObjective::size || !is_free(problem, CamDimension::base_radius)) {
    return false;
  }
  if (stays_above_zero(problem, CamDimension::base_radius)) return false;
  const bool pressed = has_pressure_limit(c) && !is_flat(problem.follower);
  return !pressed && !has_least_radius(c) && !has_undercut_limit(problem) &&
         !has_force_limit(problem);
}

// An oscillating follower's angles say nothing of lengths: one must.
bool lacks_length(const CamProblem& problem) {
  if (!is_oscillating(problem.follower)) return false;
  const auto says = [&](const auto& d) {
    const CamLength& length = problem.length(d.value);
    return stays_above_zero(problem, d.value) ||
           (length.used && length.given && *length.given != 0);
  };
  const CamConstraints& c = problem.constraints;
  return std::ranges::none_of(names<CamDimension>(), says) && !has_least_radius(c) &&
         !c.concave_radius_min && !has_force_limit(problem);
}

// The larger the cam, the less it slopes and presses.
bool may_grow(const CamProblem& problem) {
  const CamObjective objective = problem.objective;
  const bool shrinks_with_size =
      objective == CamObjective::pressure_angle ||
      (objective == CamObjective::contact_force && has_force_by_size(problem)) ||
      objective == CamObjective::contact_stress;
  if (!shrinks_with_size || !is_free(problem, CamDimension::base_radius)) return false;
  return !stays_finite(problem, CamDimension::base_radius) &&
         !stays_finite(problem, CamDimension::centre_distance) &&
         !problem.constraints.profile_radius_max;
}

}  // namespace

void check_cam_size(TableReader& mechanism, const CamProblem& problem) {
  if (lacks_length(problem)) {
    mechanism.fault(
        kBase,
        "is free and so is every other length, and angles alone do not say how large "
        "a cam is; expected one of base_radius, centre_distance and arm, or a lower bound of "
        "one");
    return;
  }
  if (may_shrink(problem)) {
    mechanism.fault(kBase,
                    "is free, and nothing keeps this cam from shrinking to nothing; give a limit "
                    "on the pressure angle (but for flat faces), curvature_radius_min, "
                    "profile_radius_min, the roller's radius with no_undercut, or a lower bound");
  }
  if (may_grow(problem)) {
    mechanism.fault(
        kBase,
        "is free, and the objective is the less the larger the cam is; expected an upper "
        "bound, bounds.base_radius or constraints.profile_radius_max");
  }
}

}  // namespace cognate::problems::reading
