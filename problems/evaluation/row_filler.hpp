/// @file One row of an analysis: the mechanism at one position of the drive.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/mechanism/mechanism.hpp"
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

/// Where `point` stands.
Vec2d place(std::span<const Placement> bodies, const Attached<double>& point);

/// The greatest distance between two pins that should be one, or of a slider's pin from its line,
/// in the mechanism's unit of length. Computed from the links' lengths and the placements alone,
/// with none of the closure's formulas.
double closure_residual(const Mechanism<double>& mechanism, std::span<const Placement> bodies);

/// The greatest distance of a body's origin from the global origin: what rounding of the placements
/// is proportional to.
double extent(std::span<const Placement> bodies);

/// What is known of a row apart from its columns.
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
  bool place_described(double drive);
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
