/// Scatter of tables: found where errors were added, and nowhere in smooth tables, however steep.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "problems/function/scatter.hpp"

namespace cognate::problems::function_scatter_test {
namespace {

using Rows = std::vector<std::pair<double, double>>;
using Function = double (*)(double);

/// On [0, 1]: steep parts, poles beyond the end, kinks, steps, a few waves.
constexpr std::array<Function, 14> kFunctions{
    [](double x) { return x * x; },
    [](double x) { return 1 / (x + 0.01); },
    [](double x) { return std::exp(12 * x); },
    [](double x) { return std::tanh(60 * (x - 0.4)); },
    [](double x) { return std::sqrt(x); },
    [](double x) { return std::log(x + 1e-3); },
    [](double x) { return std::abs(x - 0.37); },
    [](double x) { return x < 0.3   ? 0.6 * x
                          : x < 0.7 ? 1.4 * x - 0.24
                                    : 0.87 * x + 0.13; },
    [](double x) { return x < 0.5 ? 0.0 : 1.0; },
    [](double x) { return std::sin(12 * x); },
    [](double x) { return std::sin(15 * x); },
    [](double x) { return std::tan(1.5 * x); },
    [](double x) { return std::exp(-800 * (x - 0.5) * (x - 0.5)); },
    [](double x) { return x; }};

/// Rows at equal or random steps, in order.
Rows rows_of(Function f, std::size_t count, bool even, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 0.6);
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back((double(i) + (even ? 0 : share(random))) / double(count));
  }
  Rows rows;
  for (const double x : places) rows.emplace_back(x, f(std::clamp(x, 0.0, 1.0)));
  return rows;
}

double range_of(const Rows& rows) {
  const auto [least, greatest] =
      std::ranges::minmax(rows, {}, [](const auto& row) { return row.second; });
  return greatest.second - least.second;
}

TEST(FunctionScatter, SmoothTablesHaveNone) {
  std::mt19937_64 random(1);
  int looked_at = 0;
  for (const Function& f : kFunctions) {
    for (std::size_t count = 5; count < 220; count += 3) {
      for (const bool even : {true, false}) {
        EXPECT_FALSE(scatter_share(rows_of(f, count, even, random)))
            << "function " << &f - kFunctions.data() << ", " << count << " rows";
        ++looked_at;
      }
    }
  }
  EXPECT_EQ(looked_at, 14 * 72 * 2);
}

TEST(FunctionScatter, RoundedTablesHaveNone) {
  std::mt19937_64 random(2);
  int looked_at = 0;
  for (const Function& f : kFunctions) {
    for (std::size_t count = 16; count < 220; count += 20) {
      Rows rows = rows_of(f, count, true, random);
      const double unit = 1e-3 * range_of(rows);
      for (auto& [x, y] : rows) y = unit * std::round(y / unit);
      EXPECT_FALSE(scatter_share(rows)) << &f - kFunctions.data() << ", " << count;
      ++looked_at;
    }
  }
  EXPECT_EQ(looked_at, 14 * 11);
}

TEST(FunctionScatter, IsMeasuredWhereErrorsWereAdded) {
  std::mt19937_64 random(3);
  int seen = 0, all = 0;
  double ratios = 0;
  for (const Function f : {kFunctions[0], kFunctions[4], kFunctions[7], kFunctions[13]}) {
    for (const double share : {0.005, 0.01, 0.05}) {
      for (const bool even : {true, false}) {
        for (int n = 0; n < 40; ++n) {
          Rows rows = rows_of(f, 41 + 4 * n, even, random);
          std::normal_distribution<double> error(0, share * range_of(rows));
          for (auto& [x, y] : rows) y += error(random);
          ++all;
          const auto found = scatter_share(rows);
          if (!found) continue;
          ++seen;
          ratios += *found / share;
        }
      }
    }
  }
  EXPECT_EQ(all, 960);
  EXPECT_GT(seen, 940);
  EXPECT_NEAR(ratios / seen, 0.95, 0.15);  // the range has grown by the errors too
}

}  // namespace
}  // namespace cognate::problems::function_scatter_test
