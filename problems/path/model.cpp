#include "problems/path/model.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/path/order_intervals.hpp"

namespace cognate::problems {
namespace {

/// Lengths without a bound of the file stay below this many sizes of the path; beyond it a link
/// turns so little that the linkage is a slider-crank in all but name.
constexpr double kLongestLink = 1000;
/// A length whose lower bound is 0 stays above this share of the path's size.
constexpr double kShortestLink = 1e-6;

Range intersect(Range a, const std::optional<Range>& b) {
  return b ? Range{std::max(a.min, b->min), std::min(a.max, b->max)} : a;
}

std::optional<Range> side(const std::optional<Box>& box, double Vec2d::*axis) {
  if (!box) return std::nullopt;
  return Range{box->min.*axis, box->max.*axis};
}

std::optional<double> side(const std::optional<Vec2d>& point, double Vec2d::*axis) {
  return point ? std::optional(*point.*axis) : std::nullopt;
}

Box intersect(const std::optional<Box>& a, const std::optional<Box>& b) {
  Box all{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  for (const auto* box : {&a, &b}) {
    if (!*box) continue;
    all.min = {std::max(all.min.x, (*box)->min.x), std::max(all.min.y, (*box)->min.y)};
    all.max = {std::min(all.max.x, (*box)->max.x), std::min(all.max.y, (*box)->max.y)};
  }
  return all;
}

/// Turns what fixes both pivots into frame and frame angle.
Given with_frame_from_pivots(Given given) {
  if (given.pivot_a && given.pivot_d) {
    const Vec2d frame = *given.pivot_d - *given.pivot_a;
    given.frame = std::hypot(frame.x, frame.y);
    given.frame_angle = std::atan2(frame.y, frame.x);
  }
  return given;
}

}  // namespace

PathModel::PathModel(const PathProblem& problem, Assembly assembly, bool clockwise)
    : problem_(problem),
      assembly_(sign(assembly)),
      anchor_is_d_(problem.given.pivot_d && !problem.given.pivot_a),
      linkage_constraints_(problem.constraints, 1.0),
      cycle_limits_(problem.constraints, CycleOutput::coupler_point) {
  problem_.given = with_frame_from_pivots(problem.given);
  while (first_timed_ < problem.points.size() && !problem.is_timed(first_timed_)) ++first_timed_;
  list_variables();
  list_increments(clockwise);
  list_local_angles();
  driven_range_ = driven_range(clockwise);
  for (const double weight : problem_.weights) root_weight_.push_back(std::sqrt(weight));
  root_weight_.resize(problem_.points.size(), 1.0);
}

void PathModel::add_variable(Dimension dimension, std::optional<double> given, Range range,
                             const char* name) {
  if (given) {
    fixed_[dimension] = *given;
    return;
  }
  free_.push_back(dimension);
  variables_.push_back({name, range.min, range.max, 1});
}

void PathModel::list_variables() {
  const Given& given = problem_.given;
  const Bounds& bounds = problem_.bounds;
  const Range length{kShortestLink, kLongestLink}, anywhere{-2 * kLongestLink, 2 * kLongestLink};
  add_variable(crank, given.crank, intersect(length, bounds.crank), "crank");
  add_variable(coupler, given.coupler, intersect(length, bounds.coupler), "coupler");
  add_variable(rocker, given.rocker, intersect(length, bounds.rocker), "rocker");
  add_variable(frame, given.frame, intersect(length, bounds.frame), "frame");
  add_variable(point_u, side(given.coupler_point, &Vec2d::x),
               intersect(anywhere, side(bounds.coupler_point, &Vec2d::x)), "coupler point u");
  add_variable(point_v, side(given.coupler_point, &Vec2d::y),
               intersect(anywhere, side(bounds.coupler_point, &Vec2d::y)), "coupler point v");

  const auto& anchor = anchor_is_d_ ? given.pivot_d : given.pivot_a;
  const Box a = intersect(bounds.pivot_a, problem_.constraints.pivot_region);
  const Box d = intersect(bounds.pivot_d, problem_.constraints.pivot_region);
  const Box& own = anchor_is_d_ ? d : a;
  other_pivot_box_ = anchor_is_d_ ? a : d;
  add_variable(anchor_x, side(anchor, &Vec2d::x), intersect(anywhere, side({own}, &Vec2d::x)),
               "pivot x");
  add_variable(anchor_y, side(anchor, &Vec2d::y), intersect(anywhere, side({own}, &Vec2d::y)),
               "pivot y");
  const double turn = kTurn;
  add_variable(angle, given.frame_angle, intersect({-4 * turn, 4 * turn}, bounds.frame_angle),
               "frame angle");
  const bool any_timed = first_timed_ < problem_.points.size();
  const bool has_phase = any_timed && problem_.crank_reference == CrankReference::first;
  add_variable(phase, has_phase ? std::nullopt : std::optional(0.0), {-4 * turn, 4 * turn},
               "phase");
}

void PathModel::list_increments(bool clockwise) {
  const bool relative = problem_.crank_reference == CrankReference::first;
  const std::size_t n = problem_.points.size();
  const double origin = relative && first_timed_ < n ? problem_.crank_angles[first_timed_] : 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double increment = problem_.is_timed(j) ? problem_.crank_angles[j] - origin : 0;
    increment_.push_back(relative && clockwise ? -increment : increment);
    increment_half_.push_back(unit_vector(0.5 * increment_.back()));
  }
}

void PathModel::list_local_angles() {
  const double turns = 1e3 * kTurn;
  for (std::size_t j = 0; j < problem_.points.size(); ++j) {
    local_.push_back(problem_.is_timed(j) ? -1 : local_count_++);
    local_of_residual_.insert(local_of_residual_.end(), 2, local_.back());
    if (!is_timed(j)) {
      variables_.push_back({"crank angle " + std::to_string(j), -turns, turns, 1});
    }
  }
}

PathModel::Full PathModel::full(std::span<const double> x) const {
  Full v = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) v[free_[i]] = x[i];
  return v;
}

double PathModel::timing_offset(const Full& v) const {
  return problem_.crank_reference == CrankReference::global ? -v[angle] : v[phase];
}

bool PathModel::residuals(std::span<const double> x, std::span<double> r,
                          std::span<double> jacobian, std::span<double> local) const {
  const Full v = full(x);
  const Lengths<double> links{v[crank], v[coupler], v[rocker], v[frame]};
  const Closure<double> closure(links);
  const Vec2d turn = unit_vector(v[angle]);
  const Vec2d offset_half = unit_vector(0.5 * timing_offset(v));
  const Vec2d anchor{v[anchor_x], v[anchor_y]};
  // From the anchor to the crank pivot A, in the frame's axes.
  const Vec2d to_a{anchor_is_d_ ? -v[frame] : 0.0, 0.0};
  const bool global = problem_.crank_reference == CrankReference::global;
  const std::size_t n = free_.size();

  for (std::size_t j = 0; j < problem_.points.size(); ++j) {
    const auto direction = is_timed(j) ? crank_direction(increment_half_[j] * offset_half)
                                       : crank_direction(local_angle(x, j));
    const auto at = closure.at(direction, assembly_);
    if (!(at.discriminant > 0)) return false;
    const Vec2d e1{direction.cos, direction.sin};
    const Vec2d q = at.coupler * Vec2d{v[point_u], v[point_v]};
    const Vec2d arm = v[crank] * e1 + q;  // from A to the coupler point
    const double w = root_weight_[j];
    const Vec2d error = w * (anchor + turn * (to_a + arm) - problem_.points[j]);
    r[2 * j] = error.x;
    r[2 * j + 1] = error.y;
    if (jacobian.empty() && local.empty()) continue;

    const auto phi = closure_gradient(links, e1, at).coupler;
    const Vec2d by_phi = perp(q);
    const Vec2d by_theta = v[crank] * perp(e1) + phi.crank_angle * by_phi;
    const std::array<Vec2d, dimensions> in_frame{
        e1 + phi.crank * by_phi,
        phi.coupler * by_phi,
        phi.rocker * by_phi,
        Vec2d{anchor_is_d_ ? -1.0 : 0.0, 0} + phi.frame * by_phi,
        at.coupler,
        perp(at.coupler),
        conj(turn),
        perp(conj(turn)),
        perp(to_a + arm) - (is_timed(j) && global ? 1.0 : 0.0) * by_theta,
        (is_timed(j) ? 1.0 : 0.0) * by_theta};
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2d derivative = w * (turn * in_frame[free_[i]]);
      jacobian[2 * j * n + i] = derivative.x;
      jacobian[(2 * j + 1) * n + i] = derivative.y;
    }
    if (local.empty()) continue;
    const Vec2d derivative = (is_timed(j) ? 0.0 : w) * (turn * by_theta);
    local[2 * j] = derivative.x;
    local[2 * j + 1] = derivative.y;
  }
  return true;
}

int PathModel::constraint_count() const {
  return linkage_constraints_.count() + pivot_limits() + cycle_limits_.count() +
         driven_range_.count();
}

/// The other pivot's box has four sides, of which only finite ones are constraints.
int PathModel::pivot_limits() const {
  const Box& box = other_pivot_box_;
  return std::isfinite(box.min.x) + std::isfinite(box.max.x) + std::isfinite(box.min.y) +
         std::isfinite(box.max.y);
}

void PathModel::constraints(std::span<const double> x, std::span<double> c,
                            std::span<double> jacobian) const {
  const Full v = full(x);
  const std::size_t n = free_.size();
  const auto set = [&](std::size_t row, const Full& slopes) {
    for (std::size_t i = 0; i < n; ++i) jacobian[row * n + i] = slopes[free_[i]];
  };
  const auto links = static_cast<std::size_t>(linkage_constraints_.count());
  std::vector<Lengths<double>> gradient(jacobian.empty() ? 0 : links);
  linkage_constraints_.evaluate({v[crank], v[coupler], v[rocker], v[frame]}, c, gradient);
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    const Lengths<double>& g = gradient[k];
    set(k, {g.crank, g.coupler, g.rocker, g.frame});
  }
  const auto rest = [&](std::size_t row) {
    return jacobian.empty() ? jacobian : jacobian.subspan(row * n);
  };
  limit_pivot(v, c.subspan(links), rest(links));
  const auto before_turn = links + static_cast<std::size_t>(pivot_limits());
  limit_turn(v, c.subspan(before_turn), rest(before_turn));
  const auto before_range = before_turn + static_cast<std::size_t>(cycle_limits_.count());
  limit_driven_range(v, c.subspan(before_range), rest(before_range));
}

std::optional<Range> PathModel::transmission_on_the_way() const {
  const Constraints& constraints = problem_.constraints;
  return turns_fully(constraints.required_class) ? std::nullopt : constraints.transmission_angle;
}

/// That of a crank which is not kept to a class that turns it fully, between timed points. Where
/// all are timed it turns by the shorter way from each to the next; else, in order, in its sense.
DrivenRange PathModel::driven_range(bool clockwise) const {
  const bool all_timed = local_count_ == 0;
  const bool is_limited = all_timed || transmission_on_the_way();
  if (turns_fully(problem_.constraints.required_class) || !is_limited) return {};
  const bool one_sense = !all_timed && problem_.order == PointOrder::cyclic;
  const double sense = clockwise ? -1 : 1;
  std::optional<Range> range;
  double at = 0, before = 0;
  for (std::size_t j = 0; j < increment_.size(); ++j) {
    if (!is_timed(j)) continue;
    if (!range) at = before = increment_[j], range = Range{at, at};
    at += one_sense ? sense * step_forward(sense * before, sense * increment_[j])
                    : std::remainder(increment_[j] - before, kTurn);
    before = increment_[j];
    range = {std::min(range->min, at), std::max(range->max, at)};
  }
  return range ? DrivenRange(problem_.constraints, *range) : DrivenRange();
}

void PathModel::limit_driven_range(const Full& v, std::span<double> c,
                                   std::span<double> jacobian) const {
  if (driven_range_.count() == 0) return;
  std::array<DrivenSlopes, DrivenRange::kLimits> all{};
  driven_range_.evaluate({{v[crank], v[coupler], v[rocker], v[frame]}, timing_offset(v)}, c,
                         jacobian.empty() ? std::span<DrivenSlopes>{} : all);
  if (jacobian.empty()) return;
  const bool global = problem_.crank_reference == CrankReference::global;
  for (std::size_t row = 0; row < all.size(); ++row) {
    const auto& [by_crank, by_coupler, by_rocker, by_frame, by_offset] = all[row];
    Full slopes{by_crank, by_coupler, by_rocker, by_frame};
    slopes[angle] = global ? -by_offset : 0;
    slopes[phase] = global ? 0 : by_offset;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      jacobian[row * free_.size() + i] = slopes[free_[i]];
    }
  }
}

/// The rows of the pivot that is not the anchor.
void PathModel::limit_pivot(const Full& v, std::span<double> c, std::span<double> jacobian) const {
  if (pivot_limits() == 0) return;
  const std::size_t n = free_.size();
  const double away = anchor_is_d_ ? -1 : 1;
  const Vec2d turn = unit_vector(v[angle]);
  const Vec2d pivot = Vec2d{v[anchor_x], v[anchor_y]} + (away * v[frame]) * turn;
  std::size_t row = 0;
  const auto limit = [&](double distance, double toward, double Vec2d::*axis, Dimension anchor) {
    if (!std::isfinite(distance)) return;
    c[row] = distance;
    if (!jacobian.empty()) {
      Full slopes{};
      slopes[anchor] = toward;
      slopes[frame] = toward * away * turn.*axis;
      slopes[angle] = toward * away * v[frame] * perp(turn).*axis;
      for (std::size_t i = 0; i < n; ++i) jacobian[row * n + i] = slopes[free_[i]];
    }
    ++row;
  };
  limit(pivot.x - other_pivot_box_.min.x, 1, &Vec2d::x, anchor_x);
  limit(other_pivot_box_.max.x - pivot.x, -1, &Vec2d::x, anchor_x);
  limit(pivot.y - other_pivot_box_.min.y, 1, &Vec2d::y, anchor_y);
  limit(other_pivot_box_.max.y - pivot.y, -1, &Vec2d::y, anchor_y);
}

/// The rows of the limits over the turn, whose dimensions are the model's up to the anchor.
void PathModel::limit_turn(const Full& v, std::span<double> c, std::span<double> jacobian) const {
  if (cycle_limits_.count() == 0) return;
  const std::size_t n = free_.size();
  const Vec2d turn = unit_vector(v[angle]), anchor{v[anchor_x], v[anchor_y]};
  const Vec2d pivot_a = anchor_is_d_ ? anchor - v[frame] * turn : anchor;
  std::vector<LimitSlopes> all(jacobian.empty() ? 0
                                                : static_cast<std::size_t>(cycle_limits_.count()));
  cycle_limits_.evaluate({{v[crank], v[coupler], v[rocker], v[frame]},
                          {v[point_u], v[point_v]},
                          pivot_a,
                          v[angle],
                          assembly_ > 0 ? Assembly::open : Assembly::crossed},
                         c, all);
  for (std::size_t row = 0; row < all.size(); ++row) {
    Full slopes{};
    std::ranges::copy(all[row], slopes.begin());
    if (anchor_is_d_) {
      const Vec2d by_a{slopes[anchor_x], slopes[anchor_y]};
      slopes[frame] -= dot(by_a, turn);
      slopes[angle] -= v[frame] * dot(by_a, perp(turn));
    }
    for (std::size_t i = 0; i < n; ++i) jacobian[row * n + i] = slopes[free_[i]];
  }
}

FourBar PathModel::linkage(std::span<const double> x) const {
  const Full v = full(x);
  const Vec2d along = v[frame] * unit_vector(v[angle]);
  const Vec2d anchor{v[anchor_x], v[anchor_y]};
  return {.pivot_a = anchor_is_d_ ? anchor - along : anchor,
          .pivot_d = anchor_is_d_ ? anchor : anchor + along,
          .crank = v[crank],
          .coupler = v[coupler],
          .rocker = v[rocker],
          .assembly = assembly_ > 0 ? Assembly::open : Assembly::crossed,
          .coupler_point = Vec2d{v[point_u], v[point_v]}};
}

std::vector<double> PathModel::crank_angles(std::span<const double> x) const {
  std::vector<double> angles(problem_.points.size());
  crank_angles(x, angles);
  return angles;
}

void PathModel::crank_angles(std::span<const double> x, std::span<double> angles) const {
  const Full v = full(x);
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const double from_frame = is_timed(j) ? increment_[j] + timing_offset(v) : local_angle(x, j);
    angles[j] = from_frame + v[angle];
  }
}

std::vector<double> PathModel::variables_of(const FourBar& linkage,
                                            std::span<const double> crank_angles) const {
  const Vec2d anchor = anchor_is_d_ ? linkage.pivot_d : linkage.pivot_a;
  const Vec2d point = linkage.coupler_point.value_or(Vec2d{});
  const double direction = frame_angle(linkage);
  const bool any_timed = first_timed_ < crank_angles.size();
  const double offset =
      any_timed ? crank_angles[first_timed_] - direction - increment_[first_timed_] : 0;
  const Full v{linkage.crank, linkage.coupler, linkage.rocker, lengths(linkage).frame,
               point.x,       point.y,         anchor.x,       anchor.y,
               direction,     offset};
  std::vector<double> x;
  for (const int dimension : free_) x.push_back(v[dimension]);
  for (std::size_t j = 0; j < crank_angles.size(); ++j) {
    if (!is_timed(j)) x.push_back(crank_angles[j] - direction);
  }
  return x;
}

}  // namespace cognate::problems
