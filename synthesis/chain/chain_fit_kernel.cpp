// Fits chains to paths, one in each lane. Compiled once for each instruction set: COGNATE_ISA names
// it, see lane_numbers.hpp.
#include "synthesis/chain/chain_fit_kernel.hpp"

#include "synthesis/chain/chain_lanes.hpp"

namespace cognate::synthesis::COGNATE_ISA {

void fit_chains(const ChainFitTask& task) {
  ChainLanes problem(task);
  LaneFit<ChainLanes> fit(problem, {task.most_iterations, task.tolerance, task.negligible});
  fit.run();
}

}  // namespace cognate::synthesis::COGNATE_ISA
