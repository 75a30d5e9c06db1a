// Measures of coupler curves on their circuits: against circles, polygons summed in extended
// precision, cognates, which trace the same curve, and the lengths of the links.
#include "analysis/coupler_curve/curve_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/coupler_curve/fourier_descriptors.hpp"
#include "analysis/coupler_curve/narrowest_strip.hpp"
#include "analysis/linkage/cognates.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::curve_measures_test {
namespace {

CurveRoom curve_of(const FourBar& linkage, const CircuitChoice& circuit, std::size_t count) {
  CurveRoom curve;
  sample_circuit(linkage, circuit, CycleTable(count), curve);
  return curve;
}

double length_of(const CurveRoom& curve) {
  CurveSums sums;
  sums.add_up(curve.samples(), 1);
  return sums.length[0];
}

double area_of(const CurveRoom& curve) {
  CurveSums sums;
  sums.add_up(curve.samples(), 1);
  return sums.area[0];
}

/// A linkage of random lengths that can be assembled well, away from change points.
class Linkages {
 public:
  FourBar next() {
    for (;;) {
      const double angle = draw(-3, 3), frame = draw(0.5, 3);
      const Vec2d a{draw(-2, 2), draw(-2, 2)};
      FourBar linkage{a,
                      a + frame * Vec2d{std::cos(angle), std::sin(angle)},
                      draw(0.3, 3),
                      draw(0.3, 3),
                      draw(0.3, 3),
                      draw(0, 1) < 0.5 ? Assembly::open : Assembly::crossed,
                      Vec2d{draw(-2, 3), draw(-2, 2)}};
      const auto links = lengths(linkage);
      const double most = std::max({links.crank, links.coupler, links.rocker, links.frame});
      const double slack = links.crank + links.coupler + links.rocker + links.frame - 2 * most;
      if (slack > 0.2 && std::abs(grashof_excess(links)) > 0.05) return linkage;
    }
  }
  double draw(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }

 private:
  std::mt19937_64 random_{7};
};

TEST(CircuitSamples, KeepTheLengthsOfTheLinksOnEveryKindOfCircuit) {
  Linkages linkages;
  int kinds[4] = {0, 0, 0, 0};
  for (int trial = 0; trial < 200; ++trial) {
    FourBar linkage = linkages.next();
    const auto links = lengths(linkage);
    const bool turns = crank_rotates(links);
    const auto ranges = crank_ranges(links);
    ++kinds[turns ? 0 : ranges.size() == 2 ? 1 : ranges[0].from < 0 ? 2 : 3];
    const CircuitChoice circuit = circuit_at(linkage, linkages.draw(-7, 7));
    linkage.coupler_point = Vec2d{0, 0};
    const CurveRoom b = curve_of(linkage, circuit, 64);
    linkage.coupler_point = Vec2d{linkage.coupler, 0};
    const CurveRoom c = curve_of(linkage, circuit, 64);
    double least = 4 * kPi, greatest = -4 * kPi;
    int with_assembly = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      const Vec2d at_b{b.x[i], b.y[i]}, at_c{c.x[i], c.y[i]};
      EXPECT_NEAR(norm(at_b - linkage.pivot_a), linkage.crank, 1e-12);
      EXPECT_NEAR(norm(at_c - at_b), linkage.coupler, 1e-12);
      EXPECT_NEAR(norm(at_c - linkage.pivot_d), linkage.rocker, 1e-12);
      const bool open = cross(linkage.pivot_d - at_b, at_c - at_b) > 0;
      const bool same = open == (linkage.assembly == Assembly::open);
      with_assembly += same ? 1 : 0;
      const Vec2d arm = at_b - linkage.pivot_a;
      const double angle = std::remainder(std::atan2(arm.y, arm.x) - frame_angle(linkage), kTurn);
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
      // In the assembly named the crank's angle grows.
      if (same) {
        EXPECT_GT(cross(arm, {b.dx[i], b.dy[i]}), -1e-9);
      }
    }
    if (turns) {
      EXPECT_EQ(with_assembly, 64);
    } else {
      EXPECT_NEAR(with_assembly, 32, 2);
    }
    if (ranges.size() == 2) {
      EXPECT_GT(least, (circuit.half > 0 ? ranges[0].from : ranges[1].from) - 1e-9);
      EXPECT_LT(greatest, (circuit.half > 0 ? ranges[0].to : ranges[1].to) + 1e-9);
    }
  }
  for (const int seen : kinds) EXPECT_GT(seen, 5);
}

TEST(CircuitSamples, DerivativesAreThoseOfTheSamples) {
  Linkages linkages;
  for (int trial = 0; trial < 40; ++trial) {
    const FourBar linkage = linkages.next();
    const std::size_t count = 4096;
    const CurveRoom curve = curve_of(linkage, circuit_at(linkage, 0), count);
    const double step = kTurn / count;
    for (std::size_t i = 2; i + 2 < count; i += 97) {
      const auto slope = [&](const std::vector<double>& f) {
        return (8 * (f[i + 1] - f[i - 1]) - (f[i + 2] - f[i - 2])) / (12 * step);
      };
      EXPECT_NEAR(curve.dx[i], slope(curve.x), 1e-5);
      EXPECT_NEAR(curve.dy[i], slope(curve.y), 1e-5);
    }
  }
}

TEST(CircuitSamples, TheCircuitIsTheOneOfThePosition) {
  // Crank 2, coupler 1, rocker 1.9, frame 1.6: the coupler is the shortest, two ranges.
  const FourBar linkage{{0, 0}, {1.6, 0}, 2, 1, 1.9, Assembly::open, Vec2d{1, 1}};
  const auto ranges = crank_ranges(lengths(linkage));
  ASSERT_EQ(ranges.size(), 2U);
  const double middle = 0.5 * (ranges[0].from + ranges[0].to);
  EXPECT_EQ(circuit_at(linkage, middle).half, 1);
  EXPECT_EQ(circuit_at(linkage, -middle).half, -1);
  EXPECT_EQ(circuit_at(linkage, kTurn + middle).half, 1);
  EXPECT_EQ(circuit_at(linkage, 0).half, 1);     // reaches the upper range first
  EXPECT_EQ(circuit_at(linkage, kPi).half, -1);  // and from there the lower
}

TEST(CurveMeasures, ThePathOfTheCrankPinIsACircle) {
  const FourBar linkage{{300, -200}, {304, -200}, 1, 4, 3, Assembly::open, Vec2d{0, 0}};
  const CurveRoom curve = curve_of(linkage, {}, 128);
  EXPECT_NEAR(length_of(curve), kTurn, 1e-12);
  EXPECT_NEAR(area_of(curve), kPi, 1e-11);
  const CurveWidths widths = WidthFinder()(curve.samples());
  EXPECT_NEAR(widths.least, 2, 1e-7);
  EXPECT_NEAR(widths.greatest, 2, 1e-7);
  const FourierDescriptors found = DescriptorFinder()(curve.samples());
  EXPECT_NEAR(found.of(1).x, 1, 1e-12);
  for (int k = -kHarmonics; k <= kHarmonics; ++k) {
    if (k != 1) {
      EXPECT_NEAR(norm(found.of(k)), 0, 1e-11) << k;
    }
  }
}

/// Length and area of the polygon through samples, in extended precision; the length with its
/// error of the square of the step taken out by the polygon of every second sample.
std::pair<double, double> of_polygon(const CurveRoom& curve) {
  const std::size_t count = curve.x.size();
  const auto length = [&](std::size_t stride) {
    long double sum = 0;
    for (std::size_t i = 0; i < count; i += stride) {
      const std::size_t k = (i + stride) % count;
      sum += std::hypot(static_cast<long double>(curve.x[k]) - curve.x[i],
                        static_cast<long double>(curve.y[k]) - curve.y[i]);
    }
    return sum;
  };
  long double area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = (i + 1) % count;
    area += 0.5L * (static_cast<long double>(curve.x[i]) * curve.y[k] -
                    static_cast<long double>(curve.x[k]) * curve.y[i]);
  }
  return {static_cast<double>((4 * length(1) - length(2)) / 3), static_cast<double>(area)};
}

TEST(CurveMeasures, SettledSumsAreThoseOfFinePolygons) {
  Linkages linkages;
  int settled = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const FourBar linkage = linkages.next();
    const CircuitChoice circuit = circuit_at(linkage, 0);
    for (const std::size_t count : kCurveSteps) {
      const CurveRoom curve = curve_of(linkage, circuit, count);
      CurveSums sums;
      sums.add_up(curve.samples(), 1);
      if (!sums.is_settled(0)) continue;
      ++settled;
      const auto [length, area] = of_polygon(curve_of(linkage, circuit, 1 << 15));
      EXPECT_NEAR(sums.length[0], length, 3e-9 * length) << count;
      EXPECT_NEAR(sums.area[0], area, 3e-7 * length * length) << count;
      break;
    }
  }
  EXPECT_EQ(settled, 60);
}

TEST(CurveMeasures, WidthsAreThoseOfFinePolygons) {
  Linkages linkages;
  for (int trial = 0; trial < 25; ++trial) {
    const FourBar linkage = linkages.next();
    const CircuitChoice circuit = circuit_at(linkage, 0);
    const CurveRoom curve = curve_of(linkage, circuit, 256);
    const CurveWidths widths = WidthFinder()(curve.samples());
    const CurveRoom fine = curve_of(linkage, circuit, 2048);
    std::vector<Vec2d> points;
    double greatest = 0;
    for (std::size_t i = 0; i < fine.x.size(); ++i) points.push_back({fine.x[i], fine.y[i]});
    for (const Vec2d& p : points) {
      for (const Vec2d& q : points) greatest = std::max(greatest, squared_norm(p - q));
    }
    greatest = std::sqrt(greatest);
    EXPECT_NEAR(widths.greatest, greatest, 1e-5 * greatest);
    EXPECT_NEAR(widths.least, 2 * StripFinder()(points).half_width, 1e-5 * greatest);
  }
}

TEST(CurveMeasures, CognatesTraceTheSameCurve) {
  Linkages linkages;
  int seen = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const FourBar linkage = linkages.next();
    const double start = linkages.draw(-3, 3);
    const auto cognate = coupler_cognate(linkage, start);
    const auto timed = timed_cognate(linkage);
    if (!cognate || !timed) continue;
    ++seen;
    const CurveRoom own = curve_of(linkage, circuit_at(linkage, start), 2048);
    const CurveRoom others[] = {
        curve_of(cognate->linkage, circuit_at(cognate->linkage, cognate->crank_angle), 2048),
        curve_of(*timed, circuit_at(*timed, start - frame_angle(linkage) + frame_angle(*timed)),
                 2048)};
    const FourierDescriptors mine = DescriptorFinder()(own.samples());
    for (const CurveRoom& other : others) {
      EXPECT_NEAR(length_of(other), length_of(own), 1e-8 * length_of(own));
      EXPECT_NEAR(std::abs(area_of(other)), std::abs(area_of(own)), 1e-8 * length_of(own));
      const FourierDescriptors theirs = DescriptorFinder()(other.samples());
      for (int k = -kHarmonics; k <= kHarmonics; ++k) {
        EXPECT_NEAR(norm(theirs.of(k)), norm(mine.of(k)), 1e-7) << k;
      }
    }
  }
  EXPECT_GT(seen, 30);
}

TEST(FourierDescriptors, DoNotChangeWithPlaceSizeTurnStartAndSense) {
  Linkages linkages;
  for (int trial = 0; trial < 20; ++trial) {
    const FourBar linkage = linkages.next();
    const CurveRoom curve = curve_of(linkage, circuit_at(linkage, 0), 512);
    const Vec2d factor{linkages.draw(-3, 3), linkages.draw(0.5, 2)}, shift{7, -5};
    const std::size_t start = 203;
    CurveRoom moved;
    moved.resize(512);
    for (std::size_t i = 0; i < 512; ++i) {
      const std::size_t k = (start + 512 - i) % 512;  // backwards
      const Vec2d at = shift + factor * Vec2d{curve.x[k], curve.y[k]};
      const Vec2d rate = factor * Vec2d{-curve.dx[k], -curve.dy[k]};
      moved.x[i] = at.x;
      moved.y[i] = at.y;
      moved.dx[i] = rate.x;
      moved.dy[i] = rate.y;
    }
    const FourierDescriptors mine = DescriptorFinder()(curve.samples());
    const FourierDescriptors theirs = DescriptorFinder()(moved.samples());
    for (int k = -kHarmonics; k <= kHarmonics; ++k) {
      EXPECT_NEAR(norm(theirs.of(k) - mine.of(k)), 0, 1e-7) << k;
    }
    EXPECT_NEAR(mine.of(1).y, 0, 1e-12);
    EXPECT_GT(mine.of(1).x, 0);
    EXPECT_NEAR(mine.of(-1).y, 0, 1e-12);
    EXPECT_GE(mine.of(2).x, -1e-12);
  }
}

TEST(FourierDescriptors, AreTheCoefficientsOfAnEllipseByItsArcLength) {
  // x = 2 cos φ, y = sin φ: by direct sums over points in equal steps of the arc, found by a fine
  // table of it. Symmetric in half a turn: no even harmonics.
  const std::size_t fine = 1 << 16, count = 256;
  std::vector<double> arc(fine + 1, 0);
  const auto at = [&](double k) {
    const double t = kTurn * k / fine;
    return Vec2d{2 * std::cos(t), std::sin(t)};
  };
  for (std::size_t k = 0; k < fine; ++k) {
    arc[k + 1] = arc[k] + norm(at(static_cast<double>(k + 1)) - at(static_cast<double>(k)));
  }
  CurveRoom curve;
  const CycleTable table(count);
  for (std::size_t i = 0; i < count; ++i) {
    curve.x.push_back(2 * table.cos[i]);
    curve.y.push_back(table.sin[i]);
    curve.dx.push_back(-2 * table.sin[i]);
    curve.dy.push_back(table.cos[i]);
  }
  const FourierDescriptors found = DescriptorFinder()(curve.samples());
  for (const int k : {-3, -1, 1, 3}) {
    double sum = 0;
    for (std::size_t i = 0; i < fine; ++i) {
      const double phase = kTurn * k * 0.5 * (arc[i] + arc[i + 1]) / arc[fine];
      const Vec2d middle = at(static_cast<double>(i) + 0.5);
      sum += (arc[i + 1] - arc[i]) * (middle.x * std::cos(phase) + middle.y * std::sin(phase));
    }
    EXPECT_NEAR(found.of(k).x, sum / arc[fine] / (arc[fine] / (kTurn)), 1e-7) << k;
    EXPECT_NEAR(found.of(k).y, 0, 1e-9) << k;
  }
  EXPECT_NEAR(norm(found.of(2)) + norm(found.of(-4)), 0, 1e-10);
}

TEST(MovingPivotsSize, IsTheDiagonalOfTheBoxOfSamples) {
  Linkages linkages;
  for (int trial = 0; trial < 100; ++trial) {
    FourBar linkage = linkages.next();
    const CircuitChoice circuit = circuit_at(linkage, linkages.draw(-7, 7));
    const double size = moving_pivots_size(linkage, circuit);
    linkage.coupler_point = Vec2d{0, 0};
    CurveRoom both = curve_of(linkage, circuit, 4096);
    linkage.coupler_point = Vec2d{linkage.coupler, 0};
    const CurveRoom c = curve_of(linkage, circuit, 4096);
    both.x.insert(both.x.end(), c.x.begin(), c.x.end());
    both.y.insert(both.y.end(), c.y.begin(), c.y.end());
    const auto [left, right] = std::ranges::minmax(both.x);
    const auto [low, high] = std::ranges::minmax(both.y);
    EXPECT_NEAR(size, std::hypot(right - left, high - low), 1e-4 * size);
  }
}

}  // namespace
}  // namespace cognate::curve_measures_test
