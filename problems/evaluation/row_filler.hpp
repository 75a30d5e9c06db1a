/// @file One row of an analysis: the mechanism at one position of the drive.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/mechanism/followed_motion.hpp"
#include "problems/evaluation/closure_residual.hpp"
#include "problems/evaluation/column_plan.hpp"
#include "problems/evaluation/force_filler.hpp"

namespace cognate::problems {

/// What is known of a row besides its columns.
struct RowState {
  int open_dyad = kNone;    ///< the first dyad that is not assembled; kNone where all are
  bool dead_point = false;  ///< where rates are infinite, and forces with them
  double residual = 0;      ///< closure_residual
  double extent = 0;        ///< of the placements
  PowerCheck power;
};

/// Computes rows of the table, each from the drive's position alone, derivatives up to `Order`. One
/// for each thread.
template <int Order>
class RowFiller {
 public:
  /// `assembly_ranges`: of the whole sweep.
  RowFiller(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges)
      : problem_(problem),
        motion_(problem.mechanism.mechanism, assembly_ranges),
        described_(problem.mechanism.mechanism) {}

  /// Writes `row` of every column of motion in `plan`; they have their full size and hold NaN. A
  /// row that does not close keeps its NaN but for the drive.
  RowState fill(ColumnPlan& plan, int row);

  /// The state of the row filled last.
  std::span<const BodyMotion<double, Order>> bodies() const { return motion_.bodies(); }

 private:
  using Values = std::array<double, Order + 1>;

  RowState state();
  int open_dyad(double drive);
  void write_bodies();
  void write_slides();
  void write_points();
  void write_transmissions();

  void put(ColumnIndex column, double value) {
    plan_->columns[static_cast<std::size_t>(column)].values[row_] = value;
  }
  void put(const CoordinateColumns& columns, const Values& derivatives);
  void put(const CoordinateColumns& columns, const std::array<Vec2d, Order + 1>& derivatives);

  const AnalysisProblem& problem_;
  FollowedMotion<Order> motion_;
  MechanismMotion<0> described_;  ///< in the assemblies of the file, to find what does not close
  std::vector<Placement> placements_;
  ColumnPlan* plan_ = nullptr;
  std::size_t row_ = 0;
};

}  // namespace cognate::problems
