/// @file All rows of an analysis.
#pragma once

#include <vector>

#include "problems/evaluation/column_plan.hpp"
#include "problems/evaluation/row_filler.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The table filled, and the state of each of its rows.
struct Sweep {
  ColumnPlan plan;
  AssemblyRanges assembly_ranges;
  std::vector<RowState> rows;  ///< fewer than the problem has where the run was ended before
};

/// Evaluates `problem` at each of its rows, in blocks shared out over threads; every row depends on
/// its own drive position and the assembly ranges of the whole motion, so the number of
/// threads changes nothing. Where `deadline` is reached, the rows up to the first one that was not
/// evaluated are kept. The motion begins in the assemblies of the file and goes through change
/// points smoothly where it is determined.
///
/// Angles of bodies are continuous from row to row; the first is in (−180°, 180°]. What is not
/// finite (at a dead point, a cusp) is NaN.
Sweep sweep(const AnalysisProblem& problem, const Run& run, const Deadline& deadline);

}  // namespace cognate::problems
