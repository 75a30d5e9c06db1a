#include "problems/straight_line/model.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/straight_line/placing.hpp"

namespace cognate::problems {
namespace {

/// How far, in lengths of the segment, the point keeps from a slider's pin, which moves straight in
/// any case.
constexpr double kPinDistance = 0.1;

using Jet = ceres::Jet<double, 10>;

double value(double x) {
  return x;
}
double value(const Jet& x) {
  return x.a;
}

std::optional<double> direction_of(const StraightLineProblem& problem) {
  if (!limits_place(problem)) return problem.goal->direction;
  const Vec2d way = problem.goal->ends->back() - problem.goal->ends->front();
  return std::atan2(way.y, way.x);
}

Constraints with_class(Constraints constraints, std::optional<RequiredClass> required) {
  constraints.required_class = required;
  return constraints;
}

}  // namespace

std::optional<RequiredClass> class_of(const StraightLineProblem& problem,
                                      const LinkageSegment& start) {
  if (problem.type != MechanismType::four_bar) return problem.constraints.required_class;
  const auto& [crank, coupler, rocker, frame] = start.dimensions.links;
  return confining_class(problem.constraints, {crank, coupler, rocker, frame});
}

std::vector<double> segment_nodes(int cells) {
  std::vector<double> nodes(static_cast<std::size_t>(cells) + 1);
  for (int k = 0; k <= cells; ++k) {
    nodes[static_cast<std::size_t>(k)] = -std::cos(kPi * k / cells);
  }
  return nodes;
}

/// What the rows are made of: the points, their distance from the line, their place along it.
template <class T>
struct SegmentModel::Curve {
  std::vector<CouplerPoint<T>> points;
  std::vector<T> heights, places, speeds;
  T reach{};
  std::array<CouplerPoint<T>, 4> extremes;  ///< of the transmission angle, and both ends

  void reserve(std::size_t nodes) {
    points.reserve(nodes);
    for (auto* column : {&heights, &places, &speeds}) column->reserve(nodes);
  }
};

/// Writes constraints one after the other, with their derivatives by the free variables.
class SegmentModel::Rows {
 public:
  Rows(const SegmentModel& model, std::span<double> c, std::span<double> jacobian)
      : c_(c), jacobian_(jacobian) {
    column_.fill(-1);
    for (std::size_t i = 0; i < model.free_.size(); ++i) {
      column_[model.free_[i]] = static_cast<int>(i);
    }
    width_ = model.free_.size();
  }

  using Slopes = std::initializer_list<std::pair<Dimension, double>>;

  void add(double value, Slopes slopes = {}) {
    write(value);
    for (const auto& [dimension, slope] : slopes) add_slope(dimension, slope);
  }
  void add(const Jet& value, Slopes slopes = {}) {
    write(value.a);
    for (int d = 0; d < kMoving; ++d) add_slope(static_cast<Dimension>(d), value.v[d]);
    for (const auto& [dimension, slope] : slopes) add_slope(dimension, slope);
  }
  /// The rows that a linkage leaves which does not close.
  void fill() {
    while (row_ < static_cast<int>(c_.size())) write(-1);
  }
  int count() const { return row_; }

 private:
  void write(double value) {
    if (!c_.empty()) c_[static_cast<std::size_t>(row_)] = value;
    ++row_;
    if (jacobian_.empty()) return;
    const auto begin = jacobian_.begin() + static_cast<std::ptrdiff_t>((row_ - 1) * width_);
    std::fill(begin, begin + static_cast<std::ptrdiff_t>(width_), 0.0);
  }
  void add_slope(Dimension dimension, double slope) {
    if (jacobian_.empty() || column_[dimension] < 0) return;
    jacobian_[(row_ - 1) * width_ + static_cast<std::size_t>(column_[dimension])] += slope;
  }

  std::span<double> c_, jacobian_;
  std::array<int, dimension_count> column_;
  std::size_t width_ = 0;
  int row_ = 0;
};

SegmentModel::SegmentModel(const StraightLineProblem& problem, const LinkageSegment& start,
                           std::vector<double> nodes)
    : problem_(problem),
      objective_(objective_of(problem)),
      type_(problem.type),
      assembly_(sign(start.assembly)),
      class_(class_of(problem, start)),
      link_limits_(with_class(problem.constraints, class_), 1.0),
      nodes_(std::move(nodes)),
      direction_(direction_of(problem)),
      has_place_(limits_place(problem)) {
  list_links();
  list_segment(start);
  list_places();
  if (direction_) {
    const double off = start.frame_angle + start.line - *direction_;
    half_turns_ = kPi * std::round(off / kPi);
  }
  Rows rows(*this, {}, {});
  // Of a linkage that closes, whatever the start does: the number of rows is that of all.
  All closing{1, 3, 2, 3, 1, 1, 0, 0.1};
  closing[length] = closing[size] = 1;
  add_rows<double>(closing, rows);
  constraint_count_ = rows.count();
}

int SegmentModel::residual_count() const {
  return objective_ == SegmentObjective::deviation ? static_cast<int>(nodes_.size()) : 1;
}

synthesis::Objective SegmentModel::objective() const {
  return objective_ == SegmentObjective::deviation ? synthesis::Objective::max_abs
                                                   : synthesis::Objective::sum_of_squares;
}

template <class T>
bool SegmentModel::trace(const All& at, Curve<T>& curve) const {
  std::array<T, kMoving> z;
  for (int d = 0; d < kMoving; ++d) {
    if constexpr (std::is_same_v<T, double>) {
      z[d] = at[d];
    } else {
      z[d] = T(at[d], d);
    }
  }
  using std::cos;
  using std::sin;
  const Vec2<T> along{cos(z[line]), sin(z[line])};
  const CouplerMotion<T> motion(
      type_, {{z[crank], z[coupler], z[rocker], z[frame]}, {z[point_u], z[point_v]}}, assembly_);
  curve.reach = z[reach];
  curve.reserve(nodes_.size());
  for (const double node : nodes_) {
    curve.points.push_back(motion.at(z[centre] + T(node) * z[reach]));
    const CouplerPoint<T>& point = curve.points.back();
    if (!point.closes || !std::isfinite(value(point.rate.x)) || !std::isfinite(value(point.at.y))) {
      return false;
    }
    curve.heights.push_back(cross(along, point.at) - z[height]);
    curve.places.push_back(dot(along, point.at));
    curve.speeds.push_back(dot(along, point.rate));
  }
  const double first = type_ == MechanismType::four_bar ? 0 : kPi / 2;
  const auto extreme = [&](double angle) {
    // The direction that lies in the segment, or the end that is nearer to it.
    const double off = std::remainder(angle - value(z[centre]), kTurn);
    if (std::abs(off) < value(z[reach])) return motion.at(T(value(z[centre]) + off));
    return off > 0 ? curve.points.back() : curve.points.front();
  };
  curve.extremes = {curve.points.front(), curve.points.back(), extreme(first),
                    extreme(first + kPi)};
  return true;
}

bool SegmentModel::residuals(std::span<const double> x, std::span<double> r,
                             std::span<double> jacobian, std::span<double> /*local*/) const {
  const All at = dimensions(x);
  const double unit = 1 / at[length];
  const auto residuals_of = [&]<class T>(const Curve<T>& curve, Rows& rows) {
    switch (objective_) {
      case SegmentObjective::deviation:
        for (const T& h : curve.heights) {
          rows.add(unit * h, {{length, -value(h) * unit * unit}});
        }
        break;
      case SegmentObjective::length:
        rows.add(unit, {{length, -unit * unit}});
        break;
      case SegmentObjective::size:
        rows.add(at[size] * unit, {{size, unit}, {length, -at[size] * unit * unit}});
        break;
    }
  };
  Rows rows(*this, r, jacobian);
  if (jacobian.empty()) {
    Curve<double> curve;
    if (!trace(at, curve)) return false;
    residuals_of(curve, rows);
  } else {
    Curve<Jet> curve;
    if (!trace(at, curve)) return false;
    residuals_of(curve, rows);
  }
  return true;
}

void SegmentModel::constraints(std::span<const double> x, std::span<double> c,
                               std::span<double> jacobian) const {
  Rows rows(*this, c, jacobian);
  if (jacobian.empty()) {
    add_rows<double>(dimensions(x), rows);
  } else {
    add_rows<Jet>(dimensions(x), rows);
  }
  rows.fill();
}

template <class T>
void SegmentModel::add_rows(const All& at, Rows& rows) const {
  Curve<T> curve;
  if (!trace(at, curve)) return;
  const double unit = 1 / at[length];
  const T along = curve.places.back() - curve.places.front();
  rows.add(unit * along - T(1), {{length, -value(along) * unit * unit}});
  if (direction_) {
    rows.add(at[frame_angle] + at[line] - *direction_ - half_turns_, {{frame_angle, 1}, {line, 1}});
  }
  if (has_place_) add_place(curve, at, rows);
  if (objective_ != SegmentObjective::deviation) add_band(curve, at, rows);
  add_sizes(at, rows);
  add_links(at, rows);
  add_transmission(curve, rows);
  if (problem_.segment.speed_variation_max) add_speeds(curve, at, rows);
  add_pivot(at, rows);
}

/// The middle of the line, seen from A in the directions of the line, is the origin.
template <class T>
void SegmentModel::add_place(const Curve<T>& curve, const All& at, Rows& rows) const {
  const auto [x, y] = unit_vector(*direction_ + half_turns_);
  const T middle = T(0.5) * (curve.places.front() + curve.places.back());
  rows.add(T(x) * middle + T(at[pivot_x] - y * at[height]), {{pivot_x, 1.0}, {height, -y}});
  rows.add(T(y) * middle + T(at[pivot_y] + x * at[height]), {{pivot_y, 1.0}, {height, x}});
}

/// |h| ≤ δ, over the length where δ is relative.
template <class T>
void SegmentModel::add_band(const Curve<T>& curve, const All& at, Rows& rows) const {
  const StraightLineGoal& goal = *problem_.goal;
  const double relative = goal.deviation_relative.value_or(0);
  const double scale = goal.deviation ? 1 / *goal.deviation : 1 / (relative * at[length]);
  for (const T& h : curve.heights) {
    const double slope = goal.deviation ? 0 : value(h) * scale / at[length];
    rows.add(T(1) - scale * h, {{length, slope}});
    rows.add(T(1) + scale * h, {{length, -slope}});
  }
}

/// The largest dimension, by the unknown `size` or by the length.
void SegmentModel::add_sizes(const All& at, Rows& rows) const {
  const bool sized = objective_ == SegmentObjective::size;
  const double most = size_limit(problem_);
  if (sized && most < kFarthest) {
    rows.add(most * at[length] - at[size], {{length, most}, {size, -1.0}});
  }
  const double limit = sized ? at[size] : most * at[length];
  const Dimension by = sized ? size : length;
  const double slope = sized ? 1 : most;
  const int bars = type_ == MechanismType::slider_crank ? 2 : 4;
  for (int i = 0; i < bars; ++i) {
    const auto bar = static_cast<Dimension>(i);
    rows.add(limit - at[bar], {{by, slope}, {bar, -1.0}});
  }
  const double u = at[point_u], v = at[point_v], w = u - at[coupler];
  const double radius = std::max(std::hypot(u, v), 1e-12);
  const double other = std::max(std::hypot(w, v), 1e-12);
  rows.add(limit - radius, {{by, slope}, {point_u, -u / radius}, {point_v, -v / radius}});
  rows.add(limit - other,
           {{by, slope}, {point_u, -w / other}, {coupler, w / other}, {point_v, -v / other}});
  if (type_ == MechanismType::slider_crank) {
    rows.add(other - kPinDistance * at[length], {{length, -kPinDistance},
                                                 {point_u, w / other},
                                                 {coupler, -w / other},
                                                 {point_v, v / other}});
  }
}

void SegmentModel::add_links(const All& at, Rows& rows) const {
  if (type_ == MechanismType::slider_crank) {
    if (const auto& ratio = problem_.constraints.link_ratio_max) {
      rows.add(*ratio * at[crank] - at[coupler], {{crank, *ratio}, {coupler, -1.0}});
      rows.add(*ratio * at[coupler] - at[crank], {{crank, -1.0}, {coupler, *ratio}});
    }
    const bool turns = class_ == RequiredClass::crank_rocker || class_ == RequiredClass::grashof;
    if (!turns) return;
    const auto& limits = problem_.constraints.transmission_angle;
    const double cosine = limits ? std::min(std::cos(limits->min), -std::cos(limits->max)) : 1.0;
    for (const double sense : {-1.0, 1.0}) {
      rows.add(cosine * at[coupler] - at[crank] + sense * at[rocker],
               {{coupler, cosine}, {crank, -1.0}, {rocker, sense}});
    }
    return;
  }
  const auto count = static_cast<std::size_t>(link_limits_.count());
  std::vector<double> values(count);
  std::vector<Lengths<double>> slopes(count);
  link_limits_.evaluate({at[crank], at[coupler], at[rocker], at[frame]}, values, slopes);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [l1, l2, l3, l4] = slopes[i];
    rows.add(values[i], {{crank, l1}, {coupler, l2}, {rocker, l3}, {frame, l4}});
  }
}

/// Over the segment: the limits of the file where they are not those of the full turn, and a margin
/// from dead points. cos μ is extreme at both ends and, of a four-bar, where the crank lies in the
/// frame's line; of a slider-crank where it stands across the slide line.
template <class T>
void SegmentModel::add_transmission(const Curve<T>& curve, Rows& rows) const {
  Range limits{kDeadPointMargin, kPi - kDeadPointMargin};
  const auto& asked = problem_.constraints.transmission_angle;
  if (asked && !link_limits_.limits_transmission()) {
    limits = {std::max(limits.min, asked->min), std::min(limits.max, asked->max)};
  }
  const double least = std::cos(limits.max), most = std::cos(limits.min);
  const auto add = [&](const CouplerPoint<T>& point) {
    rows.add(T(most) - point.transmission_cosine);
    rows.add(point.transmission_cosine - T(least));
  };
  for (const CouplerPoint<T>& point : curve.extremes) add(point);
}

/// Speeds along the line over their mean, between `least_speed` and that and the variation.
template <class T>
void SegmentModel::add_speeds(const Curve<T>& curve, const All& at, Rows& rows) const {
  // The highest speed may lie between two nodes.
  constexpr double kMargin = 1e-3;
  const double variation = (1 - kMargin) * *problem_.segment.speed_variation_max;
  const double unit = 2 / at[length];
  for (const T& speed : curve.speeds) {
    const T share = unit * curve.reach * speed;
    const double slope = -value(share) / at[length];
    rows.add(share - T(at[least_speed]), {{length, slope}, {least_speed, -1.0}});
    rows.add(T(at[least_speed] + variation) - share, {{length, -slope}, {least_speed, 1.0}});
  }
}

/// Where the other pivot of a four-bar may be.
void SegmentModel::add_pivot(const All& at, Rows& rows) const {
  if (type_ == MechanismType::slider_crank) return;
  const double c = std::cos(at[frame_angle]), s = std::sin(at[frame_angle]);
  const double l = at[frame];
  const auto add = [&](const Box& box) {
    const double x = at[pivot_x] + l * c, y = at[pivot_y] + l * s;
    const auto between = [&](double value, double low, double high, Dimension pivot,
                             double by_frame, double by_angle) {
      if (std::isfinite(low)) {
        rows.add(value - low, {{pivot, 1.0}, {frame, by_frame}, {frame_angle, by_angle}});
      }
      if (std::isfinite(high)) {
        rows.add(high - value, {{pivot, -1.0}, {frame, -by_frame}, {frame_angle, -by_angle}});
      }
    };
    between(x, box.min.x, box.max.x, pivot_x, c, -l * s);
    between(y, box.min.y, box.max.y, pivot_y, s, l * c);
  };
  if (problem_.given.pivot_d && !problem_.given.pivot_a) {
    add({*problem_.given.pivot_d, *problem_.given.pivot_d});
  }
  if (problem_.bounds.pivot_d) add(*problem_.bounds.pivot_d);
  if (problem_.constraints.pivot_region) add(*problem_.constraints.pivot_region);
}

}  // namespace cognate::problems
