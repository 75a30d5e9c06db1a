#include "synthesis/lanes/path_fit.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/parallel.hpp"

namespace cognate::synthesis {
namespace {

/// Starts that one call of a kernel takes: enough that its lanes are seldom without work.
constexpr int kPathBlock = 64;

using Kernel = void (*)(const PathFitTask& task);

Kernel kernel_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return sse2::fit_paths;
    case InstructionSet::avx2:
      return avx2::fit_paths;
    case InstructionSet::avx512:
      return avx512::fit_paths;
#endif
    default:
      return scalar::fit_paths;
  }
}

struct alignas(kLaneAlignment) Line {
  double values[kLaneAlignment / sizeof(double)];
};

/// The memory of one thread's kernel.
struct Workspace {
  std::vector<double> state, crank_half, cost;
  std::vector<int> iterations;
  std::vector<Line> lines;

  explicit Workspace(std::size_t points)
      : state(std::size_t{kPathBlock} * kPathStateSize),
        crank_half(2 * points * kPathBlock),
        cost(kPathBlock),
        iterations(kPathBlock),
        lines(points * kPathWorkPerPoint * sizeof(double) / sizeof(Line)) {}

  void load(std::span<const PathFitState> block) {
    double* to = state.data();
    double* half = crank_half.data();
    for (const PathFitState& from : block) {
      to = std::copy(from.value.begin(), from.value.end(), to);
      for (const double number :
           {from.frame_x, from.frame_y, from.half_phase_x, from.half_phase_y, from.assembly}) {
        *to++ = number;
      }
      half = std::copy(from.crank_half.begin(), from.crank_half.end(), half);
    }
  }

  void store(std::span<PathFitState> block) const {
    for (std::size_t i = 0; i < block.size(); ++i) {
      PathFitState& to = block[i];
      const double* from = state.data() + i * kPathStateSize;
      std::copy_n(from, to.value.size(), to.value.begin());
      to.frame_x = from[8];
      to.frame_y = from[9];
      to.half_phase_x = from[10];
      to.half_phase_y = from[11];
      std::copy_n(crank_half.data() + i * to.crank_half.size(), to.crank_half.size(),
                  to.crank_half.begin());
      to.cost = cost[i];
      to.iterations = iterations[i];
    }
  }
};

PathFitTask task_of(const PathFit& problem, const PathFitOptions& options) {
  PathFitTask task{};
  task.points = static_cast<int>(problem.x.size());
  task.target_x = problem.x.data();
  task.target_y = problem.y.data();
  task.root_weight = problem.root_weight.data();
  task.unknowns = static_cast<int>(problem.free.size());
  task.unknown = problem.free.data();
  task.lower = problem.lower.data();
  task.upper = problem.upper.data();
  task.is_timed = problem.is_timed.data();
  task.any_free = std::ranges::count(problem.is_timed, 0) > 0;
  task.counted_from_x = problem.counted_from_x;
  task.anchored_at_d = problem.anchored_at_d;
  task.limits = problem.limits.data();
  task.limit_count = static_cast<int>(problem.limits.size());
  std::copy(problem.box.begin(), problem.box.end(), task.box);
  task.boxed = std::ranges::any_of(problem.box, [](double side) { return std::isfinite(side); });
  task.limits_transmission = problem.transmission_cosines.has_value();
  if (problem.transmission_cosines) {
    task.least_cosine = problem.transmission_cosines->front();
    task.greatest_cosine = problem.transmission_cosines->back();
  }
  task.penalty = options.penalty;
  task.most_iterations = options.most_iterations;
  task.tolerance = options.tolerance;
  task.negligible = options.negligible;
  return task;
}

}  // namespace

void fit_paths(const PathFit& problem, std::span<PathFitState> states,
               const PathFitOptions& options) {
  const auto sets = instruction_sets();
  const bool has = options.set && std::ranges::find(sets, *options.set) != sets.end();
  const Kernel kernel = kernel_of(has ? *options.set : sets.back());
  const int count = static_cast<int>(states.size()), blocks = (count + kPathBlock - 1) / kPathBlock;
  const int threads = std::min(thread_count(options.threads), std::max(1, blocks));
  std::vector<Workspace> workspaces(threads, Workspace(problem.x.size()));
  parallel_for(blocks, threads, [&](int index, int thread) {
    if (options.stop && options.stop()) return;
    const int first = index * kPathBlock;
    const auto block = states.subspan(first, std::min(kPathBlock, count - first));
    Workspace& own = workspaces[thread];
    own.load(block);
    PathFitTask task = task_of(problem, options);
    task.starts = static_cast<int>(block.size());
    task.state = own.state.data();
    task.crank_half = own.crank_half.data();
    task.cost = own.cost.data();
    task.iterations = own.iterations.data();
    task.workspace = own.lines.front().values;
    kernel(task);
    own.store(block);
  });
}

}  // namespace cognate::synthesis
