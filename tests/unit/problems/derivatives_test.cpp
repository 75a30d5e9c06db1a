// Derivatives of functions that are only evaluated, against those in closed form.
#include "problems/function/target/derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cognate::problems::derivatives_test {
namespace {

/// The largest error of `found` against `wanted`, relative to its size, order by order.
void expect_near(const std::vector<Derivative>& found, const std::vector<double>& wanted,
                 const std::vector<double>& allowed) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].value, wanted[k], allowed[k] * std::abs(wanted[k])) << "order " << k + 1;
    // The estimate is a bound that is not far above the error allowed.
    EXPECT_LE(std::abs(found[k].value - wanted[k]),
              std::max(4 * found[k].relative_error, 1e-15) * std::abs(wanted[k]));
    EXPECT_LE(found[k].relative_error, 1000 * allowed[k]) << "order " << k + 1;
  }
}

TEST(Derivatives, OfALogarithm) {
  const auto f = [](double x) { return std::log10(x); };
  for (const double x : {1.0, 1.25, 1.5, 2.0}) {
    const double unit = 1 / std::log(10.0);
    const std::vector<double> wanted{unit / x, -unit / (x * x), 2 * unit / (x * x * x),
                                     -6 * unit / (x * x * x * x)};
    const bool inside = x == 1.25 || x == 1.5;
    expect_near(
        derivatives(f, x, {1, 2}, 4), wanted,
        inside ? std::vector{1e-13, 1e-12, 1e-10, 1e-9} : std::vector{1e-12, 1e-9, 1e-7, 1e-5});
  }
}

TEST(Derivatives, OfAnExponential) {
  const auto f = [](double x) { return std::exp(3 * x); };
  const double e = std::exp(1.2);
  expect_near(derivatives(f, 0.4, {0, 1}, 4), {3 * e, 9 * e, 27 * e, 81 * e},
              {1e-13, 1e-12, 1e-11, 1e-10});
}

TEST(Derivatives, NearASingularity) {
  const auto f = [](double x) { return std::sqrt(x); };
  const double x = 0.05;
  expect_near(derivatives(f, x, {0, 1}, 2), {0.5 / std::sqrt(x), -0.25 / std::pow(x, 1.5)},
              {1e-11, 1e-9});
}

TEST(Derivatives, OfAPolynomialAndAConstant) {
  expect_near(derivatives([](double x) { return x * x; }, 1.5, {1, 2}, 2), {3, 2}, {1e-14, 1e-12});
  const auto none = derivatives([](double) { return 4.0; }, 0.5, {0, 1}, 3);
  for (const Derivative& d : none) EXPECT_EQ(d.value, 0);
}

// Where there is none the error says so.
TEST(Derivatives, SayWhereThereIsNone) {
  const auto corner = derivatives([](double x) { return std::abs(x - 0.5); }, 0.5, {0, 1}, 2);
  EXPECT_GT(corner[1].relative_error, 1e-3);
}

}  // namespace
}  // namespace cognate::problems::derivatives_test
