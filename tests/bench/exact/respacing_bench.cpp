/// Time for levelling the peaks of the structural error, from the linkages through Chebyshev's
/// points.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/chebyshev.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"
#include "synthesis/exact/respacing.hpp"

namespace cognate::synthesis {
namespace {

constexpr double degree = kPi / 180;

/// log₁₀ x on [1, 2], 60° → 60°.
double wanted(double turned) {
  return 60 * degree * std::log2(1 + turned / (60 * degree));
}

void five_points_level(benchmark::State& state) {
  std::vector<PrecisionPoint> points;
  for (const double turned : chebyshev_spacing(0, 60 * degree, 5)) {
    points.push_back({turned, {wanted(turned)}, 1});
  }
  std::vector<GeneratingFourBar> starts;
  for (const FourBarFunction& found : four_bar_functions(points, {}).solutions) {
    if (found.outcome != FourBarOutcome::linkage) continue;
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      starts.push_back({found.links, assembly, found.input_start, found.output_start});
    }
  }
  const RespacingTask task{wanted, 0, 60 * degree, true, true};
  std::size_t level = 0;
  for (auto _ : state) {
    level = 0;
    for (const GeneratingFourBar& start : starts) {
      level += equal_peaks(task, start).outcome == RespacingOutcome::level;
    }
  }
  state.counters["level"] = double(level);
}
BENCHMARK(five_points_level);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
