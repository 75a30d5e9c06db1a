#include "problems/toml/interpolation.hpp"

#include <algorithm>
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

// Cubics between neighbouring rows, by the values and slopes there. Boost's write their faults to
// streams, which pages, where tables are read too, do not have.
class Cubics {
 public:
  explicit Cubics(const Samples& table) : rows_(table), slopes_(slopes(table)) {}

  double value(double x) const {
    if (!(x > rows_.front().first)) return rows_.front().second;
    if (!(x < rows_.back().first)) return rows_.back().second;
    const auto [left, width, t] = place(x);
    const double y0 = rows_[left].second, y1 = rows_[left + 1].second;
    const double from_left = y0 * (1 + 2 * t) + slopes_[left] * width * t;
    const double from_right = y1 * (3 - 2 * t) - slopes_[left + 1] * width * (1 - t);
    return (1 - t) * (1 - t) * from_left + t * t * from_right;
  }

  double slope(double x) const {
    if (x < rows_.front().first || x > rows_.back().first) return 0;
    const auto [left, width, t] = place(x);
    const double middle = 6 * t * (1 - t) * chord(rows_, left);
    return middle + slopes_[left] * (1 - t) * (1 - 3 * t) - slopes_[left + 1] * t * (2 - 3 * t);
  }

 private:
  struct Place {
    std::size_t left;
    double width, t;  // t: the share of the width that lies before it
  };

  Place place(double x) const {
    const auto after = std::ranges::upper_bound(rows_, x, {}, &Samples::value_type::first);
    const auto next = std::min(static_cast<std::size_t>(after - rows_.begin()), rows_.size() - 1);
    const double interval = width(rows_, next - 1);
    return {next - 1, interval, (x - rows_[next - 1].first) / interval};
  }

  Samples rows_;
  std::vector<double> slopes_;
};

}  // namespace

Interpolant interpolant(const Samples& table) {
  const auto cubics = std::make_shared<const Cubics>(table);
  return {[=](double at) { return cubics->value(at); },
          [=](double at) { return cubics->slope(at); }};
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
