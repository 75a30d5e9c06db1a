// Roots of binary forms: planted directions come back, double ones and those at infinity too.
#include "synthesis/exact/binary_form.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace cognate::synthesis::binary_form_test {
namespace {

/// The form that vanishes on the directions of three angles.
std::array<double, 4> form_of(double a, double b, double c) {
  // Π (sin(aᵢ)·α − cos(aᵢ)·β).
  const double s[3]{std::sin(a), std::sin(b), std::sin(c)};
  const double t[3]{-std::cos(a), -std::cos(b), -std::cos(c)};
  return {s[0] * s[1] * s[2], s[0] * s[1] * t[2] + s[0] * t[1] * s[2] + t[0] * s[1] * s[2],
          s[0] * t[1] * t[2] + t[0] * s[1] * t[2] + t[0] * t[1] * s[2], t[0] * t[1] * t[2]};
}

double nearest(const InPlaceVector<Vec2d, 3>& roots, double angle) {
  double least = 1;
  for (const Vec2d& root : roots) {
    least = std::min(least, std::abs(root.x * std::sin(angle) - root.y * std::cos(angle)));
  }
  return least;
}

TEST(BinaryForm, CubicRootsComeBack) {
  int tested = 0;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(0, 3.14159);
  for (int trial = 0; trial < 20'000; ++trial) {
    std::array<double, 3> a{angle(random), angle(random), angle(random)};
    std::ranges::sort(a);
    const double apart =
        std::min({std::sin(a[1] - a[0]), std::sin(a[2] - a[1]), std::abs(std::sin(a[2] - a[0]))});
    if (apart < 1e-3) continue;
    ++tested;
    const auto roots = real_roots(form_of(a[0], a[1], a[2]));
    ASSERT_EQ(roots.size(), 3U) << trial;
    for (const double wanted : a) EXPECT_LT(nearest(roots, wanted), 1e-14 / (apart * apart));
  }
  EXPECT_GE(tested, 17000);
}

TEST(BinaryForm, RootsAtInfinityAndAtZero) {
  const auto both = real_roots(std::array<double, 4>{0, 1, 1, 0});  // αβ(α + β)
  ASSERT_EQ(both.size(), 3U);
  EXPECT_LT(nearest(both, 0), 1e-15);
  EXPECT_LT(nearest(both, std::acos(0.0)), 1e-15);
  const auto triple = real_roots(std::array<double, 4>{0, 0, 0, 3});  // β³
  ASSERT_GE(triple.size(), 1U);
  EXPECT_LT(nearest(triple, 0), 1e-4);
  EXPECT_TRUE(real_roots(std::array<double, 4>{}).empty());
}

TEST(BinaryForm, DoubleRootsComeOutTwice) {
  const auto roots = real_roots(form_of(0.7, 0.7, 2.1));
  ASSERT_EQ(roots.size(), 3U);
  EXPECT_LT(nearest(roots, 0.7), 1e-7);
  EXPECT_LT(nearest(roots, 2.1), 1e-14);
  const auto square = real_roots(std::array<double, 3>{1, -2, 1});
  ASSERT_EQ(square.size(), 2U);
  EXPECT_NEAR(square[0].x, square[0].y, 1e-15);
}

TEST(BinaryForm, ComplexPairsAreLeftOut) {
  EXPECT_EQ(real_roots(std::array<double, 4>{1, 0, 1, 0}).size(), 1U);  // α(α² + β²)
  EXPECT_TRUE(real_roots(std::array<double, 3>{1, 0, 1}).empty());
}

// Products whose difference cancels in doubles: (10⁸ + 1)² − 4·(10⁸·10⁸ + 10⁸)/4 = 10⁸ + 1.
TEST(BinaryForm, DiscriminantsDoNotCancel) {
  const auto roots = real_roots(std::array<double, 3>{1, -(2e8 + 1), 1e8 * (1e8 + 1)});
  ASSERT_EQ(roots.size(), 2U);
  std::vector<double> x{roots[0].x / roots[0].y, roots[1].x / roots[1].y};
  std::ranges::sort(x);
  EXPECT_NEAR(x[0], 1e8, 1e-6);
  EXPECT_NEAR(x[1], 1e8 + 1, 1e-6);
}

}  // namespace
}  // namespace cognate::synthesis::binary_form_test
