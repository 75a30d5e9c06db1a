// Time of the complete solution of Alt's problem and of its siblings with poses, and of the start
// sets, for each instruction set and number of threads of this machine. The targets are 16 sets of
// random points, in turn; `roots` is how many solutions they have had on average, `lost` how many
// paths. The instruction set "scalar" is what the others are to be compared with.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "synthesis/exact/nine_point/nine_point.hpp"
#include "synthesis/exact/nine_point/start_set.hpp"

namespace cognate::synthesis {
namespace {

std::vector<std::vector<PathPose>> random_targets(int poses) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<std::vector<PathPose>> targets(16);
  for (auto& target : targets) {
    for (int j = 0; j < 10 - poses; ++j) {
      PathPose at{{normal(random), normal(random)}, {}};
      if (j < poses && poses > 1) at.angle = normal(random);
      target.push_back(at);
    }
  }
  return targets;
}

void solve_target(benchmark::State& state, int poses, InstructionSet set, int threads) {
  const auto targets = random_targets(poses);
  ExactPathOptions options;
  options.set = set;
  options.threads = threads;
  solve_exact_path(targets[0], options);  // finds the start set
  double roots = 0, lost = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    const auto found = solve_exact_path(targets[next++ % targets.size()], options);
    roots += found.finite;
    lost += found.lost + found.duplicates;
  }
  state.counters["roots"] = roots / static_cast<double>(state.iterations());
  state.counters["lost"] = lost / static_cast<double>(state.iterations());
}

void find_start(benchmark::State& state, int poses, InstructionSet set, int threads) {
  nine_point::TrackingOptions means;
  means.set = set;
  means.threads = threads;
  nine_point::MonodromyCounts counts;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        nine_point::find_start_set({poses, 10 - 2 * poses}, means, &counts, 1));
  }
  state.counters["paths"] = double(counts.paths) / static_cast<double>(state.iterations());
}

void add_benchmarks() {
  for (const InstructionSet set : instruction_sets()) {
    for (const int threads : {1, 2}) {
      for (int poses = 1; poses <= 5; ++poses) {
        const std::string name = std::to_string(poses) + "_poses_" +
                                 std::to_string(10 - 2 * poses) + "_points/" + cognate::name(set) +
                                 "/threads:" + std::to_string(threads);
        const auto add = [&](const std::string& prefix, auto run) {
          benchmark::RegisterBenchmark(
              (prefix + name).c_str(),
              [=](benchmark::State& state) { run(state, poses, set, threads); })
              ->Unit(benchmark::kMillisecond)
              ->UseRealTime()
              ->MeasureProcessCPUTime();
        };
        add("solve/", solve_target);
        add("start/", find_start);
      }
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  cognate::synthesis::add_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
}
