/// Gaits of feet: against closed forms, against a scan of 40 000 positions, and of two published
/// legs against their closures by circles written here.
#include "analysis/mechanism/gait.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <deque>
#include <limits>
#include <random>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gait_test {
namespace {

using Complex = std::complex<double>;

/// x = cos θ, y given.
template <class Level, class Rate>
FootPath over_cosine(Level level, Rate rate) {
  return [=](double t) -> FootState { return {{std::cos(t), level(t)}, {-std::sin(t), rate(t)}}; };
}

FootPath circle(double phase) {
  return [=](double t) -> FootState {
    return {unit_vector(t + phase), perp(unit_vector(t + phase))};
  };
}

TEST(Gait, OfACircleIsInClosedForm) {
  int checked = 0;
  for (const double duty : {0.05, 0.2, 0.35, 0.5}) {
    for (const double phase : {0.0, 1.0, 1.5 * kPi, 1.5 * kPi + 1e-9, 6.0}) {
      const auto found = gait(circle(phase), duty);
      ASSERT_TRUE(found);
      const double half = kPi * duty;
      EXPECT_NEAR(found->duty, duty, 1e-15);
      EXPECT_NEAR(found->height, 2, 1e-12);
      EXPECT_NEAR(found->stride, 2 * std::sin(half), 1e-12);
      EXPECT_NEAR(found->band, 1 - std::cos(half), 1e-12);
      EXPECT_NEAR(found->flatness(), 0.5 * std::tan(0.5 * half), 1e-12);
      EXPECT_NEAR(std::remainder(found->from - (1.5 * kPi - half - phase), kTurn), 0, 1e-9);
      EXPECT_NEAR(found->to - found->from, kTurn * duty, 1e-12);
      EXPECT_EQ(found->sense, 1);
      EXPECT_NEAR(found->speed_max, half / std::sin(half), 1e-9);
      EXPECT_NEAR(found->speed_min, half / std::tan(half), 1e-9);
      EXPECT_TRUE(0 <= found->from && found->from < kTurn);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 20);
}

TEST(Gait, WithoutADutyFactorStandsWithinAShareOfTheHeight) {
  const auto found = gait(circle(1.5 * kPi));  // lowest at the seam of the turn
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->duty, std::acos(0.7) / kPi, 1e-12);
  EXPECT_NEAR(found->band, 0.3, 1e-11);
  EXPECT_NEAR(found->from, kTurn - std::acos(0.7), 1e-11);
}

TEST(Gait, OfEqualStancesIsTheFirst) {
  const auto level = [](double t) { return std::cos(2 * t); };
  const auto rate = [](double t) { return -2 * std::sin(2 * t); };
  const auto found = gait(over_cosine(level, rate));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->from, 0.5 * kPi - 0.5 * std::acos(0.7), 1e-11);
  EXPECT_EQ(found->sense, -1);
  const auto given = gait(over_cosine(level, rate), 0.1);
  ASSERT_TRUE(given);
  EXPECT_NEAR(given->from, 0.5 * kPi - 0.1 * kPi, 1e-9);
}

TEST(Gait, OfUnequalStancesIsTheLongest) {
  // The second well is deeper; of 15 % of the height it has the longer part.
  const auto level = [](double t) { return std::cos(2 * t) + 0.02 * std::sin(t); };
  const auto rate = [](double t) { return -2 * std::sin(2 * t) + 0.02 * std::cos(t); };
  const auto found = gait(over_cosine(level, rate));
  ASSERT_TRUE(found);
  EXPECT_GT(found->from, kPi);
  EXPECT_EQ(found->sense, 1);
}

/// Two wells at the crank angles π ± acos c; between them a peak that rises to 15 % of the height
/// at c = (1 − √0.15)/(1 + √0.15).
FootPath two_wells(double c) {
  const auto level = [c](double t) { return std::pow(c + std::cos(t), 2); };
  const auto rate = [c](double t) { return -2 * (c + std::cos(t)) * std::sin(t); };
  return [=](double t) -> FootState { return {{std::sin(t), level(t)}, {std::cos(t), rate(t)}}; };
}

TEST(Gait, ABandThatIsTouchedIsKept) {
  const double q = std::sqrt(0.15), touching = (1 - q) / (1 + q);
  for (const double c : {touching, touching + 1e-9}) {
    const auto found = gait(two_wells(c));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->duty, std::acos(2 * touching - 1) / kPi, 1e-7);
  }
  const auto split = gait(two_wells(touching - 1e-5));
  ASSERT_TRUE(split);
  EXPECT_LT(split->duty, 0.5 * std::acos(2 * touching - 1) / kPi);
}

TEST(Gait, IsNoneWhereNothingMoves) {
  const auto zero = [](double) { return 0.0; };
  EXPECT_FALSE(gait(over_cosine(zero, zero), 0.5));
  EXPECT_FALSE(gait(over_cosine(zero, zero)));
  EXPECT_FALSE(gait(
      [](double t) -> FootState {
        return {{3, std::sin(t)}, {0, std::cos(t)}};
      },
      0.5));
  const auto gap = [](double t) { return t > 3 ? std::nan("") : std::sin(t); };
  EXPECT_FALSE(gait(over_cosine(gap, gap), 0.5));
}

/// A path by its first harmonics.
struct Harmonics {
  std::array<Complex, 7> c;

  FootState operator()(double t) const {
    Complex at = 0, rate = 0;
    for (int k = -3; k <= 3; ++k) {
      const Complex term = c[static_cast<std::size_t>(k + 3)] * std::polar(1.0, k * t);
      at += term;
      rate += Complex(0, k) * term;
    }
    return {{at.real(), at.imag()}, {rate.real(), rate.imag()}};
  }
};

/// What a scan says, without derivatives.
struct Scan {
  double band, stride, slowest, fastest;
};

constexpr int kScanned = 40000;

/// The least of the greatest levels over all windows of `steps` steps, by a sliding maximum.
Scan scan(const FootPath& path, int steps) {
  std::vector<Vec2d> at;
  for (int i = 0; i < kScanned; ++i) at.push_back(path(kTurn * i / kScanned).at);
  const auto place = [&](int i) { return at[static_cast<std::size_t>(i % kScanned)]; };
  double ground = at[0].y;
  for (const Vec2d& one : at) ground = std::min(ground, one.y);
  std::deque<int> peaks;
  std::vector<double> tops;
  for (int i = 0; i < kScanned + steps; ++i) {
    while (!peaks.empty() && place(peaks.back()).y <= place(i).y) peaks.pop_back();
    peaks.push_back(i);
    if (peaks.front() < i - steps) peaks.pop_front();
    if (i >= steps) tops.push_back(place(peaks.front()).y);
  }
  // A window below a peak may be moved to and fro: of those whose ends are of one level, the
  // lowest.
  const double least = *std::ranges::min_element(tops);
  int first = -1, level = -1;
  const auto fall = [&](int i) { return place(i).y - place(i + steps).y; };
  for (int i = 0; i < kScanned; ++i) {
    if (tops[static_cast<std::size_t>(i)] > least + 1e-12) continue;
    if (first < 0 || std::abs(fall(i)) < std::abs(fall(first))) first = i;
    if (fall(i) * fall(i + 1) > 0) continue;
    if (level < 0 || place(i).y < place(level).y) level = i;
  }
  if (level >= 0) first = level;
  double low = place(first).x, high = low, slowest = 1e300, fastest = -1e300;
  const double sense = place(first + steps).x < place(first).x ? -1 : 1;
  for (int i = first; i <= first + steps; ++i) {
    low = std::min(low, place(i).x);
    high = std::max(high, place(i).x);
    if (i == first + steps) continue;
    const double step = sense * (place(i + 1).x - place(i).x) * steps;
    slowest = std::min(slowest, step);
    fastest = std::max(fastest, step);
  }
  return {least - ground, high - low, slowest / (high - low), fastest / (high - low)};
}

TEST(Gait, IsThatOfAScan) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int checked = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Harmonics path;
    for (std::size_t k = 0; k < path.c.size(); ++k) {
      const double size = 1 / (1 + std::pow(double(k) - 3, 2));
      path.c[k] = {size * normal(random), size * normal(random)};
    }
    const double duty = 0.1 + 0.01 * trial;
    const Scan wanted = scan(path, static_cast<int>(std::lround(duty * kScanned)));
    const auto found = gait(path, duty);
    ASSERT_TRUE(found);
    SCOPED_TRACE(trial);
    // The band is the least of all, to the curvature between positions of the scan.
    EXPECT_NEAR(found->band, wanted.band, 5e-4);
    EXPECT_LE(found->band, wanted.band + 1e-7);
    if (std::abs(found->band - wanted.band) > 1e-5) continue;
    EXPECT_NEAR(found->stride, wanted.stride, 2e-3 * wanted.stride);
    EXPECT_NEAR(found->speed_min, wanted.slowest, 5e-3 * (1 + std::abs(wanted.slowest)));
    EXPECT_NEAR(found->speed_max, wanted.fastest, 5e-3 * (1 + std::abs(wanted.fastest)));
    ++checked;
  }
  EXPECT_GE(checked, 20);
}

/// The point at distances a from p and b from q, to the left (1) or right (−1) of the way.
Complex meet(Complex p, Complex q, double a, double b, int side) {
  const Complex way = q - p;
  const double d = std::abs(way), along = (a * a - b * b + d * d) / (2 * d);
  return p + way / d * Complex(along, side * std::sqrt(a * a - along * along));
}

Complex klann(double t) {
  const Complex o(1.599, 0.75), a(1.009, 0.574), b(1.366, 1.366), m = o + std::polar(0.268, t);
  const Complex c = meet(m, a, 0.59, 0.3206, -1), d = meet(m, c, 1.1051, 0.5221, -1);
  return meet(d, meet(d, b, 0.8966, 0.5177, 1), 0.8966, 1.732, -1);
}

Complex jansen(double t) {
  const Complex b(-38, -7.8), m = std::polar(15.0, t), c = meet(m, b, 50, 41.5, -1);
  const Complex e = meet(c, b, 55.8, 40.1, -1), d = meet(m, b, 61.9, 39.3, 1);
  return meet(d, meet(e, d, 39.4, 36.7, -1), 49, 65.7, 1);
}

template <class Foot>
FootPath by_differences(Foot foot) {
  return [=](double t) -> FootState {
    constexpr double kStep = 1e-5;
    const Complex at = foot(t), rate = (foot(t + kStep) - foot(t - kStep)) / (2 * kStep);
    return {{at.real(), at.imag()}, {rate.real(), rate.imag()}};
  };
}

TEST(Gait, OfPublishedLegs) {
  const auto of_klann = gait(by_differences(klann)), of_jansen = gait(by_differences(jansen));
  ASSERT_TRUE(of_klann && of_jansen);
  EXPECT_NEAR(of_klann->stride, 1.0087, 5e-5);
  EXPECT_NEAR(of_klann->height, 0.5273, 5e-5);
  EXPECT_NEAR(of_klann->duty, 0.539, 5e-4);
  EXPECT_NEAR(of_klann->flatness(), 0.0784, 5e-5);
  EXPECT_NEAR(of_klann->speed_min, -0.4905, 1e-3);
  EXPECT_NEAR(of_jansen->stride, 67.88, 5e-3);
  EXPECT_NEAR(of_jansen->height, 22.46, 5e-3);
  EXPECT_NEAR(of_jansen->duty, 0.616, 5e-4);
  EXPECT_NEAR(of_jansen->flatness(), 0.0496, 5e-5);
}

/// A path seen in a mirror across the ground, from another start, or run through the other way.
FootPath changed(const FootPath& path, bool mirrored, double start, bool reversed) {
  return [=](double t) -> FootState {
    FootState one = path(start + (reversed ? -t : t));
    if (reversed) one.rate = -one.rate;
    if (mirrored) one = {{-one.at.x, one.at.y}, {-one.rate.x, one.rate.y}};
    return one;
  };
}

/// The foot's highest level in stance is inside: many parts of the turn have the least.
TEST(Gait, IsOneForAllViewsOfALeg) {
  const FootPath leg = by_differences(klann);
  int checked = 0;
  for (const double duty : {0.3, 0.4, 0.45, 0.5}) {
    const auto own = gait(leg, duty);
    ASSERT_TRUE(own);
    EXPECT_NEAR(leg(own->from).at.y, leg(own->to).at.y, 1e-9);
    for (const bool mirrored : {false, true}) {
      for (const bool reversed : {false, true}) {
        for (const double start : {0.0, 0.3, 2.0, 3.7, 5.1}) {
          const auto found = gait(changed(leg, mirrored, start, reversed), duty);
          ASSERT_TRUE(found);
          EXPECT_NEAR(found->stride, own->stride, 1e-7);
          EXPECT_NEAR(found->flatness(), own->flatness(), 1e-7);
          EXPECT_NEAR(found->speed_min, own->speed_min, 1e-4);
          const double from = start + (reversed ? -found->to : found->from);
          EXPECT_NEAR(std::remainder(from - own->from, kTurn), 0, 1e-6);
          ++checked;
        }
      }
    }
  }
  EXPECT_EQ(checked, 80);
}

TEST(Gait, OfManyLowestStancesHasLevelEnds) {
  const auto found = gait(by_differences(klann), 0.4);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->from, 12.7185 * kPi / 180, 1e-5);
  EXPECT_NEAR(found->stride, 0.96581, 1e-5);
  EXPECT_NEAR(found->flatness(), 0.05707, 1e-5);
}

/// Where every part of the turn is equally low and has level ends, the lowest ends decide.
TEST(Gait, OfAPathThatRepeatsBeginsAtItsLowest) {
  const auto level = [](double t) { return std::cos(2 * t - 1); };
  const auto rate = [](double t) { return -2 * std::sin(2 * t - 1); };
  const auto found = gait(over_cosine(level, rate), 0.5);
  ASSERT_TRUE(found);
  EXPECT_NEAR(level(found->from), -1, 1e-8);
}

}  // namespace
}  // namespace cognate::gait_test
