// Screens and fits function generators, one in each lane. Compiled once for each instruction set:
// COGNATE_ISA names it, see lane_numbers.hpp.
#include "synthesis/lanes/function_fit_kernel.hpp"

#include "synthesis/lanes/freudenstein_lanes.hpp"
#include "synthesis/lanes/function_lanes.hpp"

namespace cognate::synthesis::COGNATE_ISA {

void fit_freudenstein(const FreudensteinTask& task) {
  fit_all(task);
}

void screen_functions(const FunctionScreenTask& task) {
  screen(task, 1, task.open);
  screen(task, -1, task.crossed);
}

void fit_functions(const FunctionFitTask& task) {
  FunctionLanes problem(task);
  LaneFit<FunctionLanes> fit(problem, {task.most_iterations, task.tolerance, task.negligible});
  fit.run();
}

}  // namespace cognate::synthesis::COGNATE_ISA
