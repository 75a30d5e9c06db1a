#include "problems/guidance/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/closure.hpp"
#include "problems/guidance/dimensions.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

SecondDyad second_of(const std::array<double, MotionModel::dimensions>& v) {
  SecondDyad second;
  std::copy_n(v.begin() + kSecond, second.size(), second.begin());
  return second;
}

}  // namespace

Lengths<double> lengths_of(const DyadPair& pair) {
  return {pair.first.length, norm(pair.second.in_body - pair.first.in_body), pair.second.length,
          norm(pair.second.fixed - pair.first.fixed)};
}

MotionForm form_of(const MotionProblem& problem, const DyadPair& pair) {
  MotionForm form{pair.second.kind, {}, std::nullopt, {}};
  const SecondDyad second = second_dyad(pair.second);
  double sum = 0;
  for (const Pose& pose : problem.poses) {
    const Vec2d pin = to_frame(pose, pair.first.in_body);
    const auto condition = turn_condition(form.second, second, pair.first.in_body, pin);
    form.sides.push_back(cross(conj(condition.k), unit_vector(pose.angle)) < 0 ? -1 : 1);
    sum += form.sides.back();
  }
  if (problem.constraints.no_branch_defect || problem.constraints.no_circuit_defect) {
    std::ranges::fill(form.sides, sum < 0 ? -1 : 1);
  }
  if (form.second == DyadKind::rr) {
    form.confined_to = confining_class(problem.constraints, lengths_of(pair));
  }
  return form;
}

namespace {

Constraints on_lengths(const MotionProblem& problem, const MotionForm& form) {
  if (form.second != DyadKind::rr) return {};
  Constraints constraints = problem.constraints;
  constraints.required_class = form.confined_to;
  return constraints;
}

}  // namespace

MotionModel::MotionModel(const MotionProblem& problem, MotionForm form)
    : problem_(problem),
      form_(std::move(form)),
      linkage_constraints_(on_lengths(problem, form_), 1.0),
      cycle_limits_(on_lengths(problem, form_), CycleOutput::coupler_point) {
  list_variables();
  list_distance_limits();
  list_stations();
}

bool MotionModel::limits_driven_range() const {
  const Constraints& constraints = problem_.constraints;
  const bool turns = form_.confined_to == RequiredClass::crank_rocker ||
                     form_.confined_to == RequiredClass::double_crank;
  return form_.second == DyadKind::rr && constraints.transmission_angle && !turns &&
         (constraints.no_order_defect || constraints.no_circuit_defect);
}

/// The angles at both ends are global variables where limits refer to them.
void MotionModel::list_stations() {
  std::size_t count = 0;
  for (std::size_t j = 0; j < problem_.poses.size(); ++j)
    count = std::max(count, station_of(j) + 1);
  const auto [first, last] =
      form_.ends.value_or(std::pair(station_of(0), station_of(problem_.poses.size() - 1)));
  const bool has_ends = !form_.stations.empty() && first != last && limits_driven_range();
  if (has_ends) driven_range_ = DrivenRange(problem_.constraints, {0, 0});
  std::vector<int> local(count, -1);
  std::size_t next = free_.size() + (has_ends ? 2 : 0);
  for (std::size_t k = 0; k < count; ++k) {
    if (held(k)) {
      variable_of_station_.push_back(kHeld);
      continue;
    }
    const bool is_end = has_ends && (k == first || k == last);
    if (!is_end) local[k] = local_count_++;
    variable_of_station_.push_back(is_end ? free_.size() + (k == last ? 1 : 0) : next++);
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (held(k)) continue;
    variables_.push_back({"crank angle " + std::to_string(k), -1e3 * kTurn, 1e3 * kTurn, 1});
  }
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    local_of_residual_.insert(local_of_residual_.end(), 3, local[station_of(j)]);
  }
}

std::vector<double> MotionModel::station_angles(std::span<const double> x) const {
  const Full v = full(x);
  std::vector<double> angles(station_count());
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    const std::size_t k = station_of(j), variable = variable_of_station_[k];
    if (variable != kHeld) {
      angles[k] = x[variable];
    } else if (const auto at = dead_station(v, *held(k), form_.sides[j])) {
      angles[k] = at->crank_angle;
    }
  }
  return angles;
}

std::vector<double> MotionModel::angle_slopes(std::span<const double> x) const {
  const auto rows = static_cast<std::size_t>(residual_count());
  const auto n = static_cast<std::size_t>(global_count());
  std::vector<double> r(rows), jacobian(rows * n), local(rows);
  if (!residuals(x, r, jacobian, local)) return {};
  std::vector<double> slopes(problem_.poses.size(), 0.0);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t variable = variable_of_station_[station_of(row / 3)];
    const double slope = variable < n ? jacobian[row * n + variable] : local[row];
    slopes[row / 3] += 2 * r[row] * slope;
  }
  return slopes;
}

std::vector<double> MotionModel::with_angles(std::span<const double> x,
                                             std::span<const double> station_angles) const {
  std::vector<double> with(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(free_.size()));
  with.resize(variables_.size());
  for (std::size_t k = 0; k < station_angles.size(); ++k) {
    if (variable_of_station_[k] != kHeld) with[variable_of_station_[k]] = station_angles[k];
  }
  return with;
}

MotionModel::Full MotionModel::full(std::span<const double> x) const {
  Full v = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) v[static_cast<std::size_t>(free_[i])] = x[i];
  return v;
}

std::optional<MotionModel::Station> MotionModel::station(const Full& v, std::size_t pose,
                                                         double crank_angle) const {
  const Vec2d crank = unit_vector(crank_angle);
  const Vec2d pin = point(v, kFixed1) + v[kLength1] * crank;
  const auto condition = turn_condition(form_.second, second_of(v), point(v, kMoving1), pin);
  if (!(condition.discriminant() > 0)) return std::nullopt;
  return Station{crank, pin, condition.turn(form_.sides[pose])};
}

const std::optional<HeldDeadPoint>& MotionModel::held(std::size_t station) const {
  static const std::optional<HeldDeadPoint> none;
  return form_.held.empty() ? none : form_.held[station];
}

std::optional<MotionModel::Station> MotionModel::station_of_pose(std::span<const double> x,
                                                                 const Full& v,
                                                                 std::size_t pose) const {
  const std::size_t k = station_of(pose);
  if (!held(k)) return station(v, pose, x[variable_of_station_[k]]);
  const auto at = dead_station(v, *held(k), form_.sides[pose]);
  if (!at) return std::nullopt;
  return Station{unit_vector(at->crank_angle), at->pin, at->turn};
}

/// The rows of a pose whose station is held: the body stands where the dimensions say.
void MotionModel::set_slopes_of_held(const DeadStation& at, const Vec2d& arm, std::size_t pose,
                                     std::span<double> jacobian, std::span<double> local) const {
  const auto n = static_cast<std::size_t>(global_count());
  for (std::size_t i = 0; i < n; ++i) {
    Vec2d place{};
    double turned = 0;
    if (i < free_.size()) {
      const auto dimension = static_cast<std::size_t>(free_[i]);
      turned = at.turn_slopes[dimension];
      place = at.pin_slopes[dimension] - turned * perp(arm);
      if (dimension == kMoving1) place = place - at.turn;
      if (dimension == kMoving1 + 1) place = place - perp(at.turn);
    }
    jacobian[(3 * pose) * n + i] = place.x;
    jacobian[(3 * pose + 1) * n + i] = place.y;
    jacobian[(3 * pose + 2) * n + i] = problem_.angle_weight * turned;
  }
  if (!local.empty()) std::fill_n(local.begin() + static_cast<std::ptrdiff_t>(3 * pose), 3, 0.0);
}

bool MotionModel::residuals(std::span<const double> x, std::span<double> r,
                            std::span<double> jacobian, std::span<double> local) const {
  const Full v = full(x);
  const Vec2d first = point(v, kMoving1);
  const SecondDyad second = second_of(v);
  const double weight = problem_.angle_weight;
  const auto n = static_cast<std::size_t>(global_count());
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    const std::size_t angle_variable = variable_of_station_[station_of(j)];
    const auto at = station_of_pose(x, v, j);
    if (!at) return false;
    const Vec2d arm = at->turn * first;
    const Vec2d miss = at->pin - arm - problem_.poses[j].at;
    r[3 * j] = miss.x;
    r[3 * j + 1] = miss.y;
    r[3 * j + 2] = weight * angle_of(at->turn * conj(unit_vector(problem_.poses[j].angle)));
    if (jacobian.empty() && local.empty()) continue;
    if (angle_variable == kHeld) {
      set_slopes_of_held(*dead_station(v, *held(station_of(j)), form_.sides[j]), arm, j, jacobian,
                         local);
      continue;
    }

    const TurnSlopes slopes = turn_slopes(form_.second, second, first, at->pin, at->turn);
    // The body's angle by each dimension: −F'/F'ψ; the pin's way, and the arm's apart from turning.
    const Vec2d by_crank = v[kLength1] * perp(at->crank);
    Full angle{slopes.first.x, slopes.first.y, slopes.pin.x, slopes.pin.y,
               dot(slopes.pin, at->crank)};
    std::ranges::copy(slopes.second, angle.begin() + kSecond);
    const std::array<Vec2d, kSecond> straight{-at->turn, -perp(at->turn), Vec2d{1, 0}, Vec2d{0, 1},
                                              at->crank};
    const auto set = [&](double turned, const Vec2d& way, auto&& store) {
      const Vec2d place = way - turned * perp(arm);
      store(0, place.x);
      store(1, place.y);
      store(2, weight * turned);
    };
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const auto dimension = static_cast<std::size_t>(free_[i]);
      set(-angle[dimension] / slopes.turn,
          dimension < straight.size() ? straight[dimension] : Vec2d{},
          [&](std::size_t row, double value) { jacobian[(3 * j + row) * n + i] = value; });
    }
    for (std::size_t i = free_.size(); i < n; ++i) {
      for (std::size_t row = 0; row < 3; ++row) jacobian[(3 * j + row) * n + i] = 0;
    }
    const bool is_end = angle_variable < n;
    set(-dot(slopes.pin, by_crank) / slopes.turn, by_crank, [&](std::size_t row, double value) {
      if (is_end) jacobian[(3 * j + row) * n + angle_variable] = value;
      if (!local.empty()) local[3 * j + row] = is_end ? 0 : value;
    });
  }
  return true;
}

MotionModel::Full MotionModel::dimensions_of(const DyadPair& pair) const {
  const GuidingDyad& first = pair.first;
  Full v{first.in_body.x, first.in_body.y, first.fixed.x, first.fixed.y, first.length};
  std::ranges::copy(second_dyad(pair.second), v.begin() + kSecond);
  Full confined = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const auto dimension = static_cast<std::size_t>(free_[i]);
    confined[dimension] = std::clamp(v[dimension], variables_[i].lower, variables_[i].upper);
  }
  return confined;
}

/// The crank angle at which the pin is nearest to where the pose has it, or, where the mechanism
/// does not close there, the first beside it at which it does.
double MotionModel::nearest_crank_angle(const Full& v, std::size_t pose) const {
  constexpr int kSteps = 120;
  const double wanted =
      angle_of(to_frame(problem_.poses[pose], point(v, kMoving1)) - point(v, kFixed1));
  for (int step = 0; step <= kSteps; ++step) {
    for (const double sense : {1.0, -1.0}) {
      const double angle = wanted + sense * 0.5 * kTurn * step / kSteps;
      if (station(v, pose, angle)) return angle;
    }
  }
  return wanted;
}

std::vector<double> MotionModel::variables_of(const DyadPair& pair) const {
  const Full v = dimensions_of(pair);
  std::vector<double> x;
  for (const int dimension : free_) x.push_back(v[static_cast<std::size_t>(dimension)]);
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    x.push_back(nearest_crank_angle(v, j));
  }
  return x;
}

DyadPair MotionModel::pair(std::span<const double> x) const {
  const Full v = full(x);
  const Pose& first = problem_.poses.front();
  const Vec2d moving = point(v, kMoving1), fixed = point(v, kFixed1);
  return {guiding_dyad(DyadKind::rr, {moving.x, moving.y, fixed.x, fixed.y, v[kLength1]}, first),
          guiding_dyad(form_.second, second_of(v), first)};
}

std::optional<Pose> MotionModel::body_at(std::span<const double> x, double crank_angle) const {
  const Full v = full(x);
  const auto at = station(v, 0, crank_angle);
  if (!at) return std::nullopt;
  return Pose{at->pin - at->turn * point(v, kMoving1), angle_of(at->turn)};
}

std::vector<Pose> MotionModel::reached(std::span<const double> x) const {
  const Full v = full(x);
  std::vector<Pose> poses;
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    const auto at = station_of_pose(x, v, j);
    if (!at) return {};
    poses.push_back({at->pin - at->turn * point(v, kMoving1), angle_of(at->turn)});
  }
  return poses;
}

}  // namespace cognate::problems
