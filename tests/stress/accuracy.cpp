#include "tests/stress/accuracy.hpp"

#include <algorithm>

namespace cognate::stress {
namespace {

/// The coupler point as the kernel's users compute it, over its size.
double point_error(const Configuration& at, const ExactClosure& exact, const Answer& answer) {
  const Vec2d crank = at.links.crank * rounded_crank(at.half_crank);
  return distance(crank + answer.coupler * at.coupler_point, exact.point) / exact.size;
}

}  // namespace

void Accuracy::include_error(double error_here, double condition_here) {
  error = std::max(error, error_here);
  condition = std::max(condition, condition_here);
  if (condition_here <= kWell) {
    well_conditioned = std::max(well_conditioned, error_here);
  } else {
    per_condition = std::max(per_condition, error_here / condition_here);
  }
}

void Accuracy::include_flag(bool should_close, bool closes, double boundary_distance) {
  ++total;
  closed += should_close;
  if (should_close == closes) return;
  ++wrong_flags;
  wrong_flag_distance = std::max(wrong_flag_distance, boundary_distance);
}

void Accuracy::include(const Configuration& at, const ExactClosure& exact, const Answer& answer) {
  include_flag(exact.closes, answer.closes, exact.boundary_distance);
  if (!exact.closes || !answer.closes) return;
  include_error(distance(answer.coupler, exact.coupler), exact.coupler_condition);
  include_error(distance(answer.rocker, exact.rocker), exact.rocker_condition);
  include_error(point_error(at, exact, answer), exact.point_condition);
}

void Accuracy::include(const Accuracy& other) {
  error = std::max(error, other.error);
  well_conditioned = std::max(well_conditioned, other.well_conditioned);
  per_condition = std::max(per_condition, other.per_condition);
  condition = std::max(condition, other.condition);
  closed += other.closed;
  total += other.total;
  wrong_flags += other.wrong_flags;
  wrong_flag_distance = std::max(wrong_flag_distance, other.wrong_flag_distance);
}

}  // namespace cognate::stress
