#include "problems/machine/periodic_table.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems::reading {
namespace {

using Samples = std::vector<std::pair<double, double>>;

// `angle` plus whole turns, in [first, first + 2π).
double from_first(double angle, double first) {
  const double rest = within_turn(angle - first);
  return first + rest;
}

// The table with `rows` rows of the turns before and after it.
Samples continued(const Samples& table, std::size_t rows) {
  const std::size_t n = table.size();
  Samples all;
  for (std::size_t i = 0; i < n + 2 * rows; ++i) {
    const std::size_t place = i + n * rows - rows;
    const std::size_t turns = place / n;
    const auto& [x, y] = table[place % n];
    all.emplace_back(x + (static_cast<double>(turns) - static_cast<double>(rows)) * kTurn, y);
  }
  return all;
}

Interpolant straight(const Samples& table) {
  const auto rows = std::make_shared<const Samples>(continued(table, 1));
  // The row at which the line through `x` begins.
  const auto line = [rows](double x) {
    const auto after = std::upper_bound(rows->begin() + 1, rows->end() - 1, x,
                                        [](double at, const auto& row) { return at < row.first; });
    return after - 1;
  };
  const auto slope = [line](double x) {
    const auto row = line(x);
    return ((row + 1)->second - row->second) / ((row + 1)->first - row->first);
  };
  return {[line, slope](double x) {
            const auto row = line(x);
            return row->second + slope(x) * (x - row->first);
          },
          slope};
}

}  // namespace

double within_turn(double angle) {
  return in_period(angle, kTurn);
}

Interpolant periodic(const Samples& table, bool smooth) {
  const double first = table.front().first;
  // A row's slope depends on its neighbours, those at the ends are of half a parabola only.
  auto one_turn = smooth ? interpolant(continued(table, 2)) : straight(table);
  return {
      [first, value = std::move(one_turn.value)](double x) { return value(from_first(x, first)); },
      [first, slope = std::move(one_turn.slope)](double x) { return slope(from_first(x, first)); }};
}

}  // namespace cognate::problems::reading
