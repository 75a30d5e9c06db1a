/// @file The solvers of other libraries behind one signature; internal to the dispatch.
#pragma once

#include <vector>

#include "synthesis/optimise/dense_model.hpp"

namespace cognate::synthesis {

/// What a foreign solver said. Where it ended the model remembers.
struct Outcome {
  Stop stop = Stop::failed;
  int iterations = 0;
  std::vector<double> multipliers;
  Eigen::VectorXd end;  ///< of a global search: its best point by its own measure
};

// Each minimises `model`, which has at least one unknown and a value at its start.
Outcome minimise_with_ceres(DenseModel& model, const Options& options);
Outcome minimise_with_ipopt(DenseModel& model, const Options& options);
/// One of NLopt that descends from the start.
Outcome minimise_with_nlopt(Solver solver, DenseModel& model, const Options& options);

/// A global search and descents from the best that it found: where there are constraints, the best
/// that nearly met them and the best by the search's own measure. If the start is still better, a
/// descent from there.
Solution search_globally(Solver solver, const Model& model, std::span<const double> start,
                         const Options& options);

}  // namespace cognate::synthesis
