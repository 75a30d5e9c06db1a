#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "problems/guidance/dimensions.hpp"
#include "problems/guidance/model.hpp"

namespace cognate::problems {

using namespace motion_dimensions;

namespace {

/// By this share of all links a form that is kept closed does more than that.
constexpr double kKeptClosed = 1e-9;
constexpr double kLeastLength = std::numeric_limits<double>::min();

}  // namespace

int MotionModel::constraint_count() const {
  return linkage_constraints_.count() + static_cast<int>(distance_limits_.size()) +
         cycle_limits_.count() + driven_range_.count() + form_.closes_towards + form_.closes_away;
}

void MotionModel::constraints(std::span<const double> x, std::span<double> c,
                              std::span<double> jacobian) const {
  const Full v = full(x);
  const auto n = static_cast<std::size_t>(global_count());
  std::ranges::fill(jacobian, 0.0);
  const auto links = static_cast<std::size_t>(linkage_constraints_.count());
  const auto between = [&](int from, int to) {
    const Vec2d way = point(v, to) - point(v, from);
    const double distance = std::max(norm(way), std::numeric_limits<double>::min());
    return std::pair{distance, (1 / distance) * way};
  };
  const auto add_distance = [](Full& slopes, int from, int to, const Vec2d& along) {
    slopes[static_cast<std::size_t>(to)] += along.x;
    slopes[static_cast<std::size_t>(to) + 1] += along.y;
    slopes[static_cast<std::size_t>(from)] -= along.x;
    slopes[static_cast<std::size_t>(from) + 1] -= along.y;
  };
  const auto set = [&](std::size_t row, const Full& slopes) {
    for (std::size_t i = 0; i < free_.size(); ++i) {
      jacobian[row * n + i] = slopes[static_cast<std::size_t>(free_[i])];
    }
  };
  if (links > 0) {
    const auto [coupler, along_coupler] = between(kMoving1, kMoving2);
    const auto [frame, along_frame] = between(kFixed1, kFixed2);
    std::vector<Lengths<double>> gradient(jacobian.empty() ? 0 : links);
    linkage_constraints_.evaluate({v[kLength1], coupler, v[kLength2], frame}, c, gradient);
    for (std::size_t k = 0; k < gradient.size(); ++k) {
      Full slopes{};
      slopes[kLength1] = gradient[k].crank;
      slopes[kLength2] = gradient[k].rocker;
      add_distance(slopes, kMoving1, kMoving2, gradient[k].coupler * along_coupler);
      add_distance(slopes, kFixed1, kFixed2, gradient[k].frame * along_frame);
      set(k, slopes);
    }
  }
  for (std::size_t k = 0; k < distance_limits_.size(); ++k) {
    const DistanceLimit& limit = distance_limits_[k];
    const auto [distance, along] = between(limit.from, limit.to);
    c[links + k] = limit.sign * (distance - limit.limit);
    if (jacobian.empty()) continue;
    Full slopes{};
    add_distance(slopes, limit.from, limit.to, limit.sign * along);
    set(links + k, slopes);
  }
  const std::size_t before_turn = links + distance_limits_.size();
  const auto rest = [&](std::size_t row) {
    return jacobian.empty() ? jacobian : jacobian.subspan(row * n);
  };
  limit_turn(v, c.subspan(before_turn), rest(before_turn));
  const std::size_t before_range = before_turn + static_cast<std::size_t>(cycle_limits_.count());
  limit_driven_range(x, v, c.subspan(before_range), rest(before_range));
  const std::size_t before_closing = before_range + static_cast<std::size_t>(driven_range_.count());
  limit_closing(v, c.subspan(before_closing), rest(before_closing));
}

/// By how much a four-bar closes with its crank in line with the frame: |frame − crank| −
/// |coupler − rocker| towards the far pivot, coupler + rocker − frame − crank away from it.
MotionModel::ClosingSlack MotionModel::closing_slack(const Full& v, bool towards) const {
  const Vec2d coupler = point(v, kMoving2) - point(v, kMoving1);
  const Vec2d frame = point(v, kFixed2) - point(v, kFixed1);
  const double crank = v[kLength1], rocker = v[kLength2];
  const double length = std::max(norm(coupler), kLeastLength);
  const double apart = std::max(norm(frame), kLeastLength);
  const double outer = !towards ? -1 : apart < crank ? -1 : 1;
  const double inner = !towards ? 1 : length < rocker ? 1 : -1;
  const double by_crank = towards ? -outer : -1, by_rocker = towards ? -inner : 1;
  ClosingSlack slack{.links = crank + length + rocker + apart};
  slack.value = outer * apart + by_crank * crank + inner * length + by_rocker * rocker;
  const Vec2d by_coupler = (inner / length) * coupler, by_frame = (outer / apart) * frame;
  slack.slopes = {-by_coupler.x, -by_coupler.y, -by_frame.x, -by_frame.y, by_crank,
                  by_coupler.x,  by_coupler.y,  by_frame.x,  by_frame.y,  by_rocker};
  return slack;
}

/// The rows of the form that is kept closed.
void MotionModel::limit_closing(const Full& v, std::span<double> c,
                                std::span<double> jacobian) const {
  const auto n = static_cast<std::size_t>(global_count());
  std::size_t row = 0;
  for (const bool towards : {true, false}) {
    if (!(towards ? form_.closes_towards : form_.closes_away)) continue;
    const ClosingSlack slack = closing_slack(v, towards);
    c[row] = slack.value - kKeptClosed * slack.links;
    if (!jacobian.empty()) {
      for (std::size_t i = 0; i < free_.size(); ++i) {
        jacobian[row * n + i] = slack.slopes[static_cast<std::size_t>(free_[i])];
      }
    }
    ++row;
  }
}

/// The rows of the limits between the ends of the motion.
void MotionModel::limit_driven_range(std::span<const double> x, const Full& v, std::span<double> c,
                                     std::span<double> jacobian) const {
  if (driven_range_.count() == 0) return;
  const Vec2d coupler = point(v, kMoving2) - point(v, kMoving1);
  const Vec2d frame = point(v, kFixed2) - point(v, kFixed1);
  constexpr double kLeast = std::numeric_limits<double>::min();
  const double length = std::max(norm(coupler), kLeast), apart = std::max(norm(frame), kLeast);
  const std::size_t first = free_.size(), last = first + 1;
  const bool forward = x[first] <= x[last];
  const std::size_t from = forward ? first : last, to = forward ? last : first;
  const double direction = angle_of(frame);
  std::array<WaySlopes, DrivenRange::kLimits> all{};
  driven_range_.evaluate({v[kLength1], length, v[kLength2], apart},
                         {x[from] - direction, x[to] - direction}, c,
                         jacobian.empty() ? std::span<WaySlopes>{} : all);
  if (jacobian.empty()) return;
  const auto n = static_cast<std::size_t>(global_count());
  for (std::size_t row = 0; row < all.size(); ++row) {
    const auto& [by_crank, by_length, by_rocker, by_apart, by_from, by_to] = all[row];
    const Vec2d by_coupler = (by_length / length) * coupler;
    const Vec2d by_frame =
        (by_apart / apart) * frame - ((by_from + by_to) / (apart * apart)) * perp(frame);
    const Full slopes{-by_coupler.x, -by_coupler.y, -by_frame.x, -by_frame.y, by_crank,
                      by_coupler.x,  by_coupler.y,  by_frame.x,  by_frame.y,  by_rocker};
    for (std::size_t i = 0; i < free_.size(); ++i) {
      jacobian[row * n + i] = slopes[static_cast<std::size_t>(free_[i])];
    }
    jacobian[row * n + from] = by_from;
    jacobian[row * n + to] = by_to;
  }
}

/// The rows of the limits over the turn. The coupler point is the body's origin.
void MotionModel::limit_turn(const Full& v, std::span<double> c, std::span<double> jacobian) const {
  if (cycle_limits_.count() == 0) return;
  const Vec2d moving = point(v, kMoving1), fixed = point(v, kFixed1);
  const Vec2d coupler = point(v, kMoving2) - moving, frame = point(v, kFixed2) - fixed;
  constexpr double kLeast = std::numeric_limits<double>::min();
  const double length = std::max(norm(coupler), kLeast), apart = std::max(norm(frame), kLeast);
  const Vec2d along = (1 / length) * coupler, turn = (1 / apart) * frame;
  const Vec2d origin = -(conj(along) * moving);
  // Im(K E) is (B − D) × (C − B).
  const Assembly assembly = form_.sides.front() < 0 ? Assembly::open : Assembly::crossed;
  std::vector<LimitSlopes> all(jacobian.empty() ? 0
                                                : static_cast<std::size_t>(cycle_limits_.count()));
  cycle_limits_.evaluate(
      {{v[kLength1], length, v[kLength2], apart}, origin, fixed, angle_of(frame), assembly}, c,
      all);
  for (std::size_t row = 0; row < all.size(); ++row) {
    const auto& [crank, by_length, rocker, by_apart, by_u, by_v, by_x, by_y, by_angle] = all[row];
    // By the coupler's direction in the body, and by that of the frame.
    const double by_turning = by_u * origin.y - by_v * origin.x;
    const Vec2d by_coupler = by_length * along + (by_turning / length) * perp(along);
    const Vec2d by_frame = by_apart * turn + (by_angle / apart) * perp(turn);
    const Vec2d by_moving = -(along * Vec2d{by_u, by_v}) - by_coupler;
    const Full slopes{by_moving.x,  by_moving.y,  by_x - by_frame.x, by_y - by_frame.y, crank,
                      by_coupler.x, by_coupler.y, by_frame.x,        by_frame.y,        rocker};
    const auto n = static_cast<std::size_t>(global_count());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      jacobian[row * n + i] = slopes[static_cast<std::size_t>(free_[i])];
    }
  }
}

}  // namespace cognate::problems
