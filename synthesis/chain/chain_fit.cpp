#include "synthesis/chain/chain_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/chain/chain_fit_kernel.hpp"

namespace cognate::synthesis {
namespace {

/// Starts that one call of a kernel takes: enough that its lanes are seldom without work.
constexpr int kChainBlock = 32;
constexpr std::size_t kMostLanes = 8;

using ChainKernel = void (*)(const ChainFitTask& task);

ChainKernel chain_kernel_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return sse2::fit_chains;
    case InstructionSet::avx2:
      return avx2::fit_chains;
    case InstructionSet::avx512:
      return avx512::fit_chains;
#endif
    default:
      return scalar::fit_chains;
  }
}

struct Directions {
  std::vector<double> x, y;

  void add(double angle) {
    x.push_back(std::cos(angle));
    y.push_back(std::sin(angle));
  }
};

Directions around(int count) {
  Directions directions;
  for (int i = 0; i < count; ++i) directions.add(2 * std::numbers::pi * i / count);
  return directions;
}

Directions of(const std::vector<double>& angles) {
  Directions directions;
  for (const double angle : angles) directions.add(angle);
  return directions;
}

/// The numbers of a block of starts, one after the other.
struct ChainBlock {
  std::vector<double> parameter, side, angle, cost;
  std::vector<int> iterations;
  std::vector<double> workspace;

  ChainBlock(std::size_t points, std::span<const ChainFitState> states)
      : cost(states.size()),
        iterations(states.size()),
        workspace(points * kChainWorkPerPoint * kMostLanes) {
    for (const ChainFitState& state : states) {
      parameter.insert(parameter.end(), state.design.parameters.begin(),
                       state.design.parameters.end());
      side.insert(side.end(), state.design.side.begin(), state.design.side.end());
      angle.insert(angle.end(), state.angles.begin(), state.angles.end());
    }
  }

  void store(std::span<ChainFitState> states) const {
    auto parameters = parameter.begin();
    auto angles = angle.begin();
    for (std::size_t i = 0; i < states.size(); ++i) {
      ChainFitState& to = states[i];
      for (double& value : to.design.parameters) value = *parameters++;
      for (double& value : to.angles) value = *angles++;
      to.cost = cost[i];
      to.iterations = iterations[i];
    }
  }
};

}  // namespace

void fit_chains(const ChainFit& problem, std::span<ChainFitState> states,
                const ChainFitOptions& options) {
  const auto sets = instruction_sets();
  const bool has = options.set && std::ranges::find(sets, *options.set) != sets.end();
  const ChainKernel kernel = chain_kernel_of(has ? *options.set : sets.back());
  const std::vector<PlacedLine> lines = placed_lines(problem.chain);
  const Directions checks = around(problem.checks), cranks = of(problem.crank_angles);
  ChainFitTask task{};
  task.line = lines.data();
  task.lines = static_cast<int>(lines.size());
  task.parameters = parameter_count(problem.chain);
  task.trace = problem.trace;
  task.points = static_cast<int>(problem.x.size());
  task.target_x = problem.x.data();
  task.target_y = problem.y.data();
  task.root_weight = problem.root_weight.data();
  task.heading = problem.heading;
  task.heading_x = problem.heading_x.data();
  task.heading_y = problem.heading_y.data();
  task.angle_weight = problem.angle_weight;
  const bool timed = !problem.crank_angles.empty();
  task.crank_x = timed ? cranks.x.data() : nullptr;
  task.crank_y = timed ? cranks.y.data() : nullptr;
  task.closed = problem.closed;
  task.unknowns = static_cast<int>(problem.free.size());
  task.unknown = problem.free.data();
  task.lower = problem.lower.data();
  task.upper = problem.upper.data();
  task.joints = static_cast<int>(problem.joints.size());
  task.joint = problem.joints.data();
  task.cosine_limit = problem.cosine_limit;
  task.checks = problem.checks;
  task.check_x = checks.x.data();
  task.check_y = checks.y.data();
  task.penalty = options.penalty;
  task.most_iterations = options.most_iterations;
  task.tolerance = options.tolerance;
  task.negligible = options.negligible;
  task.early = options.early;
  task.late = options.late;
  task.early_cost = options.early_cost;
  task.late_cost = options.late_cost;

  const int count = static_cast<int>(states.size());
  const int blocks = (count + kChainBlock - 1) / kChainBlock;
  parallel_for(blocks, options.threads, [&](int index, int) {
    if (options.stop && options.stop()) return;
    const int first = index * kChainBlock;
    const auto block = states.subspan(first, std::min(kChainBlock, count - first));
    ChainBlock own(problem.x.size(), block);
    ChainFitTask part = task;
    part.starts = static_cast<int>(block.size());
    part.parameter = own.parameter.data();
    part.side = own.side.data();
    part.angle = own.angle.data();
    part.cost = own.cost.data();
    part.iterations = own.iterations.data();
    part.workspace = own.workspace.data();
    kernel(part);
    own.store(block);
  });
}

}  // namespace cognate::synthesis
