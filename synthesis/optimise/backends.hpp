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
};

// Each minimises `model`, which has at least one unknown and a value at its start.
Outcome minimise_with_ceres(DenseModel& model, const Options& options);
Outcome minimise_with_slsqp(DenseModel& model, const Options& options);
Outcome minimise_with_cobyla(DenseModel& model, const Options& options);
Outcome minimise_with_ipopt(DenseModel& model, const Options& options);

}  // namespace cognate::synthesis
