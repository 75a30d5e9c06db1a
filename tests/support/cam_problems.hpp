/// @file Cam problems for tests: made by hand and drawn at random.
#pragma once

#include <cmath>
#include <optional>
#include <random>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/result.hpp"

namespace cognate {

inline cam::MotionSegment segment(cam::MotionLaw law, double over_deg, double rise = 0) {
  cam::MotionSegment made;
  made.law = law;
  made.over = over_deg * kDegree;
  made.rise = rise;
  return made;
}

/// Makes a length one that the follower has; without a value it is free.
inline void use(problems::CamProblem& problem, problems::CamDimension dimension,
                std::optional<double> value = {}) {
  const bool signed_length = dimension == problems::CamDimension::offset ||
                             dimension == problems::CamDimension::face_offset;
  problem.length(dimension) = {true, value, {signed_length ? -HUGE_VAL : 0, HUGE_VAL}};
}

inline problems::CamProblem translating_roller(std::optional<double> base,
                                               std::optional<double> offset,
                                               std::optional<double> roller) {
  problems::CamProblem problem;
  use(problem, problems::CamDimension::base_radius, base);
  use(problem, problems::CamDimension::offset, offset);
  use(problem, problems::CamDimension::roller_radius, roller);
  return problem;
}

inline problems::CamProblem oscillating_roller(std::optional<double> base,
                                               std::optional<double> centre_distance,
                                               std::optional<double> arm, double roller) {
  problems::CamProblem problem;
  problem.follower = cam::FollowerType::oscillating_roller;
  use(problem, problems::CamDimension::base_radius, base);
  use(problem, problems::CamDimension::centre_distance, centre_distance);
  use(problem, problems::CamDimension::arm, arm);
  use(problem, problems::CamDimension::roller_radius, roller);
  return problem;
}

/// A rise, perhaps a dwell, a return and a dwell, by laws without jumps of velocity.
inline std::vector<cam::MotionSegment> random_motion(std::mt19937_64& random, double stroke) {
  using cam::MotionLaw;
  constexpr MotionLaw kLaws[] = {MotionLaw::constant_acceleration,
                                 MotionLaw::harmonic,
                                 MotionLaw::cycloidal,
                                 MotionLaw::polynomial_345,
                                 MotionLaw::polynomial_4567,
                                 MotionLaw::modified_sine,
                                 MotionLaw::modified_trapezoid,
                                 MotionLaw::modified_constant_velocity};
  std::uniform_int_distribution<std::size_t> law(0, std::size(kLaws) - 1);
  std::uniform_real_distribution<double> angle(40, 150), dwell(0, 30);
  const double rise = angle(random), wait = dwell(random), fall = angle(random);
  std::vector<cam::MotionSegment> motion = {segment(kLaws[law(random)], rise, stroke)};
  if (wait > 5) motion.push_back(segment(MotionLaw::dwell, wait));
  motion.push_back(segment(kLaws[law(random)], fall, -stroke));
  motion.push_back(segment(MotionLaw::dwell, 360 - rise - fall - (wait > 5 ? wait : 0)));
  return motion;
}

}  // namespace cognate
