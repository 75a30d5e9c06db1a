#include "problems/cam/variables.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "analysis/cam/universal_law.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"

namespace cognate::problems {
namespace {

/// How many typical lengths a free one may measure where the file does not bound it.
constexpr double kFarthest = 1e3;
/// The least length and angle of a variable, in typical ones.
constexpr double kLeast = 1e-6;

/// The greatest displacement of the motion's segments, or 1 radian's worth.
double greatest_rise(const CamProblem& problem) {
  double level = 0, greatest = 0;
  for (const auto& segment : problem.motion) {
    level += segment.rise;
    greatest = std::max({greatest, std::abs(level), std::abs(segment.rise)});
    for (const auto& point : segment.points) {
      greatest = std::max(greatest, std::abs(point.displacement));
    }
  }
  return greatest;
}

/// A length that the file gives or bounds, else that of the rise: what free lengths are measured
/// by.
double typical_length(const CamProblem& problem) {
  double greatest = is_oscillating(problem.follower) ? 0 : greatest_rise(problem);
  for (const CamLength& length : problem.lengths) {
    if (!length.used) continue;
    if (length.given) greatest = std::max(greatest, std::abs(*length.given));
    if (length.bounds.min > 0) greatest = std::max(greatest, length.bounds.min);
  }
  const auto& c = problem.constraints;
  for (const auto& limit : {c.curvature_radius_min, c.profile_radius_min, c.profile_radius_max}) {
    if (limit && std::isfinite(*limit)) greatest = std::max(greatest, *limit);
  }
  return greatest > 0 ? greatest : 1;
}

/// Shares that a solver's rounding brought above 1 together are made 1.
void keep_whole(cam::MotionSegment& segment) {
  constexpr double kRounding = 1e-6;
  auto& [sine, constant, cosine] = segment.shape;
  const double sum = sine + constant + cosine;
  if (sum <= 1 || sum > 1 + kRounding) return;
  for (double* share : {&sine, &constant, &cosine}) *share /= sum;
}

bool is_possible(const cam::Cam& cam) {
  const auto& d = cam.system.follower.dimensions;
  return std::isfinite(cam.system.start) && std::isfinite(d.base_radius) && d.base_radius > 0;
}

}  // namespace

CamVariables::CamVariables(const CamProblem& problem)
    : problem_(&problem), unit_(typical_length(problem)) {
  std::ranges::fill(place_, -1);
  add_start();
  for (int i = 1; i < kCamDimensions; ++i) add_length(static_cast<CamDimension>(i));
  add_motion();
}

void CamVariables::add_start() {
  const CamLength& base = problem_->length(CamDimension::base_radius);
  if (base.given) return;
  place_[0] = 0;
  const bool angular = is_oscillating(problem_->follower);
  if (angular) {
    const double most = problem_->follower == cam::FollowerType::oscillating_flat ? 0.5 * kPi : kPi;
    variables_.push_back({"start", kLeast, most - kLeast, 1});
    return;
  }
  const double most = std::isfinite(base.bounds.max) ? base.bounds.max : kFarthest * unit_;
  variables_.push_back({"start", std::min(kLeast * unit_, most), most, unit_});
}

void CamVariables::add_length(CamDimension dimension) {
  const CamLength& length = problem_->length(dimension);
  if (!length.used || length.given) return;
  place_[static_cast<int>(dimension)] = static_cast<int>(variables_.size());
  double least = length.bounds.min, greatest = length.bounds.max;
  const bool positive = dimension != CamDimension::offset && dimension != CamDimension::face_offset;
  least = std::max(least, positive ? kLeast * unit_ : -kFarthest * unit_);
  greatest = std::min(greatest, kFarthest * unit_);
  if (dimension == CamDimension::offset) {
    const auto& base = problem_->length(CamDimension::base_radius).given;
    if (base) {
      least = std::max(least, -(1 - kLeast) * *base);
      greatest = std::min(greatest, (1 - kLeast) * *base);
    }
  }
  variables_.push_back(
      {std::string(to_string(dimension)), std::min(least, greatest), greatest, unit_});
}

void CamVariables::add_motion() {
  for (const FreeMotionParameter& free : problem_->free_motion) {
    variables_.push_back({"motion", free.range.min, free.range.max,
                          free.parameter == MotionParameter::over ? 1.0 : 0.25});
  }
}

std::vector<cam::MotionSegment> CamVariables::motion(std::span<const double> x) const {
  auto segments = problem_->motion;
  std::size_t place = variables_.size() - problem_->free_motion.size();
  for (const FreeMotionParameter& free : problem_->free_motion) {
    auto& segment = segments[free.segment];
    double* target[] = {&segment.over, &segment.shape.sine, &segment.shape.constant,
                        &segment.shape.cosine};
    const double value = x[place++];
    const bool nothing = free.parameter != MotionParameter::over && value < cam::kLeastShare;
    *target[static_cast<int>(free.parameter)] = nothing ? 0 : value;
  }
  for (const FreeMotionParameter& free : problem_->free_motion) keep_whole(segments[free.segment]);
  return segments;
}

std::vector<double> CamVariables::values(const cam::CamDimensions<double>& d) const {
  const double lengths[] = {0, d.offset, d.roller_radius, d.centre_distance, d.arm, d.face_offset};
  std::vector<double> x(variables_.size());
  for (int i = 0; i < kCamDimensions; ++i) {
    if (place_[i] >= 0) x[static_cast<std::size_t>(place_[i])] = lengths[i];
  }
  if (frees(CamDimension::base_radius)) {
    x[0] = starting_place(cam::CamFollower<double>{problem_->follower, problem_->side, d});
  }
  std::size_t place = variables_.size() - problem_->free_motion.size();
  for (const FreeMotionParameter& free : problem_->free_motion) {
    const auto& segment = problem_->motion[free.segment];
    const double value[] = {segment.over, segment.shape.sine, segment.shape.constant,
                            segment.shape.cosine};
    x[place++] = value[static_cast<int>(free.parameter)];
  }
  return x;
}

std::optional<cam::Cam> cam_at(const CamVariables& variables, std::span<const double> x) {
  auto programme = programme_of(variables.motion(x));
  if (!programme) return std::nullopt;
  cam::Cam made{variables.system<double>(x), *std::move(programme)};
  if (!is_possible(made)) return std::nullopt;
  return made;
}

}  // namespace cognate::problems
