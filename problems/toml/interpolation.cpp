#include "problems/toml/interpolation.hpp"

#include <algorithm>
#include <boost/math/interpolators/cubic_hermite.hpp>
#include <cmath>
#include <memory>

namespace cognate::problems::reading {
namespace {

using Samples = std::vector<std::pair<double, double>>;

// The slope of the interval that begins at row `i`.
double chord(const Samples& table, std::size_t i) {
  return (table[i + 1].second - table[i].second) / (table[i + 1].first - table[i].first);
}

double width(const Samples& table, std::size_t i) {
  return table[i + 1].first - table[i].first;
}

// The weighted harmonic mean of the chords on both sides, 0 at an extreme.
double inner_slope(const Samples& table, std::size_t i) {
  const double left = chord(table, i - 1);
  const double right = chord(table, i);
  if (!(left > 0 && right > 0) && !(left < 0 && right < 0)) return 0;
  const double w1 = 2 * width(table, i) + width(table, i - 1);
  const double w2 = width(table, i) + 2 * width(table, i - 1);
  return (w1 + w2) / (w1 / left + w2 / right);
}

// The parabola's slope at an end, from the chord there and the next, kept within what leaves the
// cubic monotone: the sign of the chord, at most three times its size where the chords differ in
// sign.
double end_slope(double near, double far, double near_width, double far_width) {
  const double slope = near + near_width / (near_width + far_width) * (near - far);
  if (slope * near <= 0) return 0;
  if (near * far <= 0 && std::abs(slope) > 3 * std::abs(near)) return 3 * near;
  return slope;
}

std::vector<double> slopes(const Samples& table) {
  const std::size_t n = table.size();
  if (n == 2) return {chord(table, 0), chord(table, 0)};
  std::vector<double> all(n);
  all[0] = end_slope(chord(table, 0), chord(table, 1), width(table, 0), width(table, 1));
  for (std::size_t i = 1; i + 1 < n; ++i) all[i] = inner_slope(table, i);
  all[n - 1] =
      end_slope(chord(table, n - 2), chord(table, n - 3), width(table, n - 2), width(table, n - 3));
  return all;
}

}  // namespace

Interpolant interpolant(const Samples& table) {
  std::vector<double> x;
  std::vector<double> y;
  for (const auto& [xi, yi] : table) {
    x.push_back(xi);
    y.push_back(yi);
  }
  using Cubic = boost::math::interpolators::cubic_hermite<std::vector<double>>;
  const double first = x.front();
  const double last = x.back();
  const auto cubic = std::make_shared<const Cubic>(std::move(x), std::move(y), slopes(table));
  // Outside its table the interpolator throws.
  return {[=](double at) { return (*cubic)(std::clamp(at, first, last)); },
          [=](double at) { return first <= at && at <= last ? cubic->prime(at) : 0.0; }};
}

std::function<double(double)> interpolate(const Samples& table) {
  return interpolant(table).value;
}

std::function<double(double)> straight_lines(const Samples& table) {
  const auto rows = std::make_shared<const Samples>(table);
  return [rows](double x) {
    if (!(x > rows->front().first)) return rows->front().second;
    const auto after = std::ranges::upper_bound(*rows, x, {}, &Samples::value_type::first);
    if (after == rows->end()) return rows->back().second;
    const auto& [x0, y0] = *(after - 1);
    return std::lerp(y0, after->second, (x - x0) / (after->first - x0));
  };
}

}  // namespace cognate::problems::reading
