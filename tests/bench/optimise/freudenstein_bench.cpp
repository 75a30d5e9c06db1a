/// Fits of Freudenstein's equation over a grid of 48 × 48 start angles, each reweighted twice: in
/// SIMD lanes from unit vectors, and one after the other by the dense fit with its trigonometry;
/// one thread each. `fits` counts pairs of start angles per second.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/freudenstein.hpp"
#include "synthesis/lanes/function_fit.hpp"

namespace cognate::synthesis {
namespace {

constexpr int kGrid = 48, kReweightings = 2;

double start(int i) {
  return kPi * (i + 0.5) / kGrid;
}

/// The logarithm of a decade over a quarter turn of each link.
std::vector<AnglePair> logarithm() {
  std::vector<AnglePair> pairs;
  for (int i = 0; i < 21; ++i) {
    const double share = i / 20.0, turn = kRightAngle;
    pairs.push_back({turn * share, turn * std::log10(1 + 9 * share)});
  }
  return pairs;
}

void count(benchmark::State& state) {
  state.counters["fits"] =
      benchmark::Counter(double(state.iterations()) * kGrid * kGrid, benchmark::Counter::kIsRate);
}

void lanes(benchmark::State& state) {
  const std::vector<AnglePair> wanted = logarithm();
  StartAngles starts(kGrid * kGrid);
  for (std::size_t i = 0; i < starts.input_x.size(); ++i) {
    const double input = start(static_cast<int>(i) / kGrid);
    const double output = start(static_cast<int>(i) % kGrid);
    starts.input_x[i] = std::cos(input);
    starts.input_y[i] = std::sin(input);
    starts.output_x[i] = std::cos(output);
    starts.output_y[i] = std::sin(output);
  }
  for (auto _ : state) {
    fit_freudenstein(wanted, kReweightings, starts);
    benchmark::DoNotOptimize(starts.ratios[0].data());
  }
  count(state);
}
BENCHMARK(lanes)->Unit(benchmark::kMillisecond);

double dense_fit(std::vector<AnglePair> pairs, double input_start, double output_start) {
  for (AnglePair& pair : pairs) {
    pair.input += input_start;
    pair.output += output_start;
  }
  auto ratios = freudenstein_fit(pairs);
  std::vector<double> weights(pairs.size());
  for (int k = 0; ratios && k < kReweightings; ++k) {
    double mean = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [input, output] = pairs[i];
      const double slope =
          ratios->p[0] * std::sin(output) + ratios->p[1] * std::sin(output - input);
      weights[i] = slope * slope;
      mean += weights[i] / double(pairs.size());
    }
    for (double& weight : weights) weight = 1 / (weight + 1e-3 * mean);
    ratios = freudenstein_fit(pairs, weights);
  }
  return ratios ? ratios->p[0] : 0;
}

void dense(benchmark::State& state) {
  const std::vector<AnglePair> wanted = logarithm();
  for (auto _ : state) {
    for (int i = 0; i < kGrid; ++i) {
      for (int j = 0; j < kGrid; ++j) {
        benchmark::DoNotOptimize(dense_fit(wanted, start(i), start(j)));
      }
    }
  }
  count(state);
}
BENCHMARK(dense)->Name("one by one")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
