/// @file The equations of a group of bodies that close together.
///
/// The unknowns are x, y and angle of every body, the equations two of each joint: of a pin the
/// coordinates of its place on one body less those on the other, of a slide the sine of the angle
/// between its two directions and the distance of its point from its line. Angles count in a length
/// of the group, so that all are of one size. Derivatives of any order have the same matrix: what
/// the orders below leave in the equations stands on the right (as in motion_terms.hpp). It is
/// singular at dead points alone, where a motion of the group is possible that the rest does not
/// drive.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "analysis/mechanism/group.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

/// Three rows, or columns, for each body of a group; nothing is allocated.
using GroupMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                  3 * kMostGroupBodies, 3 * kMostGroupBodies>;
using GroupVector =
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 * kMostGroupBodies, 1>;

/// The equations of `group`, whose first body is number `first` of the bodies.
class GroupEquations {
 public:
  GroupEquations(const Group& group, std::size_t first);

  /// How many there are: three for each body.
  int size() const { return static_cast<int>(3 * group_.drawn.size()); }
  /// The length of the group in which angles count.
  double arm() const { return arm_; }

  /// What the equations fail by where the bodies stand, lengths.
  template <int Order>
  GroupVector residual(std::span<const BodyMotion<double, Order>> bodies) const;

  /// The derivatives of the residual by the unknowns.
  template <int Order>
  GroupMatrix matrix(std::span<const BodyMotion<double, Order>> bodies) const;

  /// Derivative K of the residual by the drive's coordinate that is left while derivative K of
  /// the group's bodies is 0.
  template <int K, int Order>
  GroupVector rest(std::span<const BodyMotion<double, Order>> bodies) const;

  /// Moves the group's bodies by `step`.
  template <int Order>
  void move(const GroupVector& step, std::span<BodyMotion<double, Order>> bodies) const;

 private:
  void add(GroupMatrix& matrix, int row, const Attached<double>& point, const Vec2d& by_place,
           double by_turn) const;

  const Group& group_;
  std::size_t first_;
  double arm_ = 1;
};

/// How far a group is from a dead point: the reciprocal condition number of its equations' matrix,
/// with the sign of the determinant. 0 at a dead point, beyond which the sign is another.
double group_sine(const GroupMatrix& matrix);

/// Magnitudes below this are those of a dead point, or of a part that cannot move while another is
/// loose, but for rounding of places that a file gives.
inline constexpr double kDeadGroupSine = 1e-10;

}  // namespace cognate
