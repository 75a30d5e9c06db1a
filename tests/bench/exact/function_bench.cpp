/// Time of exact function generation, against Newton's method from a grid of start angles.
#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"
#include "synthesis/exact/function/slider_crank_function.hpp"

namespace cognate::synthesis {
namespace {

constexpr std::size_t kProblems = 256;

/// Outputs that follow the inputs loosely: what a designer might ask, not what some linkage does.
std::vector<std::vector<PrecisionPoint>> problems(int count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> step(0.2, 0.6);
  std::vector<std::vector<PrecisionPoint>> all(kProblems);
  for (auto& points : all) {
    double input = 0, output = 0;
    for (int i = 0; i < count; ++i) {
      points.push_back({input, {output}});
      input += step(random);
      output += step(random);
    }
  }
  return all;
}

void four_bar(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const auto all = problems(count);
  GivenStart start;
  if (count < 5) start.input = 0.3;
  if (count < 4) start.output = 0.7;
  std::size_t i = 0, solutions = 0, solved = 0;
  for (auto _ : state) {
    const auto found = four_bar_functions(all[i++ % kProblems], start);
    solutions += found.solutions.size();
    ++solved;
    benchmark::DoNotOptimize(found);
  }
  state.counters["solutions"] = static_cast<double>(solutions) / static_cast<double>(solved);
}
BENCHMARK(four_bar)->Arg(3)->Arg(4)->Arg(5);

void slider_crank(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const auto all = problems(count);
  GivenStart start;
  if (count < 5) start.input = 0.3;
  if (count < 4) start.output = 0.7;
  std::size_t i = 0, solutions = 0, solved = 0;
  for (auto _ : state) {
    const auto found = slider_crank_functions(all[i++ % kProblems], start);
    solutions += found.solutions.size();
    ++solved;
    benchmark::DoNotOptimize(found);
  }
  state.counters["solutions"] = static_cast<double>(solutions) / static_cast<double>(solved);
}
BENCHMARK(slider_crank)->Arg(3)->Arg(4)->Arg(5);

using Vector = Eigen::Matrix<double, 5, 1>;

/// Whether Newton's method arrives from some start angles.
bool newton(const std::vector<PrecisionPoint>& points, double phi, double psi) {
  Eigen::Matrix<double, 5, 3> m;
  Vector right;
  for (int i = 0; i < 5; ++i) {
    const auto& point = points[static_cast<std::size_t>(i)];
    const double t1 = point.input + phi, t3 = point.output[0] + psi;
    m.row(i) << std::cos(t1), std::cos(t3), 1;
    right[i] = std::cos(t1 - t3);
  }
  Vector x;
  x << m.householderQr().solve(right), phi, psi;
  for (int step = 0; step < 30; ++step) {
    Eigen::Matrix<double, 5, 5> slope;
    Vector r;
    for (int i = 0; i < 5; ++i) {
      const auto& point = points[static_cast<std::size_t>(i)];
      const double t1 = point.input + x[3], t3 = point.output[0] + x[4];
      const double c1 = std::cos(t1), c3 = std::cos(t3), s = std::sin(t1 - t3);
      r[i] = x[0] * c1 + x[1] * c3 + x[2] - std::cos(t1 - t3);
      slope.row(i) << c1, c3, 1, s - x[0] * std::sin(t1), -s - x[1] * std::sin(t3);
    }
    if (r.cwiseAbs().maxCoeff() < 1e-13 * (1 + x.cwiseAbs().maxCoeff())) return true;
    x -= slope.partialPivLu().solve(r);
    if (!x.allFinite()) return false;
  }
  return false;
}

/// The naive way to all five-point four-bars: 64 starts, and no word on whether all were found.
void five_points_by_newton_from_a_grid(benchmark::State& state) {
  const auto all = problems(5);
  constexpr int kGrid = 8;
  std::size_t i = 0;
  for (auto _ : state) {
    int arrived = 0;
    for (int j = 0; j < kGrid * kGrid; ++j) {
      arrived += newton(all[i % kProblems], kPi * (j / kGrid) / kGrid, kPi * (j % kGrid) / kGrid);
    }
    ++i;
    benchmark::DoNotOptimize(arrived);
  }
}
BENCHMARK(five_points_by_newton_from_a_grid);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
