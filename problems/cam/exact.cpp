#include "problems/cam/exact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/cam/turn_extremes.hpp"
#include "problems/basics/degrees.hpp"
#include "synthesis/exact/cam/smallest_cam.hpp"

namespace cognate::problems {
namespace {

using cam::FollowerType;
using synthesis::PressureLimit;

bool is_free(const CamProblem& problem, CamDimension dimension) {
  const CamLength& length = problem.length(dimension);
  return length.used && !length.given;
}

double given(const CamProblem& problem, CamDimension dimension) {
  return problem.length(dimension).given.value_or(0);
}

synthesis::PressureLimits limits_of(const CamProblem& problem) {
  const CamConstraints& c = problem.constraints;
  return {c.pressure_angle_max, c.pressure_angle_max_rise, c.pressure_angle_max_return,
          c.pressure_angle_max_rise_working, c.pressure_angle_max_return_working};
}

/// What a proof takes for granted besides its positions.
std::string granted(const CamProblem& problem, const synthesis::SmallestCam& smallest) {
  if (is_oscillating(problem.follower)) {
    return fmt::format("arm = {:.10g}", given(problem, CamDimension::arm));
  }
  const CamLength& offset = problem.length(CamDimension::offset);
  if (offset.given) return fmt::format("offset = {:.10g}", *offset.given);
  if (!smallest.bound_binds) return {};
  return fmt::format("offset from {:.10g} to {:.10g}", offset.bounds.min, offset.bounds.max);
}

/// A limit's key in the file, and its value there.
std::pair<const char*, double> limit_of(const CamConstraints& c, PressureLimit limit) {
  switch (limit) {
    case PressureLimit::whole:
      return {"pressure_angle_deg_max", degrees(*c.pressure_angle_max)};
    case PressureLimit::rise:
      return {"pressure_angle_deg_max_rise", degrees(*c.pressure_angle_max_rise)};
    case PressureLimit::fall:
      return {"pressure_angle_deg_max_return", degrees(*c.pressure_angle_max_return)};
    case PressureLimit::rise_working:
      return {"pressure_angle_deg_max_rise_working", degrees(*c.pressure_angle_max_rise_working)};
    case PressureLimit::fall_working:
      return {"pressure_angle_deg_max_return_working",
              degrees(*c.pressure_angle_max_return_working)};
  }
  return {"", 0};
}

SizeProof proof_of(const CamProblem& problem, const synthesis::SmallestCam& smallest) {
  SizeProof proof{smallest.dimensions.base_radius, {}, granted(problem, smallest)};
  for (const auto& binding : smallest.binding) {
    const auto [key, bound] = limit_of(problem.constraints, binding.limit);
    proof.positions.push_back({binding.angle, key, bound});
  }
  return proof;
}

std::optional<ExactCam> exact_roller(const CamProblem& problem,
                                     const cam::MotionProgramme& programme) {
  const bool swings = has_arm(problem.follower);
  const CamLength& offset = problem.length(CamDimension::offset);
  const auto smallest =
      swings ? synthesis::smallest_oscillating(programme, limits_of(problem), problem.side,
                                               given(problem, CamDimension::arm))
             : synthesis::smallest_translating(programme, limits_of(problem),
                                               offset.given.value_or(offset.bounds.min),
                                               offset.given.value_or(offset.bounds.max));
  if (!smallest) return std::nullopt;
  ExactCam exact{smallest->dimensions, proof_of(problem, *smallest)};
  exact.dimensions.roller_radius = given(problem, CamDimension::roller_radius);
  return exact;
}

/// ρ = r₀ + s + s″ is least where s + s″ is.
ExactCam exact_face(const CamProblem& problem, const cam::MotionProgramme& programme) {
  const auto sharpest = turn_extremes(
      programme, cam::MotionPart::whole,
      [](const cam::FollowerMotion<double>& m) { return m.displacement + m.acceleration; });
  const double bound = problem.constraints.curvature_radius_min.value_or(0);
  ExactCam exact;
  exact.dimensions.offset = given(problem, CamDimension::offset);
  exact.dimensions.base_radius = std::max(0.0, bound - sharpest->least.value);
  exact.proof = {exact.dimensions.base_radius,
                 {{sharpest->least.place.angle, "curvature_radius_min", bound}},
                 {}};
  return exact;
}

bool frees_only_what_is_exact(const CamProblem& problem) {
  if (problem.objective != CamObjective::size || !problem.free_motion.empty()) return false;
  if (!is_free(problem, CamDimension::base_radius)) return false;
  const bool arm = is_free(problem, CamDimension::arm);
  switch (problem.follower) {
    case FollowerType::oscillating_roller:
    case FollowerType::oscillating_knife:
      return !arm && is_free(problem, CamDimension::centre_distance);
    case FollowerType::oscillating_flat:
      return false;
    default:
      return true;
  }
}

}  // namespace

std::optional<ExactCam> exact_cam(const CamProblem& problem,
                                  const cam::MotionProgramme& programme) {
  if (!frees_only_what_is_exact(problem)) return std::nullopt;
  if (problem.follower == FollowerType::translating_flat) {
    if (!problem.constraints.curvature_radius_min) return std::nullopt;
    return exact_face(problem, programme);
  }
  if (!limits_of(problem).any()) return std::nullopt;
  return exact_roller(problem, programme);
}

}  // namespace cognate::problems
