#include "problems/function/target/fast_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cognate::problems {
namespace {

constexpr double kTolerance = 1e-8;
constexpr int kHalvings = 30;
constexpr std::size_t kMostPlaces = 10'000;

struct Step {
  double from = 0, to = 0;
};

/// Lagrange's cubic through values at 0, 1/3, 2/3 and 1.
double cubic(const std::array<double, 4>& values, double t) {
  const double a = t, b = t - 1.0 / 3, c = t - 2.0 / 3, d = t - 1;
  return -4.5 * b * c * d * values[0] + 13.5 * a * c * d * values[1] -
         13.5 * a * b * d * values[2] + 4.5 * a * b * c * values[3];
}

bool is_cubic(const std::function<double(double)>& value, const Step& step, double tolerance) {
  const auto at = [&](double t) { return value(step.from + t * (step.to - step.from)); };
  const std::array<double, 4> values{at(0), at(1.0 / 3), at(2.0 / 3), at(1)};
  constexpr std::array<double, 3> kChecks{0.17, 0.53, 0.86};
  return std::ranges::all_of(
      kChecks, [&](double t) { return std::abs(at(t) - cubic(values, t)) <= tolerance; });
}

}  // namespace

std::vector<double> fast_places(const std::function<double(double)>& value, int steps) {
  std::vector<Step> now, next;
  double least = value(1), greatest = least;
  for (int i = 0; i < steps; ++i) {
    now.push_back({double(i) / steps, double(i + 1) / steps});
    // Zeros of a sine may lie at all the ends of steps.
    for (const double at : {now.back().from, (i + 0.37) / steps}) {
      least = std::min(least, value(at));
      greatest = std::max(greatest, value(at));
    }
  }
  if (least == greatest) return {};
  const double tolerance = kTolerance * (greatest - least);
  std::vector<double> places;
  for (int halving = 0; halving < kHalvings && !now.empty(); ++halving) {
    next.clear();
    for (const Step& step : now) {
      if (places.size() == kMostPlaces) break;
      if (is_cubic(value, step, tolerance)) continue;
      const double middle = 0.5 * (step.from + step.to);
      places.push_back(middle);
      next.push_back({step.from, middle});
      next.push_back({middle, step.to});
    }
    std::swap(now, next);
  }
  std::ranges::sort(places);
  return places;
}

}  // namespace cognate::problems
