/// @file Path generation of a four-bar as a nonlinear program.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/linkage/closure.hpp"
#include "problems/linkage/cycle/cycle_limits.hpp"
#include "problems/linkage/driven_range.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/path/problem.hpp"
#include "synthesis/lanes/path_fit.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// Whether the crank of a linkage that is kept to this class turns fully.
inline bool turns_fully(const std::optional<RequiredClass>& required) {
  return required == RequiredClass::crank_rocker || required == RequiredClass::double_crank;
}

/// Distances from coupler points to target points, with exact derivatives.
///
/// Dimensions (in this order, those that the file fixes left out of the variables): crank, coupler,
/// rocker, frame, coupler point u, v, anchor x, y, frame angle, phase. The anchor is the crank
/// pivot A, or D where the file fixes D alone. The phase, the first point's crank angle from the
/// frame, exists for increments only. The crank angle of each point that is not timed,
/// from the frame line, is a local variable. Lengths are in units of the path's size: see
/// path_scale.hpp.
class PathModel final : public synthesis::Model {
 public:
  static constexpr int dimensions = 10;
  enum Dimension {
    crank,
    coupler,
    rocker,
    frame,
    point_u,
    point_v,
    anchor_x,
    anchor_y,
    angle,
    phase
  };

  /// `problem`: already scaled. `clockwise`: increments are counted clockwise.
  PathModel(const PathProblem& problem, Assembly assembly, bool clockwise);

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return 2 * static_cast<int>(problem_.points.size()); }
  int constraint_count() const override;
  std::span<const int> local_of_residual() const override { return local_of_residual_; }
  int local_count() const override { return local_count_; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;
  /// Not with limits over the full turn.
  bool has_hessian() const override { return cycle_limits_.count() == 0; }
  bool lagrangian_hessian(std::span<const double> x, std::span<const double> of_residuals,
                          std::span<const double> of_constraints,
                          std::span<double> out) const override;

  /// The variables that stand for `linkage` with its first timed point, and each that is not timed,
  /// at the crank angles given, from the x axis.
  std::vector<double> variables_of(const FourBar& linkage,
                                   std::span<const double> crank_angles) const;

  /// The model as the fit in SIMD lanes takes it, without limits on the two angles; a start of that
  /// fit from variables, and back (angles as near to those of `near` as turns allow).
  synthesis::PathFit lane_fit() const;
  synthesis::PathFitState lane_state(std::span<const double> x) const;
  std::vector<double> variables_of(const synthesis::PathFitState& state,
                                   std::span<const double> near) const;

  /// Which dimension each global variable is, ascending.
  std::span<const int> free_dimensions() const { return free_; }

  /// The limits of the transmission angle, unless the crank is kept to a class that turns it fully:
  /// they are then constraints over the turn. Those on the way between timed points are constraints
  /// too; where the points that are not timed may lie, whoever places them sees to.
  std::optional<Range> transmission_on_the_way() const;

  FourBar linkage(std::span<const double> x) const;
  std::vector<double> crank_angles(std::span<const double> x) const;  ///< from the x axis
  /// The same into `angles`, whose size is the number of points.
  void crank_angles(std::span<const double> x, std::span<double> angles) const;

 private:
  struct PointCurvature;
  using Full = std::array<double, dimensions>;

  bool is_timed(std::size_t point) const { return local_[point] < 0; }
  /// From the frame line.
  double local_angle(std::span<const double> x, std::size_t point) const {
    return x[free_.size() + static_cast<std::size_t>(local_[point])];
  }
  void add_variable(Dimension dimension, std::optional<double> given, Range range,
                    const char* name);
  void list_variables();
  void list_increments(bool clockwise);
  void list_local_angles();
  Full full(std::span<const double> x) const;
  double timing_offset(const Full& v) const;
  int pivot_limits() const;
  void limit_pivot(const Full& v, std::span<double> c, std::span<double> jacobian) const;
  void limit_turn(const Full& v, std::span<double> c, std::span<double> jacobian) const;
  DrivenRange driven_range(bool clockwise) const;
  void limit_driven_range(const Full& v, std::span<double> c, std::span<double> jacobian) const;
  Vec2d pivot_pull(std::span<const double> of_constraints) const;

  PathProblem problem_;
  double assembly_;
  bool anchor_is_d_ = false;
  Full fixed_{};           ///< values of the dimensions that are not variables
  std::vector<int> free_;  ///< dimension of each global variable
  std::vector<synthesis::Variable> variables_;
  std::vector<int> local_;  ///< of each point: which local variable is its angle; −1: it is timed
  std::vector<int> local_of_residual_;
  int local_count_ = 0;
  std::size_t first_timed_ = 0;  ///< number of points if there is none
  std::vector<double> root_weight_;
  std::vector<double> increment_;      ///< of timed points: crank angle before phase or angle
  std::vector<Vec2d> increment_half_;  ///< unit vectors of their halves
  LinkageConstraints linkage_constraints_;
  CycleLimits cycle_limits_;
  DrivenRange driven_range_;
  Box other_pivot_box_;  ///< limits of the pivot that is not the anchor; sides may be infinite
};

}  // namespace cognate::problems
