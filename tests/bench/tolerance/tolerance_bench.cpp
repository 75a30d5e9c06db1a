/// Samples of a four-bar with tolerances against the bare kernel on the same linkages, in one run:
/// tolerance_bench [SAMPLES [POSITIONS [THREADS]]]. Drawing and statistics are in the former alone.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "analysis/tolerance/sampling.hpp"
#include "analysis/tolerance/sensitivity.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/draws.hpp"

namespace {

using namespace cognate;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The bare kernel: places of the joint C of so many four-bars, in blocks that stay in the cache.
double bare(int samples, const CrankTable<double>& table, int threads) {
  constexpr std::size_t kBlock = 64;
  const int blocks = samples / static_cast<int>(kBlock);
  const auto begin = std::chrono::steady_clock::now();
  parallel_for(blocks, threads, [&](int block, int /*thread*/) {
    const std::vector<double> zero(kBlock), frame(kBlock, 110), side(kBlock, 1);
    const std::vector<double> crank(kBlock, 40 + 1e-6 * block), coupler(kBlock, 120),
        rocker(kBlock, 80);
    std::vector<double> x(kBlock * table.size()), y(x.size());
    const FourBarArrays<double> linkages{zero,    zero,   frame, zero,    crank,
                                         coupler, rocker, side,  coupler, zero};
    const FourBarColumns<double> columns{.x = x, .y = y};
    if (evaluate_batch(linkages, table, columns) != BatchStatus::done) std::abort();
  });
  return seconds_since(begin);
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int place, int usual) {
    return count > place ? std::atoi(arguments[place]) : usual;
  };
  const int samples = number(1, 1000000), positions = number(2, 360), threads = number(3, 2);
  FourBar linkage;
  linkage.pivot_d = {110, 0};
  linkage.crank = 40;
  linkage.coupler = 120;
  linkage.rocker = 80;
  const auto mechanism = problems::named(linkage);
  problems::Tolerances tolerances;
  tolerances.length = problems::Deviation{0.1, 0.1};
  const auto toleranced = problems::toleranced(mechanism, tolerances, {});
  if (!toleranced) return 1;

  std::vector<Station> stations;
  for (int k = 0; k < positions; ++k) {
    stations.push_back({drive_position(mechanism.mechanism, kTurn * k / positions), {1.0}});
  }
  Response rocker;
  rocker.type = ResponseType::angle;
  rocker.index = 3;
  const std::vector responses{rocker};
  const auto table = sensitivities(toleranced->mechanism, responses, stations);
  JudgedResponse judged{.response = rocker};
  judged.offset.assign(stations.size(), 0);
  for (std::size_t s = 0; s < stations.size(); ++s) judged.reference.push_back(table.value(s, 0));
  SamplingOptions options{.samples = static_cast<std::size_t>(samples), .threads = threads};
  options.draw = [&](std::size_t first, std::size_t size, std::span<double> changes) {
    problems::draw_changes(toleranced->dimensions, problems::ToleranceDistribution::normal, 1,
                           first, size, changes);
  };
  const auto cranks = CrankTable<double>::full_turn(static_cast<std::size_t>(positions));
  const auto begin = std::chrono::steady_clock::now();
  const auto drawn = sample(toleranced->mechanism, std::vector{judged}, stations, options);
  const double sampled = seconds_since(begin);
  const double kernel = bare(samples, cranks, threads);
  fmt::print(
      "{} samples at {} positions on {} threads ({} assembled): {:.3f} s; bare kernel {:.3f} s; "
      "ratio {:.2f}\n",
      samples, positions, threads, drawn.assembled, sampled, kernel, sampled / kernel);
}
