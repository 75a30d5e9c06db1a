/// @file The forces of one row of an analysis.
#pragma once

#include <span>
#include <vector>

#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/joints.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/column_plan.hpp"

namespace cognate::problems {

/// What the balance of power says of a row's forces.
struct PowerCheck {
  double residual = 0;  ///< |drive from the reactions − drive by virtual work|, N·m or N
  double scale = 0;     ///< the drive, and the greatest that a reaction would need of it
};

/// Computes the driving torque or force and the reactions, as far as they are requested. One for
/// each thread.
class ForceFiller {
 public:
  /// `strokes`: one for each load, of the body it acts on.
  ForceFiller(const AnalysisProblem& problem, std::span<const Stroke> strokes);

  /// Writes the columns of forces at `row`, where the bodies move as `bodies` says. Where reactions
  /// are requested the driving torque comes from them, and is held against virtual work; else it
  /// comes from virtual work, and there is nothing to check.
  PowerCheck fill(ColumnPlan& plan, int row, std::span<const BodyMotion<double, 2>> bodies);

 private:
  void write_reactions(ColumnPlan& plan, std::size_t row,
                       std::span<const BodyMotion<double, 2>> bodies) const;
  PowerCheck check(double drive, std::span<const BodyMotion<double, 2>> bodies) const;

  const AnalysisProblem& problem_;
  JointList joints_;
  ActiveLoads loads_;
  InverseDynamics dynamics_;
  Forces forces_;
};

}  // namespace cognate::problems
