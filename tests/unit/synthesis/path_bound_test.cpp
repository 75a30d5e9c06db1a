/// Bounds over boxes against single designs in them, which are evaluated on another way: link
/// lengths by the definition of the coordinates, joints by intersecting circles in 113 bits, the
/// linear unknowns by a dense least-squares solver.
#include "synthesis/bounds/path_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/bounds/box_quadratic.hpp"
#include "tests/support/box_linkages.hpp"

namespace cognate::synthesis::path_bound_test {
namespace {

using test::best_fit;
using test::directions_at;
using test::error_of;
using test::Fit;
using test::links_at;
using Quad = test::Quad;
using Complex = std::complex<double>;
using Point = test::BoxPoint;

int repeats(int usual) {
  const char* asked = std::getenv("COGNATE_TEST_SEEDS");
  return asked ? std::max(1, std::min(usual, 40 * std::atoi(asked))) : usual;
}

class Random {
 public:
  explicit Random(unsigned seed) : source_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(source_);
  }
  bool chance(double share) { return uniform(0, 1) < share; }
  Complex point(double reach) { return {uniform(-reach, reach), uniform(-reach, reach)}; }

  /// A box of any size, often at the edge of what its sides may be, where change points lie.
  ProportionBox box() {
    ProportionBox box;
    const double kind = uniform(0, 3);
    box.proportions = kind < 1   ? Proportions::crank_shortest
                      : kind < 2 ? Proportions::frame_shortest
                                 : Proportions::any;
    const bool any = box.proportions == Proportions::any;
    const double low[4] = {box.proportions == Proportions::crank_shortest ? 0.5 : 0.01,
                           any ? -1.0 : 0.0, 0.0, 0.0};
    const double high[4] = {box.proportions == Proportions::frame_shortest ? 0.5 : 0.99,
                            any ? 1.0 : kPi, any ? 0.9 : kRightAngle, kTurn};
    const double scale = std::pow(10.0, uniform(-7, 0));
    for (int i = 0; i < kBoxSides; ++i) {
      const double width = scale * uniform(0, 1) * (high[i] - low[i]);
      double from = uniform(low[i], high[i] - width);
      if (chance(0.15)) from = low[i];
      if (chance(0.15)) from = high[i] - width;
      box.side[i] = {from, std::min(high[i], from + width)};
    }
    if (chance(0.3)) box.side[3] = Interval(box.side[3].low);
    box.assembly = chance(0.5) ? 1 : -1;
    return box;
  }

  Point in(const ProportionBox& box) {
    Point point{};
    for (int i = 0; i < kBoxSides; ++i) {
      const Interval& side = box.side[i];
      point[i] = chance(0.2) ? side.low : chance(0.2) ? side.high : uniform(side.low, side.high);
    }
    return point;
  }

 private:
  std::mt19937_64 source_;
};

TEST(PathBound, DirectionsOfABoxHoldThoseOfEachPoint) {
  Random random(1);
  int checked = 0, narrow = 0;
  for (int i = 0; i < repeats(4000); ++i) {
    const ProportionBox box = random.box();
    const BoxDirections enclosures(box);
    const double theta = random.chance(0.1) ? 0.0 : random.uniform(-kPi, kPi);
    for (const auto link : {DirectedLink::coupler, DirectedLink::rocker}) {
      const DirectionRange range = enclosures.at(theta, link);
      for (int trial = 0; trial < 4; ++trial) {
        const Point at = random.in(box);
        const auto links = links_at(box, at);
        if (!links) continue;
        const auto direction = directions_at(*links, box.assembly, Quad(theta) + Quad(at[3]));
        if (!direction) continue;
        ASSERT_TRUE(range.closes);
        double turned = 0;
        for (int s = 0; s < kBoxSides; ++s) {
          const double half = box.side[s].radius();
          if (half > 1e-299) turned += range.slope[s] * (at[s] - box.side[s].middle()) / half;
        }
        const Complex found =
            link == DirectedLink::coupler ? direction->coupler : direction->rocker;
        const Complex expected = Complex(range.middle.x, range.middle.y) * std::polar(1.0, turned);
        EXPECT_LE(std::abs(std::arg(found / expected)), range.radius + 1e-12) << i;
        ++checked;
        if (range.radius < 0.1) ++narrow;
      }
    }
  }
  EXPECT_GT(checked, repeats(4000));
  EXPECT_GT(narrow, checked / 4);  // else the test would say nothing
}

TimedPath random_path(Random& random) {
  TimedPath path;
  const int count = 4 + int(random.uniform(0, 6));
  for (int j = 0; j < count; ++j) {
    path.points.push_back(random.point(1));
    path.crank_angles.push_back(random.uniform(-kPi, kPi));
    path.weights.push_back(random.chance(0.3) ? random.uniform(0.1, 3) : 1.0);
  }
  path.pivot_fixed = random.chance(0.4);
  path.direction_fixed = random.chance(0.4);
  path.farthest_point = random.chance(0.4) ? random.uniform(0.2, 2) : kInfinity;
  for (int i = 0; i < 4; ++i) {
    double& least = path.lengths.least[i];
    least = random.chance(0.4) ? random.uniform(0, 0.8) : 0;
    path.lengths.greatest[i] = random.chance(0.4) ? least + random.uniform(0, 2) : kInfinity;
  }
  if (random.chance(0.1)) path.lengths.greatest[0] = path.lengths.least[0];
  return path;
}

/// A design at a point of the box that keeps to every limit, near the best there; empty if none.
std::optional<double> error_at(const TimedPath& path, const ProportionBox& box, const Point& at) {
  const auto links = links_at(box, at);
  if (!links) return std::nullopt;
  std::vector<Complex> u;
  for (const double angle : path.crank_angles) {
    const auto direction = directions_at(*links, box.assembly, Quad(angle) + Quad(at[3]));
    if (!direction) return std::nullopt;
    u.push_back(direction->coupler);
  }
  const double ratio[4] = {1, double(links->coupler / links->crank),
                           double(links->rocker / links->crank),
                           double(links->frame / links->crank)};
  double low = 0, high = kInfinity;
  for (int i = 0; i < 4; ++i) {
    low = std::max(low, path.lengths.least[i] / ratio[i]);
    high = std::min(high, path.lengths.greatest[i] / ratio[i]);
  }
  if (low > high) return std::nullopt;
  Fit fit = best_fit(path, u, std::nullopt);
  const double crank = path.direction_fixed ? fit.s.real() : std::abs(fit.s);
  const double allowed = std::clamp(crank, low, high);
  if (allowed != crank) {
    const Complex along = path.direction_fixed || crank == 0 ? Complex(1) : fit.s / std::abs(fit.s);
    fit = best_fit(path, u, allowed * along);
  }
  if (std::abs(fit.q) > path.farthest_point) {
    fit.q *= path.farthest_point / std::abs(fit.q);
    if (!path.pivot_fixed) {  // the best pivot for it
      Complex t;
      double weight = 0;
      for (std::size_t j = 0; j < u.size(); ++j) {
        const Complex e = std::polar(1.0, path.crank_angles[j]);
        t += path.weights[j] * (path.points[j] - fit.s * e - fit.q * u[j]);
        weight += path.weights[j];
      }
      fit.t = t / weight;
    }
  }
  return error_of(path, u, fit);
}

ProportionLimits no_limits() {
  ProportionLimits limits;
  limits.greatest_ratio = kInfinity;
  limits.transmission_max = kPi;
  return limits;
}

TEST(PathBound, NoDesignOfABoxIsBetterThanItsBound) {
  Random random(2);
  int checked = 0, tight = 0;
  for (int i = 0; i < repeats(4500); ++i) {
    const ProportionBox box = random.box();
    TimedPath path = random_path(random);
    const PathBound bound(path, no_limits());
    const auto first = error_at(path, box, random.in(box));
    if (!first) continue;
    // Just above what a design of the box reaches: a bound that claims it is wrong.
    const double target = *first * (random.chance(0.5) ? 1 + 1e-9 : random.uniform(0.3, 2));
    const BoxBound found = bound(box, target);
    for (int trial = 0; trial < 5; ++trial) {
      const auto error = trial == 0 ? first : error_at(path, box, random.in(box));
      if (!error) continue;
      EXPECT_LE(found.least, *error * (1 + 1e-11) + 1e-13) << i;
      ++checked;
      if (found.least > 0.5 * std::min(*error, target)) ++tight;
    }
  }
  EXPECT_GT(checked, repeats(4500));
  EXPECT_GT(tight, checked / 10);
}

TEST(PathBound, PlantedDesignKeepsItsBoxes) {
  Random random(3);
  int planted = 0, split = 0;
  for (int i = 0; i < repeats(600); ++i) {
    const ProportionBox whole = random.box();
    const Point at = random.in(whole);
    const auto links = links_at(whole, at);
    if (!links) continue;
    TimedPath path = random_path(random);
    const Complex t = path.pivot_fixed ? Complex() : random.point(1), q = random.point(1);
    const double crank = random.uniform(0.1, 1);
    const Complex s = path.direction_fixed ? crank : std::polar(crank, random.uniform(0, 6));
    bool closes = true;
    for (std::size_t j = 0; j < path.points.size() && closes; ++j) {
      const double angle = path.crank_angles[j];
      const auto direction = directions_at(*links, whole.assembly, Quad(angle) + Quad(at[3]));
      closes = direction.has_value();
      if (closes) path.points[j] = t + s * std::polar(1.0, angle) + q * direction->coupler;
    }
    if (!closes) continue;
    ++planted;
    const double lengths[4] = {crank, crank * double(links->coupler / links->crank),
                               crank * double(links->rocker / links->crank),
                               crank * double(links->frame / links->crank)};
    for (int l = 0; l < 4; ++l) {  // limits that the planted design just satisfies
      path.lengths.least[l] = random.chance(0.3) ? lengths[l] * (1 - 1e-12) : 0;
      path.lengths.greatest[l] = random.chance(0.3) ? lengths[l] * (1 + 1e-12) : kInfinity;
    }
    path.farthest_point = random.chance(0.5) ? std::abs(q) : kInfinity;
    const PathBound bound(path, no_limits());
    ProportionBox box = whole;
    while (true) {
      const BoxBound found = bound(box, 1e-12);
      ASSERT_LT(found.least, 1e-12) << i;
      if (found.split < 0) break;
      ++split;
      const auto [first, second] = halves(box, found.split);
      box = first.side[found.split].high >= at[found.split] ? first : second;
      if (box.side[found.split].radius() < 1e-9) break;
    }
  }
  EXPECT_GT(planted, repeats(600) / 4);
  EXPECT_GT(split, 10 * planted);
}

TEST(PathBound, LeastOfAQuadraticOverTheBox) {
  Random random(4);
  for (int i = 0; i < repeats(2000); ++i) {
    BoxQuadratic c{};
    const bool convex = random.chance(0.5);
    for (int a = 0; a <= kBoxSides; ++a) {
      for (int b = 0; b <= a; ++b) c[a][b] = c[b][a] = random.uniform(-1, 1);
      if (convex) c[a][a] += 4;
    }
    const auto value = [&](const Point& t) {
      double sum = 0;
      for (int a = 0; a <= kBoxSides; ++a) {
        for (int b = 0; b <= kBoxSides; ++b) {
          sum += c[a][b] * (a > 0 ? t[a - 1] : 1) * (b > 0 ? t[b - 1] : 1);
        }
      }
      return sum;
    };
    const double bound = least_over_box(c);
    double least = kInfinity;
    for (int trial = 0; trial < 50; ++trial) {
      Point t{};
      for (double& x : t)
        x = random.chance(0.3) ? (random.chance(0.5) ? 1 : -1) : random.uniform(-1, 1);
      least = std::min(least, value(t));
      // Down the coordinates to a minimum.
      for (int sweep = 0; convex && sweep < 200; ++sweep) {
        for (int k = 0; k < kBoxSides; ++k) {
          double pull = c[k + 1][0];
          for (int m = 0; m < kBoxSides; ++m) pull += m == k ? 0 : c[k + 1][m + 1] * t[m];
          t[k] = std::clamp(-pull / c[k + 1][k + 1], -1.0, 1.0);
        }
      }
      least = std::min(least, value(t));
    }
    EXPECT_LE(bound, least + 1e-12) << i;
    if (convex) {
      EXPECT_NEAR(bound, least, 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis::path_bound_test
