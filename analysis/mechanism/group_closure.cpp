#include "analysis/mechanism/group_closure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/mechanism/group_equations.hpp"
#include "analysis/mechanism/motion_terms.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

using Elimination = Eigen::PartialPivLU<GroupMatrix>;

/// No group needs more steps of Newton's method from a place nearby.
constexpr int kMostSteps = 40;

template <int Order>
using Moving = std::span<const BodyMotion<double, Order>>;

template <int Order>
bool is_placed(Moving<Order> bodies) {
  return std::ranges::all_of(bodies, [](const BodyMotion<double, Order>& body) {
    return is_finite(body.origin[0]) && is_finite(body.direction);
  });
}

/// The greatest coordinate that joints of the group have: what its rounding is proportional to.
template <int Order>
double extent(const Group& group, Moving<Order> bodies) {
  double size = 0;
  for (const GroupJoint& joint : group.joints) {
    for (const Attached<double>& point : {joint.first, joint.second}) {
      size = std::max(
          {size, norm1(bodies[static_cast<std::size_t>(point.body)].origin[0]), norm1(point.at)});
    }
  }
  return size;
}

/// Newton's method, to rounding.
template <int Order>
bool find_place(const Group& group, const GroupEquations& equations,
                std::span<BodyMotion<double, Order>> bodies) {
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps; ++i) {
    const GroupVector residual = equations.residual<Order>(bodies);
    const double left = residual.lpNorm<Eigen::Infinity>();
    const double rounding = 8 * kEpsilon * extent<Order>(group, bodies);
    if (!std::isfinite(left)) return false;
    if (left <= rounding && left >= before / 2) return true;
    if (left == 0) return true;
    before = left;
    equations.move<Order>(Elimination(equations.matrix<Order>(bodies)).solve(-residual), bodies);
  }
  return false;
}

template <int Order>
void leave(const Group& group, std::size_t first, std::span<BodyMotion<double, Order>> bodies) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  BodyMotion<double, Order> nowhere;
  nowhere.direction = {kNone, kNone};
  nowhere.origin.fill({kNone, kNone});
  nowhere.turn.fill(kNone);
  std::fill_n(bodies.begin() + static_cast<std::ptrdiff_t>(first), group.drawn.size(), nowhere);
}

/// Derivatives, from the lowest order.
template <int Order>
void find_rates(const GroupEquations& equations, const Elimination& elimination, std::size_t first,
                std::span<BodyMotion<double, Order>> bodies) {
  const auto count = static_cast<std::size_t>(equations.size()) / 3;
  for (std::size_t i = first; i < first + count; ++i) {
    std::fill(bodies[i].origin.begin() + 1, bodies[i].origin.end(), Vec2d{});
    bodies[i].turn = {};
  }
  motion_terms::for_each_order<Order>([&](auto order) {
    constexpr int kOrder = order();
    const GroupVector rate = elimination.solve(-equations.rest<kOrder, Order>(bodies));
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = static_cast<Eigen::Index>(3 * i);
      bodies[first + i].origin[kOrder] = {rate[row], rate[row + 1]};
      bodies[first + i].turn[kOrder - 1] = rate[row + 2] / equations.arm();
    }
  });
}

BodyMotion<double, 1> with_rate(const BodyMotion<Dual, 0>& body) {
  const Vec2d direction{body.direction.x.value, body.direction.y.value};
  BodyMotion<double, 1> moving{.direction = direction};
  moving.origin[0] = {body.origin[0].x.value, body.origin[0].y.value};
  moving.origin[1] = {body.origin[0].x.rate, body.origin[0].y.rate};
  moving.turn[0] = cross(direction, {body.direction.x.rate, body.direction.y.rate});
  return moving;
}

BodyMotion<Dual, 0> as_dual(const BodyMotion<double, 1>& body) {
  const auto dual = [](const Vec2d& value, const Vec2d& rate) -> Vec2<Dual> {
    return {{value.x, rate.x}, {value.y, rate.y}};
  };
  BodyMotion<Dual, 0> moving{.direction =
                                 dual(body.direction, body.turn[0] * perp(body.direction))};
  moving.origin[0] = dual(body.origin[0], body.origin[1]);
  return moving;
}

}  // namespace

template <int Order>
DyadClosure<double> close_group_of(const Group& group, std::size_t first, double side,
                                   std::span<BodyMotion<double, Order>> bodies) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const GroupEquations equations(group, first);
  const auto all = bodies.first(first + group.drawn.size());
  if (!is_placed<Order>(all) || (side != 0 && !find_place<Order>(group, equations, all))) {
    leave(group, first, bodies);
    return {kNone, kNone, kNone};
  }
  const GroupMatrix matrix = equations.matrix<Order>(all);
  if constexpr (Order > 0) find_rates<Order>(equations, Elimination(matrix), first, all);
  const double sine = side == 0 ? 0 : group_sine(matrix);
  return {sine * sine, sine, std::sqrt(std::max(0., 1 - sine * sine))};
}

DyadClosure<Dual> close_group_of(const Group& group, std::size_t first, double side,
                                 std::span<BodyMotion<Dual, 0>> bodies) {
  const auto count = first + group.drawn.size();
  std::vector<BodyMotion<double, 1>> moving(count);
  std::ranges::transform(bodies.first(count), moving.begin(), with_rate);
  const auto closure = close_group_of<1>(group, first, side, moving);
  std::ranges::transform(moving, bodies.begin(), as_dual);
  return {Dual(closure.discriminant), Dual(closure.sine), Dual(closure.cosine)};
}

template DyadClosure<double> close_group_of<0>(const Group&, std::size_t, double,
                                               std::span<BodyMotion<double, 0>>);
template DyadClosure<double> close_group_of<1>(const Group&, std::size_t, double,
                                               std::span<BodyMotion<double, 1>>);
template DyadClosure<double> close_group_of<2>(const Group&, std::size_t, double,
                                               std::span<BodyMotion<double, 2>>);
template DyadClosure<double> close_group_of<3>(const Group&, std::size_t, double,
                                               std::span<BodyMotion<double, 3>>);

}  // namespace cognate
