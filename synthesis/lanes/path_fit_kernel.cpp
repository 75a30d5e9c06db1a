// Fits linkages to paths, one in each lane. Compiled once for each instruction set: COGNATE_ISA
// names it, see lane_numbers.hpp.
#include "synthesis/lanes/path_fit_kernel.hpp"

#include "synthesis/lanes/path_lanes.hpp"

namespace cognate::synthesis::COGNATE_ISA {

void fit_paths(const PathFitTask& task) {
  PathLanes problem(task);
  LaneFit<PathLanes> fit(problem, {task.most_iterations, task.tolerance, task.negligible});
  fit.run();
}

}  // namespace cognate::synthesis::COGNATE_ISA
