/// Time for all solutions of a quick return, each confirmed by the analysis kernel.
#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "synthesis/exact/quick_return/guide.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"
#include "synthesis/exact/quick_return/shaper.hpp"
#include "synthesis/exact/quick_return/slider.hpp"

namespace cognate::synthesis {
namespace {

constexpr std::size_t tasks = 1024;

/// Tasks enough that no branch is learned by heart, each with a crank that its near arc allows.
struct Inputs {
  std::array<RockerTask, tasks> rocker;
  std::array<double, tasks> crank;
  Inputs() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> ratio(1.05, 1.8), swing(0.3, 1.2);
    for (std::size_t i = 0; i < tasks; ++i) {
      rocker[i] = {ratio(random), 1, swing(random)};
      const auto limits = arc_limits(rocker[i], PivotArc::near);
      crank[i] = 0.5 * (limits->crank.min + limits->crank.max);
    }
  }
};
const Inputs inputs;

template <class Solve>
void cycle(benchmark::State& state, const Solve& solve) {
  std::size_t i = 0, solved = 0;
  for (auto _ : state) {
    auto found = solve(i);
    benchmark::DoNotOptimize(found);
    solved += !found.empty();
    i = (i + 1) % tasks;
  }
  state.counters["solved"] = double(solved) / double(state.iterations());
}

void rocker_with_crank(benchmark::State& state) {
  cycle(state, [](std::size_t i) {
    return rockers_with_crank(inputs.rocker[i], inputs.crank[i]).designs;
  });
}

void rocker_on_line(benchmark::State& state) {
  cycle(state, [](std::size_t i) {
    return rockers_on_line(inputs.rocker[i], {1, 0.1, -inputs.crank[i]}).designs;
  });
}

void rocker_of_best_transmission(benchmark::State& state) {
  cycle(state, [](std::size_t i) { return best_rockers(inputs.rocker[i], {}).designs; });
}

void slider_with_offset(benchmark::State& state) {
  cycle(state, [](std::size_t i) {
    const SliderTask task{inputs.rocker[i].time_ratio, 2};
    return sliders_with_offset(task, 0.5 * slider_limits(task).offset.max).designs;
  });
}

void guide_with_frame(benchmark::State& state) {
  cycle(state, [](std::size_t i) { return guides_with_frame(inputs.rocker[i].time_ratio, 2, 0); });
}

/// With the ram followed over a whole turn, which is nearly all of it.
void shaper_followed(benchmark::State& state) {
  for (std::size_t i = 0; auto _ : state) {
    const auto found = shaper({inputs.rocker[i].time_ratio, 0.5, 0.3, {}, {}, 0.2, {}});
    benchmark::DoNotOptimize(simulate(found.shaper));
    i = (i + 1) % tasks;
  }
}

BENCHMARK(rocker_with_crank);
BENCHMARK(rocker_on_line);
BENCHMARK(rocker_of_best_transmission);
BENCHMARK(slider_with_offset);
BENCHMARK(guide_with_frame);
BENCHMARK(shaper_followed);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
