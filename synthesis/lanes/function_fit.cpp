#include "synthesis/lanes/function_fit.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/parallel.hpp"

namespace cognate::synthesis {
namespace {

/// Starts that one call of a kernel takes: enough that its lanes are seldom without work.
constexpr int kBlock = 64;

struct Kernels {
  void (*freudenstein)(const FreudensteinTask& task);
  void (*screen)(const FunctionScreenTask& task);
  void (*fit)(const FunctionFitTask& task);
};

Kernels kernels_of(InstructionSet set) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return {sse2::fit_freudenstein, sse2::screen_functions, sse2::fit_functions};
    case InstructionSet::avx2:
      return {avx2::fit_freudenstein, avx2::screen_functions, avx2::fit_functions};
    case InstructionSet::avx512:
      return {avx512::fit_freudenstein, avx512::screen_functions, avx512::fit_functions};
#endif
    default:
      return {scalar::fit_freudenstein, scalar::screen_functions, scalar::fit_functions};
  }
}

/// Wanted pairs as directions.
struct Directions {
  std::vector<double> half_input_x, half_input_y, output_x, output_y;

  explicit Directions(std::span<const AnglePair> wanted) {
    for (const AnglePair& pair : wanted) {
      half_input_x.push_back(std::cos(0.5 * pair.input));
      half_input_y.push_back(std::sin(0.5 * pair.input));
      output_x.push_back(std::cos(pair.output));
      output_y.push_back(std::sin(pair.output));
    }
  }

  FunctionTargets targets() const {
    return {static_cast<int>(output_x.size()), half_input_x.data(), half_input_y.data(),
            output_x.data(), output_y.data()};
  }
};

/// A block of starts on its way through a kernel.
class Block {
 public:
  explicit Block(std::span<FunctionFitState> states) : states_(states) {
    double* to = state_;
    for (const FunctionFitState& from : states) {
      to = std::ranges::copy(from.length, to).out;
      for (const double number :
           {std::cos(0.5 * from.input_start), std::sin(0.5 * from.input_start),
            std::cos(from.output_start), std::sin(from.output_start), from.assembly}) {
        *to++ = number;
      }
    }
  }

  void run(FunctionFitTask task, void (*kernel)(const FunctionFitTask& task)) {
    task.starts = static_cast<int>(states_.size());
    task.state = state_;
    task.cost = cost_;
    task.iterations = iterations_;
    kernel(task);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const double* from = state_ + i * kFunctionStateSize;
      std::copy_n(from, 4, states_[i].length.begin());
      states_[i].input_start = 2 * std::atan2(from[5], from[4]);
      states_[i].output_start = std::atan2(from[7], from[6]);
      states_[i].cost = cost_[i];
      states_[i].iterations = iterations_[i];
    }
  }

 private:
  std::span<FunctionFitState> states_;
  double state_[kBlock * kFunctionStateSize];
  double cost_[kBlock];
  int iterations_[kBlock];
};

FunctionFitTask task_of(const FunctionFit& problem, const Directions& wanted,
                        const FunctionFitOptions& options) {
  FunctionFitTask task{};
  task.targets = wanted.targets();
  task.unknowns = static_cast<int>(problem.free.size());
  task.unknown = problem.free.data();
  task.lower = problem.lower.data();
  task.upper = problem.upper.data();
  task.limits = problem.limits.data();
  task.limit_count = static_cast<int>(problem.limits.size());
  task.limits_transmission = problem.transmission_cosine.has_value();
  if (problem.transmission_cosine) {
    task.least_cosine = problem.transmission_cosine->front();
    task.greatest_cosine = problem.transmission_cosine->back();
  }
  task.penalty = options.penalty;
  task.most_iterations = options.most_iterations;
  task.tolerance = options.tolerance;
  task.negligible = options.negligible;
  return task;
}

}  // namespace

void fit_functions(const FunctionFit& problem, std::span<FunctionFitState> states,
                   const FunctionFitOptions& options) {
  const auto sets = instruction_sets();
  const bool has = options.set && std::ranges::find(sets, *options.set) != sets.end();
  const auto kernel = kernels_of(has ? *options.set : sets.back()).fit;
  const Directions wanted(problem.wanted);
  const FunctionFitTask task = task_of(problem, wanted, options);
  const int count = static_cast<int>(states.size()), blocks = (count + kBlock - 1) / kBlock;
  parallel_for(blocks, options.threads, [&](int index, int) {
    if (options.stop && options.stop()) return;
    const int first = index * kBlock;
    Block(states.subspan(first, std::min(kBlock, count - first))).run(task, kernel);
  });
}

void fit_freudenstein(std::span<const AnglePair> wanted, int reweightings, StartAngles& starts) {
  const Directions directions(wanted);
  FreudensteinTask task{};
  task.targets = directions.targets();
  task.reweightings = reweightings;
  task.count = static_cast<long>(starts.input_x.size());
  task.input_x = starts.input_x.data();
  task.input_y = starts.input_y.data();
  task.output_x = starts.output_x.data();
  task.output_y = starts.output_y.data();
  for (std::size_t i = 0; i < starts.ratios.size(); ++i) task.ratio[i] = starts.ratios[i].data();
  kernels_of(instruction_sets().back()).freudenstein(task);
}

void screen(std::span<const AnglePair> wanted, OutputStart start, FunctionCandidates& candidates) {
  const Directions directions(wanted);
  FunctionScreenTask task{};
  task.targets = directions.targets();
  task.count = static_cast<long>(candidates.crank.size());
  task.crank = candidates.crank.data();
  task.coupler = candidates.coupler.data();
  task.rocker = candidates.rocker.data();
  task.frame = candidates.frame.data();
  task.half_start_x = candidates.half_start_x.data();
  task.half_start_y = candidates.half_start_y.data();
  if (start == OutputStart::given) {
    task.output_start_x = candidates.output_start_x.data();
    task.output_start_y = candidates.output_start_y.data();
  }
  task.open = candidates.open.data();
  task.crossed = candidates.crossed.data();
  kernels_of(instruction_sets().back()).screen(task);
}

}  // namespace cognate::synthesis
