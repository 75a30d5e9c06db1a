// What the C++ library needs for what ratios.py measures from Python: batches of four-bars, in
// seconds for one call, the least of several.
//
//     python_batch_bench DESIGNS ANGLES CALLS
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"

namespace {

using namespace cognate;

double seconds_for(std::size_t designs, std::size_t angles, int calls) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(0.5, 3);
  std::vector<std::vector<double>> columns(10, std::vector<double>(designs, 1));
  for (auto& column : columns) {
    for (double& value : column) value = any(random);
  }
  std::vector<double> at(angles);
  for (std::size_t i = 0; i < angles; ++i) at[i] = 6.0 * double(i) / double(angles);
  std::vector<double> x(designs * angles), y(designs * angles);
  columns[7].assign(designs, 1);
  const FourBarArrays<double> arrays{columns[0], columns[1], columns[2], columns[3], columns[4],
                                     columns[5], columns[6], columns[7], columns[8], columns[9]};
  double least = std::numeric_limits<double>::infinity();
  for (int call = 0; call < calls; ++call) {
    const auto begun = std::chrono::steady_clock::now();
    const CrankTable<double> cranks(at);
    if (evaluate_batch(arrays, cranks, {.x = x, .y = y}) != BatchStatus::done) std::abort();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    least = std::min(least, taken.count());
  }
  return least;
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int i) { return std::strtoull(arguments[i], nullptr, 10); };
  if (count != 4) return 2;
  std::printf("%.9g\n", seconds_for(number(1), number(2), int(number(3))));
}
