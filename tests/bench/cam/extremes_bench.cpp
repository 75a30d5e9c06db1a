/// Prints, as markdown, what the greatest pressure angle of a cam costs and how wrong it is: by
/// Chebyshev series, by uniform grids, and by a golden-section search over the whole interval as
/// textbooks have it, which takes for granted that there is one wave.
#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analysis/cam/extremes.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/bench/kernel/measure.hpp"

namespace cognate::bench {
namespace {

/// A pressure angle, with its sign, over a cam angle from 0, and the greatest size it has there.
struct Cam {
  const char* name;
  double (*angle)(double);
  double to;
  double greatest;  ///< degrees
};

/// tan α = (s' - e)/(s + s₀); the greatest is where (s + s₀)s'' = (s' - e)s', in extended
/// precision.
const Cam kCams[] = {
    {"harmonic rise of 20 in a quarter turn, 40 from the axis",
     [](double x) { return std::atan2(20 * std::sin(2 * x), 50 - 10 * std::cos(2 * x)); },
     kRightAngle, 22.207654298596488},
    {"three waves in a turn, offset by 5",
     [](double x) {
       const double speed = 10 * std::sin(x) + 12 * std::sin(3 * x);
       return std::atan2(speed - 5, 54 - 10 * std::cos(x) - 4 * std::cos(3 * x));
     },
     kTurn, 25.884581169500053}};

double by_series(const Cam& cam) {
  const auto f = [&](double x) { return cam.angle(x); };
  const auto [least, greatest] = cam::extremes(f, 0, cam.to, 1);
  return std::max(-least.value, greatest.value);
}

double by_grid(const Cam& cam, int points) {
  double greatest = 0;
  for (int i = 0; i < points; ++i) {
    greatest = std::max(greatest, std::abs(cam.angle(cam.to * i / (points - 1))));
  }
  return greatest;
}

double by_golden_section(const Cam& cam) {
  constexpr double kShare = 0.6180339887498949, kWidth = 1e-7;
  const auto f = [&](double x) { return std::abs(cam.angle(x)); };
  double low = 0, high = cam.to;
  double left = high - kShare * (high - low), right = low + kShare * (high - low);
  double at_left = f(left), at_right = f(right);
  while (high - low > kWidth) {
    if (at_left > at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      at_left = f(left = high - kShare * (high - low));
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      at_right = f(right = low + kShare * (high - low));
    }
  }
  return std::max(at_left, at_right);
}

void print(const Cam& cam) {
  double result = 0;
  std::vector<Case> cases{
      {.name = "Chebyshev series", .run = [&] { result = by_series(cam); }},
      {.name = "golden section", .run = [&] { result = by_golden_section(cam); }}};
  for (const int points : {1'000, 10'000, 100'000}) {
    cases.push_back({.name = fmt::format("grid of {}", points),
                     .run = [&, points] { result = by_grid(cam, points); }});
  }
  measure(cases, 200);
  fmt::print("Greatest pressure angle, {}:\n\n| by | µs | error, degrees |\n|---|---|---|\n",
             cam.name);
  for (const Case& one : cases) {
    one.run();
    const double error = std::abs(result / kDegree - cam.greatest);
    fmt::print("| {} | {:.2f} | {:.1e} |\n", one.name, one.nanoseconds / 1000, error);
  }
  fmt::print("\n");
}

}  // namespace
}  // namespace cognate::bench

int main() {
  for (const auto& cam : cognate::bench::kCams) cognate::bench::print(cam);
}
