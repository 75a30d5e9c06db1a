/// @file How a body moves at an instant: its pole, the circles of its points' curvatures, and the
/// points whose paths keep their curvature.
#pragma once

#include <span>

#include "analysis/mechanism/followed_motion.hpp"
#include "problems/evaluation/column_plan.hpp"

namespace cognate::problems {

/// What the columns of a body are called after its name, all lengths: the pole, by its place in the
/// plane and in the body's axes (its paths are the fixed and the moving centrode); the inflection
/// circle, the return circle of the same diameter, and Bresse's second circle, of the points
/// without tangential acceleration; the acceleration pole; Ball's point; M and N of the cubic of
/// stationary curvature (see stationary_curvature.hpp). Last, where the body slides, as a coupler
/// does while the cranks are parallel, the straight line that the inflection circle then is: a
/// point and the direction, in degrees.
std::span<const char* const> instant_geometry_columns();

/// Whether a column is one of that line, which hardly any motion stands at: those without a value
/// are left out of tables.
bool is_inflection_line(const Column& column);

/// Writes the columns of `ColumnPlan::instants`. One for each thread.
class InstantGeometryFiller {
 public:
  /// `assembly_ranges`: of the whole sweep.
  InstantGeometryFiller(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges)
      : problem_(problem), motion_(problem.mechanism.mechanism, assembly_ranges) {}

  /// Writes `row`. What is not defined there keeps its NaN: of a body that does not turn all but
  /// the inflection line and the acceleration pole, Ball's point and the cubic of one whose pole
  /// stands still, M or N of a cubic that falls apart.
  void fill(ColumnPlan& plan, int row);

 private:
  const AnalysisProblem& problem_;
  FollowedMotion<3> motion_;
};

}  // namespace cognate::problems
