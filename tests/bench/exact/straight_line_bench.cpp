/// Times of the local theory of straight lines, over a thousand crank-rockers and positions.
#include <benchmark/benchmark.h>

#include <numbers>
#include <random>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/joints.hpp"
#include "synthesis/exact/straight_line/contact_search.hpp"

namespace cognate::synthesis {
namespace {

std::vector<FamilyMember> members() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> length(0.8, 1.3), angle(-3, 3);
  std::vector<FamilyMember> all;
  while (all.size() < 1000) {
    const FourBar linkage{
        {0, 0}, {1, 0}, 0.3 * length(random), length(random), length(random), Assembly::open, {}};
    if (crank_rotates(lengths(linkage))) all.push_back({linkage, angle(random)});
  }
  return all;
}

void local_theory(benchmark::State& state) {
  const auto all = members();
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& [linkage, angle] = all[next++ % all.size()];
    benchmark::DoNotOptimize(straight_points(linkage, angle, 4));
  }
}
BENCHMARK(local_theory);

void five_point_positions(benchmark::State& state) {
  const auto all = members();
  std::size_t next = 0, found = 0;
  for (auto _ : state) found += straight_positions(all[next++ % all.size()].linkage, 5).size();
  state.counters["found"] = double(found) / double(next);
}
BENCHMARK(five_point_positions)->Unit(benchmark::kMillisecond);

void straight_length(benchmark::State& state) {
  const auto all = members();
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& [linkage, angle] = all[next++ % all.size()];
    const auto points = straight_points(linkage, angle, 4).points;
    if (points.empty()) continue;
    const Path path =
        path_of(as_mechanism(std::get<FourBar>(linkage)), {2, points[0].coupler_point});
    const auto forward = forward_interval(path, angle, *range_about(linkage, angle));
    if (forward) benchmark::DoNotOptimize(longest_segment(path, angle, *forward, 1e-3));
  }
}
BENCHMARK(straight_length)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
