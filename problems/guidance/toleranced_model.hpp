/// @file Guidance of a body by two links whose lengths may be off.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "problems/guidance/design.hpp"
#include "problems/guidance/model.hpp"
#include "problems/guidance/problem.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// The errors of a MotionModel of four-bars, all of whose dimensions are variables, and after its
/// global variables those by which the links of what is made are off: the changes of crank,
/// coupler, rocker and frame, and of the body's origin along the coupler and across it. The changes
/// leave the pivot A, the direction of the frame and the body's angle in the coupler as they are.
/// With e the direction of the coupler in the body and g that of the frame, the pivots are then
///
///     m₁ − u e − v e⊥,   m₂ + (c − u) e − v e⊥,   A,   D + f g
///
/// (m in the body's axes) and the links are longer by their changes. Constraints are those of the
/// nominal linkage, whatever the changes. Without a value where a change leaves nothing of a link.
class TolerancedMotionModel final : public synthesis::Model {
 public:
  enum Change { crank, coupler, rocker, frame, point_u, point_v };
  static constexpr std::size_t changes = 6;

  /// `problem`: scaled, without anything given; `form`: its second dyad a link.
  TolerancedMotionModel(const MotionProblem& problem, MotionForm form);

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return nominal_.residual_count(); }
  int constraint_count() const override { return nominal_.constraint_count(); }
  std::span<const int> local_of_residual() const override { return nominal_.local_of_residual(); }
  int local_count() const override { return nominal_.local_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

  const MotionModel& nominal() const { return nominal_; }

  /// Which variable a change is.
  std::size_t variable_of(Change change) const { return before_changes() + change; }

  /// The variables of the nominal model; and these with no changes.
  std::vector<double> without_changes(std::span<const double> x) const;
  std::vector<double> with_no_changes(std::span<const double> nominal) const;

 private:
  struct Moved;

  std::size_t before_changes() const { return static_cast<std::size_t>(nominal_.global_count()); }
  std::optional<Moved> moved(std::span<const double> x) const;
  static void turn_back(const Moved& at, std::span<const double> by_moved, std::span<double> row);

  MotionModel nominal_;
  std::vector<synthesis::Variable> variables_;
};

}  // namespace cognate::problems
