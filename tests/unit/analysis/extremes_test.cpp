// Extremes and zeros of functions: closed forms, planted places, sums of waves in extended
// precision, and functions that break the promise of being analytic.
#include "analysis/cam/extremes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"

namespace cognate::cam::extremes_test {
namespace {

/// A function that counts how often it is asked.
template <class F>
struct Counted {
  F f;
  int count = 0;
  double operator()(double x) { return ++count, f(x); }
};
template <class F>
Counted(F) -> Counted<F>;

std::vector<Extreme> local_of(FunctionRef f, double from, double to, double scale = 1) {
  std::vector<Extreme> found;
  local_extremes(f, from, to, scale, found);
  return found;
}

std::vector<double> zeros_of(FunctionRef f, double from, double to, double scale = 1) {
  std::vector<double> found;
  zeros(f, from, to, scale, found);
  return found;
}

/// Wanted places, the ends among them, each to a tolerance of its own kind.
void expect_places(const std::vector<Extreme>& found, const std::vector<double>& places,
                   double tolerance) {
  ASSERT_EQ(found.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(found[i].at, places[i], tolerance) << i;
  }
}

double chebyshev(int order, double x) {
  double before = 1, now = x;
  for (int k = 1; k < order; ++k) before = std::exchange(now, 2 * x * now - before);
  return now;
}

TEST(Extremes, PressureAngleOfAHarmonicRise) {
  Counted angle{
      [](double x) { return std::atan2(20 * std::sin(2 * x), 40 + 10 * (1 - std::cos(2 * x))); }};
  const double degree = kPi / 180;
  const auto [least, greatest] = extremes(angle, 0, kRightAngle, 1);
  EXPECT_NEAR(greatest.value / degree, 22.207654298596488, 2e-14);
  EXPECT_NEAR(greatest.at / degree, 39.231520483592256, 1e-11);
  EXPECT_NEAR(least.value, 0, 1e-15);
  EXPECT_LE(angle.count, 100);
  expect_places(local_of(angle, 0, kRightAngle), {0, 39.231520483592256 * degree, kRightAngle},
                2e-13);
}

TEST(Extremes, ValuesAreTheFunctionsOwn) {
  const auto f = [](double x) { return std::sin(3 * x) + x / 4; };
  for (const Extreme& extreme : local_of(f, -2, 5)) EXPECT_EQ(extreme.value, f(extreme.at));
  const auto [least, greatest] = extremes(f, -2, 5, 1);
  EXPECT_EQ(least.value, f(least.at));
  EXPECT_EQ(greatest.value, f(greatest.at));
}

TEST(Extremes, TiltedSineHasTheArcCosinesOfItsTilt) {
  for (int k = 1; k <= 12; ++k) {
    const double tilt = 0.3 * k;
    // k·cos(kx) + tilt = 0.
    const double first = std::acos(-0.3);
    std::vector<double> places{0};
    for (int turn = 0; turn < k; ++turn) {
      places.push_back((kTurn * turn + first) / k);
      places.push_back((kTurn * turn + kTurn - first) / k);
    }
    places.push_back(kTurn);
    const auto f = [&](double x) { return std::sin(k * x) + tilt * x; };
    expect_places(local_of(f, 0, kTurn), places, 1e-12);
  }
}

TEST(Extremes, ChebyshevPolynomialsHaveAllTheirWaves) {
  for (int order = 1; order <= 60; ++order) {
    SCOPED_TRACE(order);
    const auto f = [&](double x) { return chebyshev(order, x); };
    std::vector<double> places, roots;
    for (int i = 0; i <= order; ++i) places.push_back(-std::cos(kPi * i / order));
    for (int i = 0; i < order; ++i) roots.push_back(-std::cos(kPi * (i + 0.5) / order));
    const std::vector<Extreme> found = local_of(f, -1, 1);
    expect_places(found, places, 1e-13);
    for (const Extreme& extreme : found) EXPECT_NEAR(std::abs(extreme.value), 1, 1e-13);
    const std::vector<double> at = zeros_of(f, -1, 1);
    ASSERT_EQ(at.size(), roots.size());
    for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(at[i], roots[i], 1e-14);
  }
}

TEST(Extremes, ExtremesOnAJointOfSubintervalsComeOnce) {
  // The middle is the first joint, and quarters the next.
  const auto cosine = [](double x) { return std::cos(40 * x); };
  std::vector<double> places;
  for (int i = -40; i <= 40; ++i) places.push_back(i * kPi / 40);
  expect_places(local_of(cosine, -kPi, kPi), places, 1e-13);
  const auto sine = [](double x) { return std::sin(40 * x); };
  EXPECT_EQ(zeros_of(sine, -kPi, kPi).size(), 79U);
}

TEST(Extremes, PlacesOfExtremesComeBeforeSamplesOfTheSameValue) {
  // At 0, a sample and a joint, the value is the same in double precision.
  const auto one = [](double x) { return std::cos(x - 1e-9); };
  EXPECT_NEAR(extremes(one, -1, 1, 1).greatest.at, 1e-9, 1e-13);
  const auto many = [](double x) { return std::cos(40 * (x - 1e-9)); };
  std::vector<double> places{-kPi};
  for (int i = -39; i <= 40; ++i) places.push_back(i * kPi / 40 + (i < 40 ? 1e-9 : 0));
  expect_places(local_of(many, -kPi, kPi), places, 1e-12);
}

TEST(Extremes, PlacesAreExactWhateverTheWidthOfTheWave) {
  double worst = 0;
  for (int i = 0; i <= 100; ++i) {
    const double a = 0.02 + 0.009 * i;
    const auto f = [=](double x) { return 2 * a * x / (x * x + a * a); };
    const std::vector<Extreme> found = local_of(f, -1, 1.3);
    ASSERT_EQ(found.size(), 4U) << a;
    worst = std::max({worst, std::abs(found[1].at + a) / a, std::abs(found[2].at - a) / a});
  }
  EXPECT_LT(worst, 1e-12);
}

TEST(Extremes, NoiseOfTheFunctionIsNotResolved) {
  Counted noisy{[](double x) { return std::sin(x) + 3e-13 * std::sin(1e9 * x); }};
  expect_places(local_of(noisy, 0, 6), {0, kRightAngle, 1.5 * kPi, 6}, 1e-8);
  EXPECT_LE(noisy.count, 400);
  // Here it is the rounding of x that makes 1 - 0.99999 wrong by 1e-11.
  Counted steep{[](double x) { return 1 / (x - 0.99999); }};
  expect_places(local_of(steep, 1, 2), {1, 2}, 0);
  EXPECT_LE(steep.count, 2000);
}

TEST(Extremes, PolesJustOutside) {
  Counted pole{[](double x) { return 1 / (x + 1e-3); }};
  expect_places(local_of(pole, 0, 1, 1), {0, 1}, 0);
  EXPECT_LE(pole.count, 1000);
  // Least where 1/(x + a)² = 1/(1 + a - x)²: in the middle.
  const auto two = [](double x) { return 1 / (x + 1e-3) + 1 / (1.001 - x); };
  const std::vector<Extreme> found = local_of(two, 0, 1, 1);
  expect_places(found, {0, 0.5, 1}, 1e-12);
  expect_places(local_of([](double x) { return 1 / (1 + 1e4 * x * x); }, -1, 1.3), {-1, 0, 1.3},
                1e-13);
}

TEST(Extremes, TwoVeryNearEachOther) {
  for (const double apart : {1e-3, 1e-5}) {
    const auto f = [&](double x) { return x * x * x - 3 * apart * apart * x; };
    const double size = std::pow(10 * apart, 3);
    expect_places(local_of(f, -9 * apart, 10 * apart, size),
                  {-9 * apart, -apart, apart, 10 * apart}, 1e-13 * apart);
    const std::vector<double> at = zeros_of(f, -9 * apart, 10 * apart, size);
    ASSERT_EQ(at.size(), 3U);
    EXPECT_NEAR(at[0], -std::sqrt(3.0) * apart, 1e-13 * apart);
    EXPECT_NEAR(at[1], 0, 1e-13 * apart);
  }
  // From afar, the wave of 4e-9 is still seen, that of 4e-15 is within rounding.
  const auto wide = [](double d) {
    return local_of([=](double x) { return x * x * x - 3 * d * d * x; }, -1, 1);
  };
  expect_places(wide(1e-3), {-1, -1e-3, 1e-3, 1}, 1e-12);
  expect_places(wide(1e-5), {-1, 1}, 0);
}

TEST(Extremes, FlatTopsAndInflections) {
  const auto flat = local_of([](double x) { return std::pow(x - 0.1, 4); }, -1, 1);
  expect_places(flat, {-1, 0.1, 1}, 1e-3);
  EXPECT_NEAR(flat[1].value, 0, 1e-14);
  const auto inflection = [](double x) { return std::pow(x - 0.1, 3); };
  expect_places(local_of(inflection, -1, 1), {-1, 1}, 0);
  ASSERT_EQ(zeros_of(inflection, -1, 1).size(), 1U);
  EXPECT_NEAR(zeros_of(inflection, -1, 1)[0], 0.1, 1e-4);
}

TEST(Extremes, ConstantsAndRoundingHaveOnlyTheirEnds) {
  for (const double value : {0.0, 3.0, -1e9}) {
    Counted constant{[=](double) { return value; }};
    expect_places(local_of(constant, 0, 1, std::abs(value)), {0, 1}, 0);
    EXPECT_LE(constant.count, 30);
  }
  const auto noise = [](double x) { return 1 + 1e-14 * std::sin(1e9 * x); };
  expect_places(local_of(noise, 0, 1), {0, 1}, 0);
  expect_places(local_of([&](double x) { return x + noise(x); }, 0, 1), {0, 1}, 0);
  EXPECT_TRUE(zeros_of([](double) { return 0.0; }, 0, 1).empty());
}

TEST(Extremes, SmoothFunctionsCostFewEvaluations) {
  Counted sine{[](double x) { return std::sin(x); }};
  extremes(sine, 0, kTurn, 1);
  EXPECT_LE(sine.count, 30);
  Counted rise{[](double x) { return std::exp(-x) * x; }};
  expect_places(local_of(rise, 0, 5), {0, 1, 5}, 1e-13);
  EXPECT_LE(rise.count, 60);
}

/// Σ a_k·cos(kx) + b_k·sin(kx).
struct Waves {
  std::vector<double> a, b;

  template <class T>
  T derivative(T x, int order) const {
    T sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const T phase = T(k + 1) * x + order * std::numbers::pi_v<T> / 2;
      sum += std::pow(T(k + 1), T(order)) * (a[k] * std::cos(phase) + b[k] * std::sin(phase));
    }
    return sum;
  }

  /// Zeros of a derivative on [0, 2π) by a fine grid and halving, in extended precision.
  std::vector<double> zeros(int order) const {
    constexpr int kGrid = 2000;
    std::vector<double> found;
    const auto at = [](int i) { return 2 * std::numbers::pi_v<long double> * i / kGrid; };
    for (int i = 0; i < kGrid; ++i) {
      long double low = at(i), high = at(i + 1);
      const bool rises = derivative(low, order) <= 0;
      if ((derivative(high, order) <= 0) == rises) continue;
      for (int step = 0; step < 60; ++step) {
        const long double middle = (low + high) / 2;
        ((derivative(middle, order) <= 0) == rises ? low : high) = middle;
      }
      found.push_back(static_cast<double>(low));
    }
    return found;
  }
};

TEST(Extremes, SumsOfWavesAgreeWithExtendedPrecision) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> part;
  for (int trial = 0; trial < 25; ++trial) {
    SCOPED_TRACE(trial);
    Waves waves;
    for (int k = 0; k < 1 + trial / 3; ++k) {
      waves.a.push_back(part(random));
      waves.b.push_back(part(random));
    }
    const auto f = [&](double x) { return waves.derivative(x, 0); };
    std::vector<double> places = waves.zeros(1);
    const std::vector<Extreme> found = local_of(f, 0, kTurn, 3);
    ASSERT_EQ(found.size(), places.size() + 2);
    double least = INFINITY, greatest = -INFINITY;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double bend = std::abs(waves.derivative(places[i], 2));
      EXPECT_NEAR(found[i + 1].at, places[i], 1e-12 * std::max(1.0, 10 / bend));
      least = std::min(least, f(places[i]));
      greatest = std::max(greatest, f(places[i]));
    }
    const auto ends = extremes(f, 0, kTurn, 3);
    EXPECT_NEAR(ends.least.value, least, 1e-13);
    EXPECT_NEAR(ends.greatest.value, greatest, 1e-13);

    const std::vector<double> roots = waves.zeros(0), at = zeros_of(f, 0, kTurn, 3);
    ASSERT_EQ(at.size(), roots.size());
    for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(at[i], roots[i], 1e-12);
  }
}

// What is not analytic ends all the same, with samples for an answer.
TEST(Extremes, KinksAndJumps) {
  Counted kink{[](double x) { return std::abs(x - 0.3); }};
  const auto lowest = extremes(kink, 0, 1, 1).least;
  EXPECT_NEAR(lowest.at, 0.3, 1e-10);
  EXPECT_NEAR(lowest.value, 0, 1e-10);
  EXPECT_LE(kink.count, 5000);

  Counted jump{[](double x) { return x < 0.3 ? x : x - 1; }};
  expect_places(local_of(jump, 0, 1), {0, 0.3, 0.3, 1}, 1e-10);
  const auto [least, greatest] = extremes(jump, 0, 1, 1);
  EXPECT_NEAR(greatest.value, 0.3, 1e-10);
  EXPECT_NEAR(least.value, -0.7, 1e-10);
  EXPECT_LE(jump.count, 10'000);
}

TEST(Extremes, WildFunctionsEnd) {
  Counted wild{[](double x) { return x + 1e-3 * std::sin(1e9 * x); }};
  const auto [least, greatest] = extremes(wild, 0, 1, 1);
  EXPECT_NEAR(least.value, 0, 1e-3);
  EXPECT_NEAR(greatest.value, 1, 2e-3);
  EXPECT_LE(wild.count, 120'000);
  Counted pole{[](double x) { return 1 / (x - 0.3); }};
  EXPECT_GT(extremes(pole, 0, 1, 1).greatest.value, 1e6);
  EXPECT_LE(pole.count, 120'000);
}

TEST(Extremes, NoNumbersAreLeftOut) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Counted half{[](double x) { return x < 0.3 ? kNan : std::sin(9 * x); }};
  const auto [least, greatest] = extremes(half, 0, 1, 1);
  EXPECT_NEAR(least.at, kPi / 6, 1e-12);
  EXPECT_NEAR(greatest.at, kPi * 5 / 18, 1e-12);
  EXPECT_LE(half.count, 5000);
  expect_places(local_of(half, 0, 1), {0, kPi / 6, kPi * 5 / 18, 1}, 1e-12);
  Counted none{[](double) { return kNan; }};
  EXPECT_EQ(local_of(none, 0, 1).size(), 2U);
  EXPECT_TRUE(zeros_of(none, 0, 1).empty());
  EXPECT_LE(none.count, 60);
}

TEST(Extremes, ScalesAndIntervalsThatAreNone) {
  const auto f = [](double x) { return std::sin(x); };
  for (const double scale : {0.0, -1.0, double(INFINITY), double(NAN)}) {
    expect_places(local_of(f, 0, 5, scale), {0, kRightAngle, 3 * kRightAngle, 5}, 1e-13);
  }
  expect_places(local_of(f, 2, 2), {2}, 0);
  EXPECT_TRUE(zeros_of(f, 4, 2).empty());
  EXPECT_EQ(extremes(f, 2, 2, 1).greatest.value, f(2));
}

TEST(Extremes, ZerosAtTheEndsAreNotInside) {
  const auto f = [](double x) { return std::sin(x); };
  EXPECT_TRUE(zeros_of(f, 0, kPi).empty());
  const std::vector<double> at = zeros_of(f, 0, kTurn);
  ASSERT_EQ(at.size(), 1U);
  EXPECT_NEAR(at[0], kPi, 1e-14);
}

}  // namespace
}  // namespace cognate::cam::extremes_test
