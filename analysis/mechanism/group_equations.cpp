#include "analysis/mechanism/group_equations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace cognate {
namespace {

template <int Order>
using Moving = std::span<const BodyMotion<double, Order>>;

template <int Order>
const BodyMotion<double, Order>& body_of(const Attached<double>& point, Moving<Order> bodies) {
  return bodies[static_cast<std::size_t>(point.body)];
}

/// From the origin of its body to a point.
template <int Order>
Vec2d arm_of(const Attached<double>& point, Moving<Order> bodies) {
  return body_of(point, bodies).direction * point.at;
}

template <int Order>
Vec2d place_of(const Attached<double>& point, Moving<Order> bodies) {
  return body_of(point, bodies).origin[0] + arm_of(point, bodies);
}

/// The derivatives of a vector that is fixed on a body.
template <int Order>
std::array<Vec2d, Order + 1> turning(const BodyMotion<double, Order>& body, const Vec2d& vector) {
  BodyMotion<double, Order> about_itself = body;
  about_itself.origin = {};
  return point_motion(about_itself, vector);
}

/// Derivative K of u × v, by Leibniz' rule.
template <int K, std::size_t Size>
double cross_derivative(const std::array<Vec2d, Size>& u, const std::array<Vec2d, Size>& v) {
  constexpr std::array<std::array<double, 4>, 4> kBinomials{
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
  double sum = 0;
  for (std::size_t i = 0; i <= K; ++i) sum += kBinomials[K][i] * cross(u[i], v[K - i]);
  return sum;
}

}  // namespace

GroupEquations::GroupEquations(const Group& group, std::size_t first)
    : group_(group), first_(first) {
  double arm = 0;
  for (const GroupJoint& joint : group.joints) {
    for (const Attached<double>& point : {joint.first, joint.second}) {
      if (static_cast<std::size_t>(point.body) >= first) arm = std::max(arm, norm(point.at));
    }
  }
  if (arm > 0) arm_ = arm;
}

void GroupEquations::add(GroupMatrix& matrix, int row, const Attached<double>& point,
                         const Vec2d& by_place, double by_turn) const {
  if (static_cast<std::size_t>(point.body) < first_) return;
  const auto column = 3 * (point.body - static_cast<int>(first_));
  matrix(row, column) += by_place.x;
  matrix(row, column + 1) += by_place.y;
  matrix(row, column + 2) += by_turn / arm_;
}

template <int Order>
GroupVector GroupEquations::residual(Moving<Order> bodies) const {
  GroupVector residual(size());
  int row = 0;
  for (const GroupJoint& joint : group_.joints) {
    const Vec2d gap = place_of(joint.second, bodies) - place_of(joint.first, bodies);
    if (joint.slides) {
      const Vec2d along = body_of(joint.first, bodies).direction * joint.along_first;
      const Vec2d slider = body_of(joint.second, bodies).direction * joint.along_second;
      residual[row++] = arm_ * cross(along, slider);
      residual[row++] = cross(along, gap);
    } else {
      residual[row++] = gap.x;
      residual[row++] = gap.y;
    }
  }
  return residual;
}

template <int Order>
GroupMatrix GroupEquations::matrix(Moving<Order> bodies) const {
  GroupMatrix matrix = GroupMatrix::Zero(size(), size());
  int row = 0;
  for (const GroupJoint& joint : group_.joints) {
    const Vec2d first = arm_of(joint.first, bodies), second = arm_of(joint.second, bodies);
    if (joint.slides) {
      const Vec2d along = body_of(joint.first, bodies).direction * joint.along_first;
      const Vec2d slider = body_of(joint.second, bodies).direction * joint.along_second;
      const Vec2d gap = place_of(joint.second, bodies) - place_of(joint.first, bodies);
      const double parallel = arm_ * dot(along, slider);
      add(matrix, row, joint.first, {}, -parallel);
      add(matrix, row++, joint.second, {}, parallel);
      add(matrix, row, joint.first, -perp(along), -dot(along, gap + first));
      add(matrix, row++, joint.second, perp(along), dot(along, second));
    } else {
      add(matrix, row, joint.first, {-1, 0}, first.y);
      add(matrix, row++, joint.second, {1, 0}, -second.y);
      add(matrix, row, joint.first, {0, -1}, -first.x);
      add(matrix, row++, joint.second, {0, 1}, second.x);
    }
  }
  return matrix;
}

template <int K, int Order>
GroupVector GroupEquations::rest(Moving<Order> bodies) const {
  GroupVector rest(size());
  int row = 0;
  for (const GroupJoint& joint : group_.joints) {
    const auto& first = body_of(joint.first, bodies);
    const auto& second = body_of(joint.second, bodies);
    auto gap = point_motion(second, joint.second.at);
    const auto from = point_motion(first, joint.first.at);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = gap[i] - from[i];
    if (joint.slides) {
      rest[row++] = arm_ * (second.turn[K - 1] - first.turn[K - 1]);
      rest[row++] = cross_derivative<K>(turning(first, joint.along_first), gap);
    } else {
      rest[row++] = gap[K].x;
      rest[row++] = gap[K].y;
    }
  }
  return rest;
}

template <int Order>
void GroupEquations::move(const GroupVector& step,
                          std::span<BodyMotion<double, Order>> bodies) const {
  for (std::size_t i = 0; i < group_.drawn.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    BodyMotion<double, Order>& body = bodies[first_ + i];
    body.origin[0] = body.origin[0] + Vec2d{step[row], step[row + 1]};
    const double turn = step[row + 2] / arm_;
    body.direction = body.direction + turn * perp(body.direction);
    body.direction = (1 / norm(body.direction)) * body.direction;
  }
}

double group_sine(const GroupMatrix& matrix) {
  GroupMatrix scaled = matrix;
  for (Eigen::Index row = 0; row < scaled.rows(); ++row) scaled.row(row).normalize();
  for (Eigen::Index column = 0; column < scaled.cols(); ++column) scaled.col(column).normalize();
  const Eigen::PartialPivLU<GroupMatrix> elimination(scaled);
  return std::copysign(elimination.rcond(), elimination.determinant());
}

template GroupVector GroupEquations::residual<0>(Moving<0>) const;
template GroupMatrix GroupEquations::matrix<0>(Moving<0>) const;
template void GroupEquations::move<0>(const GroupVector&, std::span<BodyMotion<double, 0>>) const;
template GroupVector GroupEquations::residual<1>(Moving<1>) const;
template GroupMatrix GroupEquations::matrix<1>(Moving<1>) const;
template void GroupEquations::move<1>(const GroupVector&, std::span<BodyMotion<double, 1>>) const;
template GroupVector GroupEquations::residual<2>(Moving<2>) const;
template GroupMatrix GroupEquations::matrix<2>(Moving<2>) const;
template void GroupEquations::move<2>(const GroupVector&, std::span<BodyMotion<double, 2>>) const;
template GroupVector GroupEquations::residual<3>(Moving<3>) const;
template GroupMatrix GroupEquations::matrix<3>(Moving<3>) const;
template void GroupEquations::move<3>(const GroupVector&, std::span<BodyMotion<double, 3>>) const;
template GroupVector GroupEquations::rest<1, 1>(Moving<1>) const;
template GroupVector GroupEquations::rest<1, 2>(Moving<2>) const;
template GroupVector GroupEquations::rest<2, 2>(Moving<2>) const;
template GroupVector GroupEquations::rest<1, 3>(Moving<3>) const;
template GroupVector GroupEquations::rest<2, 3>(Moving<3>) const;
template GroupVector GroupEquations::rest<3, 3>(Moving<3>) const;

}  // namespace cognate
