/// Compares the straight segments that studies give with the longest there are: those
/// between all pairs of 6144 samples, of random crank-rockers and double-cranks.
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <random>
#include <vector>

#include "analysis/coupler_curve/closed_segment.hpp"
#include "analysis/linkage/mobility.hpp"

namespace cognate::bench {
namespace {

constexpr std::size_t kCurves = 100;
constexpr std::size_t kDense = 6144;

std::vector<FourBar> linkages() {
  std::mt19937_64 random(3);
  const auto draw = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::vector<FourBar> drawn;
  while (drawn.size() < kCurves) {
    const FourBar linkage{{0, 0},
                          {draw(1.5, 5.5), 0},
                          1,
                          draw(1.5, 5.5),
                          draw(1.5, 5.5),
                          Assembly::open,
                          Vec2d{draw(-2, 5), draw(-3, 3)}};
    if (can_assemble(lengths(linkage)) && crank_rotates(lengths(linkage))) drawn.push_back(linkage);
  }
  return drawn;
}

double longest_of_all_pairs(const FourBar& linkage, const CycleTable& table, double relative) {
  static CurveRoom curve;
  static SampledSegments segments;
  sample_circuit(linkage, {}, table, curve);
  std::vector<Vec2d> points;
  for (std::size_t i = 0; i < kDense; ++i) points.push_back({curve.x[i], curve.y[i]});
  return segments.longest(points, true, relative).length;
}

double microseconds_since(std::clock_t begin) {
  return 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

void print_row(const std::vector<FourBar>& all, double relative) {
  const CycleTable few(samples_for_segments(relative)), dense(kDense);
  ClosedSegmentFinder finder;
  CurveRoom curve;
  std::vector<double> found, off;
  const std::clock_t begin = std::clock();
  for (const FourBar& linkage : all) {
    sample_circuit(linkage, {}, few, curve);
    found.push_back(finder(curve.samples(), relative));
  }
  const double own = microseconds_since(begin);
  const std::clock_t again = std::clock();
  for (std::size_t i = 0; i < all.size(); ++i) {
    off.push_back(100 * (found[i] / longest_of_all_pairs(all[i], dense, relative) - 1));
  }
  const double pairs = microseconds_since(again);
  std::ranges::sort(off);
  fmt::print("| {} % | {} | {:.1f} | {:.1f} | {:.1f} | {:.0f} | {:.0f} |\n", 100 * relative,
             samples_for_segments(relative), off.front(), off[off.size() / 2], off.back(),
             own / kCurves, pairs / own);
}

void run() {
  fmt::print(
      "Length against the longest, in per cent, and the processor time of both.\n\n"
      "| δ/L | samples | least | median | most | µs | all pairs take |\n"
      "| ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  const auto all = linkages();
  for (const double relative : {1e-3, 1e-2}) print_row(all, relative);
}

}  // namespace
}  // namespace cognate::bench

int main() {
  cognate::bench::run();
}
