/// @file The unknowns of a cam problem, and the cam that their values make.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "analysis/cam/cam.hpp"
#include "analysis/cam/contact.hpp"
#include "analysis/cam/quantity.hpp"
#include "problems/cam/problem.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// The variables of a problem in this order: the lengths that are free, then the free parameters of
/// the motion. For a free base radius the variable is the follower's starting place instead
/// (`cam::starting_place`): of that the base radius is a smooth function, with no root that ends
/// where the offset reaches it.
class CamVariables {
 public:
  explicit CamVariables(const CamProblem& problem);

  const CamProblem& problem() const { return *problem_; }
  std::span<const synthesis::Variable> variables() const { return variables_; }
  bool frees_motion() const { return !problem_->free_motion.empty(); }
  bool frees(CamDimension dimension) const { return place_[static_cast<int>(dimension)] >= 0; }
  /// A length that is typical of the problem.
  double unit() const { return unit_; }

  /// The follower at `x` (as long as `variables()`). Its starting place is not finite where the
  /// lengths cannot be put together.
  template <class T>
  cam::CamSystem<T> system(std::span<const T> x) const;

  /// The motion's segments at `x`.
  std::vector<cam::MotionSegment> motion(std::span<const double> x) const;

  /// The values of the variables that make `dimensions`, the motion being that of the file.
  std::vector<double> values(const cam::CamDimensions<double>& dimensions) const;

 private:
  template <class T>
  T length(CamDimension dimension, std::span<const T> x) const {
    const int place = place_[static_cast<int>(dimension)];
    if (place >= 0) return x[static_cast<std::size_t>(place)];
    return T(problem_->length(dimension).given.value_or(0));
  }
  void add_length(CamDimension dimension);
  void add_start();
  void add_motion();

  const CamProblem* problem_;
  std::vector<synthesis::Variable> variables_;
  int place_[kCamDimensions];
  double unit_ = 1;
};

/// The cam at `x`; nothing where it cannot be put together or its motion has no pieces.
std::optional<cam::Cam> cam_at(const CamVariables& variables, std::span<const double> x);

/// The base radius of a follower that stands at `start` when its displacement is 0.
template <class T>
T base_radius_at(cam::FollowerType type, const cam::CamDimensions<T>& d, const T& start) {
  using std::sin;
  using std::sqrt;
  switch (type) {
    case cam::FollowerType::translating_flat:
      return start;
    case cam::FollowerType::oscillating_flat:
      return d.centre_distance * sin(start) - d.face_offset;
    case cam::FollowerType::oscillating_roller:
    case cam::FollowerType::oscillating_knife: {
      const T half = sin(T(0.5) * start);
      const T across = d.centre_distance - d.arm;
      return sqrt(across * across + T(4) * d.centre_distance * d.arm * half * half);
    }
    default:
      return sqrt(d.offset * d.offset + start * start);
  }
}

template <class T>
cam::CamSystem<T> CamVariables::system(std::span<const T> x) const {
  cam::CamSystem<T> made;
  made.follower.type = problem_->follower;
  made.follower.side = problem_->side;
  made.operation = problem_->operation;
  made.groove = problem_->second.closure == cam::Closure::groove;
  auto& d = made.follower.dimensions;
  d.offset = length(CamDimension::offset, x);
  d.roller_radius = length(CamDimension::roller_radius, x);
  d.centre_distance = length(CamDimension::centre_distance, x);
  d.arm = length(CamDimension::arm, x);
  d.face_offset = length(CamDimension::face_offset, x);
  const T base = length(CamDimension::base_radius, x);
  if (frees(CamDimension::base_radius)) {
    made.start = base;
    d.base_radius = base_radius_at(problem_->follower, d, base);
  } else {
    d.base_radius = base;
    made.start = starting_place(made.follower);
  }
  return made;
}

}  // namespace cognate::problems
