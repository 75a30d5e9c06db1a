#include "problems/function/scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cognate::problems {
namespace {

/// With fewer rows, scatter cannot be distinguished from shape.
constexpr std::size_t kFewestRows = 20;
/// Share of the steps in which the sign of what remains changes: four of five for independent
/// errors, none or few for smooth tables.
constexpr double kAlternating = 0.6;
/// Less is what numbers rounded to a thousandth of their range leave.
constexpr double kLeastShare = 2e-3;
/// Lower quartile of the absolute value of a normal variable, in standard deviations.
constexpr double kQuartile = 0.3186;

/// What remains of row i beside the cubic through its neighbours, over its own standard deviation
/// if each row had an independent error of one.
double remainder_at(std::span<const std::pair<double, double>> rows, std::size_t i) {
  const std::array<std::size_t, 4> others{i - 2, i - 1, i + 1, i + 2};
  double remains = rows[i].second, variance = 1;
  for (const std::size_t j : others) {
    double weight = 1;
    for (const std::size_t k : others) {
      if (k == j) continue;
      weight *= (rows[i].first - rows[k].first) / (rows[j].first - rows[k].first);
    }
    remains -= weight * rows[j].second;
    variance += weight * weight;
  }
  return remains / std::sqrt(variance);
}

}  // namespace

std::optional<double> scatter_share(std::span<const std::pair<double, double>> rows) {
  if (rows.size() < kFewestRows) return std::nullopt;
  const auto [least, greatest] =
      std::ranges::minmax(rows, {}, [](const auto& row) { return row.second; });
  const double range = greatest.second - least.second;
  if (!(range > 0)) return std::nullopt;
  std::vector<double> sizes;
  double last = 0;
  std::size_t changes = 0;
  for (std::size_t i = 2; i + 2 < rows.size(); ++i) {
    const double remains = remainder_at(rows, i);
    if (!std::isfinite(remains)) return std::nullopt;  // rows at one x
    changes += remains * last < 0;
    last = remains;
    sizes.push_back(std::abs(remains));
  }
  if (double(changes) < kAlternating * double(sizes.size() - 1)) return std::nullopt;
  const auto quartile = sizes.begin() + std::ssize(sizes) / 4;
  std::ranges::nth_element(sizes, quartile);
  const double share = *quartile / kQuartile / range;
  if (share < kLeastShare) return std::nullopt;
  return share;
}

}  // namespace cognate::problems
