#include "problems/cam/model.hpp"

#include <ceres/jet.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/varied_motion.hpp"

namespace cognate::problems {
namespace {

/// Derivatives by so many variables are found at a time.
constexpr int kStride = 4;
using Jet = ceres::Jet<double, kStride>;

/// By how much a base radius must exceed the roller's: the profile does not reach the shaft.
constexpr double kClearOfCentre = 1 + 1e-3;

template <class T>
T objective_value(CamObjective objective, const cam::CamSystem<T>& system,
                  const cam::FollowerMotion<T>& m) {
  using cam::CamQuantity;
  switch (objective) {
    case CamObjective::pressure_angle:
      return value_of(CamQuantity::pressure_angle, system, m);
    case CamObjective::contact_force:
      return value_of(CamQuantity::contact_force, system, m);
    case CamObjective::torque:
      return value_of(CamQuantity::torque, system, m);
    case CamObjective::contact_stress:
      return value_of(CamQuantity::squared_stress, system, m);
    case CamObjective::size:
      break;
  }
  return T(0);
}

/// Calls `evaluate(x, out)` on dual numbers, some variables at a time, and writes the derivatives
/// of the outputs row by row.
template <class Evaluate>
void differentiate(std::span<const double> x, std::size_t outputs, std::span<double> jacobian,
                   Evaluate evaluate) {
  std::vector<Jet> point(x.begin(), x.end()), out(outputs);
  for (std::size_t first = 0; first < x.size(); first += kStride) {
    const std::size_t count = std::min<std::size_t>(kStride, x.size() - first);
    for (std::size_t i = 0; i < x.size(); ++i) {
      point[i] = Jet(x[i]);
      if (i >= first && i < first + count) point[i].v[static_cast<int>(i - first)] = 1;
    }
    evaluate(std::span<const Jet>(point), std::span<Jet>(out));
    for (std::size_t row = 0; row < outputs; ++row) {
      for (std::size_t i = 0; i < count; ++i) {
        jacobian[row * x.size() + first + i] = out[row].v[static_cast<int>(i)];
      }
    }
  }
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

}  // namespace

CamModel::CamModel(const CamVariables& variables, CamPlaces places, double objective_unit)
    : variables_(variables), places_(std::move(places)), objective_unit_(objective_unit) {
  const CamProblem& problem = variables.problem();
  frees_angles_ = std::ranges::any_of(problem.free_motion, [](const auto& free) {
    return free.parameter == MotionParameter::over;
  });
  for (const FreeMotionParameter& free : problem.free_motion) {
    if (free.parameter == MotionParameter::over) continue;
    if (shared_.empty() || shared_.back() != free.segment) shared_.push_back(free.segment);
  }
  const Range& bounds = problem.length(CamDimension::base_radius).bounds;
  if (variables.frees(CamDimension::base_radius)) {
    bounds_ = int(bounds.min > 0) + int(std::isfinite(bounds.max));
  }
  rolls_ = problem.length(CamDimension::roller_radius).used;
  for (const LimitPlaces& limit : places_.limits) {
    all_.insert(all_.end(), limit.places.begin(), limit.places.end());
  }
  of_limits_ = all_.size();
  for (const FacePair& pair : places_.face) all_.insert(all_.end(), {pair.greatest, pair.least});
  all_.insert(all_.end(), places_.objective.begin(), places_.objective.end());
  if (!variables.frees_motion()) {
    const VariedMotion<double> motion(problem, {});
    for (const SegmentPlace& place : all_) still_.push_back(motion.at(place));
  }
}

int CamModel::residual_count() const {
  return variables_.problem().objective == CamObjective::size
             ? 1
             : static_cast<int>(places_.objective.size());
}

int CamModel::constraint_count() const {
  return static_cast<int>(of_limits_ + places_.face.size() + shared_.size()) + bounds_ +
         int(frees_angles_) + int(rolls_);
}

synthesis::Objective CamModel::objective() const {
  return variables_.problem().objective == CamObjective::size ? synthesis::Objective::sum_of_squares
                                                              : synthesis::Objective::max_abs;
}

template <class T>
std::vector<cam::FollowerMotion<T>> CamModel::motions(std::span<const T> x) const {
  std::vector<cam::FollowerMotion<T>> all;
  all.reserve(all_.size());
  if (variables_.frees_motion()) {
    const auto& problem = variables_.problem();
    const VariedMotion<T> motion(problem, x.subspan(x.size() - problem.free_motion.size()));
    for (const SegmentPlace& place : all_) all.push_back(motion.at(place));
  } else {
    for (const auto& m : still_) {
      all.push_back({T(m.displacement), T(m.velocity), T(m.acceleration), T(m.jerk)});
    }
  }
  return all;
}

/// One turn less the angles of all segments, in turns.
template <class T>
T CamModel::angles_left(std::span<const T> x) const {
  const CamProblem& problem = variables_.problem();
  double fixed = kTurn;
  for (const auto& segment : problem.motion) fixed -= segment.over;
  T left(fixed);
  std::size_t place = x.size() - problem.free_motion.size();
  for (const FreeMotionParameter& free : problem.free_motion) {
    if (free.parameter == MotionParameter::over) {
      left = left + T(problem.motion[free.segment].over) - x[place];
    }
    ++place;
  }
  return left * T(1 / kTurn);
}

template <class T>
T CamModel::share_left(std::size_t segment, std::span<const T> x) const {
  const CamProblem& problem = variables_.problem();
  const auto& shape = problem.motion[segment].shape;
  T shares[] = {T(shape.sine), T(shape.constant), T(shape.cosine)};
  std::size_t place = x.size() - problem.free_motion.size();
  for (const FreeMotionParameter& free : problem.free_motion) {
    const T& value = x[place++];
    if (free.segment != segment || free.parameter == MotionParameter::over) continue;
    shares[static_cast<int>(free.parameter) - static_cast<int>(MotionParameter::sine)] = value;
  }
  return T(1) - shares[0] - shares[1] - shares[2];
}

template <class T>
void CamModel::evaluate_constraints(std::span<const T> x, std::span<T> c) const {
  const CamProblem& problem = variables_.problem();
  const double unit = variables_.unit();
  const auto system = variables_.system(x);
  const auto motion = motions(x);
  std::size_t k = 0;
  if (frees_angles_) c[k++] = angles_left(x);
  for (const std::size_t segment : shared_) c[k++] = share_left(segment, x);
  if (rolls_) {
    const auto& d = system.follower.dimensions;
    c[k++] = (d.base_radius - T(kClearOfCentre) * d.roller_radius) * T(1 / unit);
  }
  if (bounds_ > 0) {
    const Range& bounds = problem.length(CamDimension::base_radius).bounds;
    const T& base = system.follower.dimensions.base_radius;
    if (bounds.min > 0) c[k++] = (base - T(bounds.min)) * T(1 / unit);
    if (std::isfinite(bounds.max)) c[k++] = (T(bounds.max) - base) * T(1 / unit);
  }
  std::size_t place = 0;
  for (const LimitPlaces& limit : places_.limits) {
    for (std::size_t i = 0; i < limit.places.size(); ++i) {
      c[k++] = margin(limit.limit, system, motion[place++], unit);
    }
  }
  for (std::size_t i = 0; i < places_.face.size(); ++i, place += 2) {
    const T width = value_of(cam::CamQuantity::reach, system, motion[place]) -
                    value_of(cam::CamQuantity::reach, system, motion[place + 1]);
    c[k++] = T(1) - width * T(1 / *problem.constraints.face_width_max);
  }
}

template <class T>
void CamModel::evaluate_residuals(std::span<const T> x, std::span<T> r) const {
  const CamProblem& problem = variables_.problem();
  const auto system = variables_.system(x);
  if (problem.objective == CamObjective::size) {
    r[0] = system.follower.dimensions.base_radius * T(1 / variables_.unit());
    return;
  }
  const auto motion = motions(x);
  const std::size_t first = all_.size() - places_.objective.size();
  for (std::size_t i = 0; i < places_.objective.size(); ++i) {
    r[i] = objective_value(problem.objective, system, motion[first + i]) * T(1 / objective_unit_);
  }
}

bool CamModel::residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                         std::span<double>) const {
  evaluate_residuals<double>(x, r);
  if (!jacobian.empty()) {
    differentiate(x, r.size(), jacobian, [this](std::span<const Jet> point, std::span<Jet> out) {
      evaluate_residuals<Jet>(point, out);
    });
  }
  return all_finite(r) && all_finite(jacobian);
}

void CamModel::constraints(std::span<const double> x, std::span<double> c,
                           std::span<double> jacobian) const {
  evaluate_constraints<double>(x, c);
  if (!jacobian.empty()) {
    differentiate(x, c.size(), jacobian, [this](std::span<const Jet> point, std::span<Jet> out) {
      evaluate_constraints<Jet>(point, out);
    });
  }
  // A follower that cannot be put together keeps no limit.
  for (double& value : c) value = std::isfinite(value) ? value : -1;
  for (double& value : jacobian) value = std::isfinite(value) ? value : 0;
}

}  // namespace cognate::problems
