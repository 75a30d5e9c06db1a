/// @file What a study of four-bars wants of its designs, made out once.
#pragma once

#include <optional>
#include <vector>

#include "problems/evaluation/problem.hpp"
#include "problems/study/four_bar_designs.hpp"
#include "problems/study/four_bar_quantities.hpp"
#include "problems/study/four_bar_screen.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

struct FourBarPlan {
  AnalysisProblem base;
  std::vector<DesignVariable> dimensions;  ///< of each variable
  std::vector<FourBarQuantity> columns;
  std::vector<FourBarFilter> filters;  ///< by stage
  bool wants_swing = false;

  const FourBar& linkage() const { return *base.mechanism.four_bar(); }

  /// Whether a column or a filter is of one of these stages.
  bool wants(FourBarStage from, FourBarStage to) const;
};

/// What `study` wants where four-bars in batches can give it: its base analyses a four-bar over a
/// turn of its crank at least and a hundred at most, only dimensions vary, and all that it names is
/// a `four_bar_quantity`. Filters refer to those of `study`, which outlives the plan.
std::optional<FourBarPlan> four_bar_plan(const Study& study);

/// Whether a row of the drive's table falls where a crank that does not turn fully can be.
bool has_closed_row(const DriveSweep& drive, const FourBar& linkage);

}  // namespace cognate::problems
