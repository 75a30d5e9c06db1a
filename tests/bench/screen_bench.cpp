/// Time for one position in the screening of timed paths, fit of the linear unknowns included.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "synthesis/lanes/path_screen.hpp"

namespace cognate {
namespace {

constexpr std::size_t designs = 1024;

/// Crank-rockers and crank angles, enough of them that no branch is learned by heart.
struct Inputs {
  std::array<Lengths<double>, designs> links;
  std::array<double, designs> theta;
  Inputs() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> longer(2.5, 3.5), angle(0, 6.28);
    for (std::size_t i = 0; i < designs; ++i) {
      links[i] = {1, longer(random), longer(random), longer(random)};
      theta[i] = angle(random);
    }
  }
};
const Inputs inputs;

void screen_ten_points(benchmark::State& state) {
  constexpr int points = 10;
  std::array<double, points> half_cos{}, half_sin{}, x{}, y{}, weight{};
  for (std::size_t j = 0; j < points; ++j) {
    half_cos[j] = std::cos(0.3 * double(j));
    half_sin[j] = std::sin(0.3 * double(j));
    x[j] = std::cos(0.6 * double(j));
    y[j] = 0.5 * std::sin(0.6 * double(j));
    weight[j] = 1;
  }
  synthesis::SeparableTarget target;
  target.half_cos = half_cos.data();
  target.half_sin = half_sin.data();
  target.x = x.data();
  target.y = y.data();
  target.weight = weight.data();
  target.count = points;
  target.weight_sum = points;
  for (double& limit : target.greatest) limit = 1e3;
  synthesis::PathCandidates candidates(designs);
  for (std::size_t i = 0; i < designs; ++i) {
    candidates.coupler[i] = inputs.links[i].coupler;
    candidates.rocker[i] = inputs.links[i].rocker;
    candidates.frame[i] = inputs.links[i].frame;
    candidates.phase_cos[i] = std::cos(0.5 * inputs.theta[i]);
    candidates.phase_sin[i] = std::sin(0.5 * inputs.theta[i]);
  }
  for (auto _ : state) {
    synthesis::screen(target, candidates);
    benchmark::DoNotOptimize(candidates.open.data());
  }
  state.SetLabel(synthesis::screen_instruction_set());
  const double positions = 2.0 * points * designs;  // both assemblies
  state.counters["per_position"] = benchmark::Counter(
      positions, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(screen_ten_points);

}  // namespace
}  // namespace cognate

BENCHMARK_MAIN();
