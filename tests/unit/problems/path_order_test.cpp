/// Places of points along a coupler curve: against brute force over a fine grid of the crank, whose
/// four-bar is two intersecting circles, and the derivatives of the model that keeps them.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <random>

#include "analysis/linkage/defects.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/path/order.hpp"
#include "problems/path/ordered_model.hpp"

namespace cognate::problems::path_order_test {
namespace {

using Complex = std::complex<double>;
constexpr int kGrid = 360;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

FourBar random_linkage(std::mt19937_64& random) {
  for (;;) {
    const double a = uniform(random, 0.3, 2), b = uniform(random, 0.3, 2);
    const double c = uniform(random, 0.3, 2), d = uniform(random, 0.3, 2);
    if (2 * std::max({a, b, c, d}) > 0.95 * (a + b + c + d)) continue;
    const double turn = uniform(random, -3, 3);
    const Vec2d pivot{uniform(random, -1, 1), uniform(random, -1, 1)};
    return {pivot,
            pivot + d * Vec2d{std::cos(turn), std::sin(turn)},
            a,
            b,
            c,
            random() % 2 ? Assembly::open : Assembly::crossed,
            Vec2d{uniform(random, -1, 2), uniform(random, -1, 1)}};
  }
}

/// The coupler point by the intersection of two circles; not a number where there is none.
Complex coupler_point(const FourBar& linkage, double from_x_axis) {
  const Complex a(linkage.pivot_a.x, linkage.pivot_a.y), d(linkage.pivot_d.x, linkage.pivot_d.y);
  const Complex b = a + std::polar(linkage.crank, from_x_axis);
  const double distance = std::abs(d - b);
  const double along =
      (distance * distance + linkage.coupler * linkage.coupler - linkage.rocker * linkage.rocker) /
      (2 * distance);
  const double across =
      sign(linkage.assembly) * std::sqrt(linkage.coupler * linkage.coupler - along * along);
  const Complex c = b + Complex(along, across) * (d - b) / distance;
  return b +
         Complex(linkage.coupler_point->x, linkage.coupler_point->y) * (c - b) / linkage.coupler;
}

/// μ by the law of cosines in the triangle B–C–D; not a number where the linkage does not close.
double transmission(const FourBar& linkage, double from_x_axis) {
  const Complex a(linkage.pivot_a.x, linkage.pivot_a.y), d(linkage.pivot_d.x, linkage.pivot_d.y);
  const double square = std::norm(d - a - std::polar(linkage.crank, from_x_axis));
  return std::acos((linkage.coupler * linkage.coupler + linkage.rocker * linkage.rocker - square) /
                   (2 * linkage.coupler * linkage.rocker));
}

/// Points about the curve, in order along an arc or a turn, disturbed by some share of its size.
std::vector<Vec2d> points_about(const FourBar& linkage, std::mt19937_64& random, int count) {
  std::vector<Vec2d> points;
  const double noise = uniform(random, 0, 0.3), sense = random() % 2 ? 1 : -1;
  double angle = uniform(random, 0, kTurn);
  const double sweep = uniform(random, 0.5, kTurn);
  while (int(points.size()) < count) {
    angle += sense * sweep / count;
    const Complex at = coupler_point(linkage, angle);
    if (!std::isfinite(at.real())) continue;
    points.push_back(
        {at.real() + noise * uniform(random, -1, 1), at.imag() + noise * uniform(random, -1, 1)});
  }
  return points;
}

/// The least sum of squares with the points in order on the grid from `first` on.
double best_from(const std::vector<std::optional<Vec2d>>& grid, const std::vector<Vec2d>& points,
                 int first, int sense) {
  std::vector<double> cost(kGrid + 1, 0);
  for (const Vec2d& point : points) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kGrid; ++i) {
      least = std::min(least, cost[i]);
      const auto& at = grid[((first + sense * i) % kGrid + kGrid) % kGrid];
      // Nothing beyond a gap is reached.
      if (!at) {
        std::fill(cost.begin() + i, cost.end(), std::numeric_limits<double>::infinity());
        break;
      }
      cost[i] = least + squared_norm(*at - point);
    }
  }
  return *std::ranges::min_element(cost);
}

double brute_force(const FourBar& linkage, const std::vector<Vec2d>& points, int sense,
                   const Range& limits = {0, kPi}) {
  std::vector<std::optional<Vec2d>> grid;
  for (int i = 0; i < kGrid; ++i) {
    const Complex at = coupler_point(linkage, kTurn * i / kGrid);
    const double mu = transmission(linkage, kTurn * i / kGrid);
    const bool is_allowed = limits.min <= mu && mu <= limits.max;
    grid.push_back(is_allowed ? std::optional(Vec2d{at.real(), at.imag()}) : std::nullopt);
  }
  double least = std::numeric_limits<double>::infinity();
  for (int first = 0; first < kGrid; ++first) {
    least = std::min(least, best_from(grid, points, first, sense));
  }
  return least;
}

TEST(PathOrder, IsNoWorseThanBruteForceAndInOrder) {
  std::mt19937_64 random(1);
  int tested = 0, held = 0, worse = 0, ranges = 0;
  for (; tested < 300; ++tested) {
    const FourBar linkage = random_linkage(random);
    PathProblem problem;
    problem.points = points_about(linkage, random, 4 + int(random() % 6));
    const bool clockwise = random() % 2;
    PathOrderWorkspace workspace;
    const auto* places = PathOrder(problem).places(linkage, {}, clockwise, workspace);
    ASSERT_NE(places, nullptr);
    std::vector<double> angles;
    double cost = 0;
    for (std::size_t j = 0; j < problem.points.size(); ++j) {
      angles.push_back(places->of_point[j].angle + frame_angle(linkage));
      const Complex at = coupler_point(linkage, angles.back());
      cost += std::norm(at - Complex(problem.points[j].x, problem.points[j].y));
    }
    EXPECT_NEAR(places->cost, cost, 1e-7 * (1 + cost));
    const Defects defects = find_defects(linkage, angles, Sequence::one_sense);
    EXPECT_FALSE(defects.order || defects.circuit);
    const double brute = brute_force(linkage, problem.points, clockwise ? -1 : 1);
    // The grid misses its minimum by the square of half a step; ours may choose another basin.
    EXPECT_LE(places->cost, 1.05 * brute + 1e-3) << tested;
    worse += places->cost > brute * (1 + 1e-9) + 1e-12;
    held += places->any_held();
    ranges += !crank_rotates(lengths(linkage));
  }
  EXPECT_EQ(tested, 300);
  EXPECT_GT(held, 100);
  EXPECT_GT(ranges, 60);
  EXPECT_LE(worse, 6);
}

TEST(PathOrder, KeepsToTheTransmissionAngleWhereTheCrankDoesNotTurnFully) {
  std::mt19937_64 random(4);
  int tested = 0, bound = 0, nowhere = 0;
  while (tested < 200) {
    const FourBar linkage = random_linkage(random);
    if (crank_rotates(lengths(linkage))) continue;
    PathProblem problem;
    problem.points = points_about(linkage, random, 4 + int(random() % 6));
    const Range limits{uniform(random, 0.2, 1.2), uniform(random, 1.9, 2.9)};
    const bool clockwise = random() % 2;
    PathOrderWorkspace workspace;
    const auto* places = PathOrder(problem, limits).places(linkage, {}, clockwise, workspace);
    const double brute = brute_force(linkage, problem.points, clockwise ? -1 : 1, limits);
    ++tested;
    if (!places) {
      EXPECT_FALSE(std::isfinite(brute)) << tested;
      ++nowhere;
      continue;
    }
    std::vector<double> angles;
    for (const PlaceInOrder& place : places->of_point) {
      angles.push_back(place.angle + frame_angle(linkage));
      const double mu = transmission(linkage, angles.back());
      EXPECT_TRUE(mu >= limits.min - 1e-8 && mu <= limits.max + 1e-8) << mu;
      const bool at_limit = mu < limits.min + 1e-6 || mu > limits.max - 1e-6;
      EXPECT_EQ(at_limit, place.held_by == HeldBy::range_end) << tested;
      bound += at_limit;
    }
    const Defects defects = find_defects(linkage, angles, Sequence::one_sense);
    EXPECT_FALSE(defects.order || defects.circuit);
    if (std::isfinite(brute)) {
      EXPECT_LE(places->cost, 1.05 * brute + 2e-3) << tested;
    }
  }
  EXPECT_GT(bound, 200);
  EXPECT_GT(nowhere, 2);
}

TEST(PathOrder, InAnyOrderEachPointLiesAtTheNearestPlace) {
  std::mt19937_64 random(2);
  int tested = 0;
  while (tested < 100) {
    const FourBar linkage = random_linkage(random);
    if (!crank_rotates(lengths(linkage))) continue;
    PathProblem problem;
    problem.order = PointOrder::any;
    problem.points = points_about(linkage, random, 8);
    std::ranges::shuffle(problem.points, random);
    PathOrderWorkspace workspace;
    const auto* places = PathOrder(problem).places(linkage, {}, false, workspace);
    ASSERT_NE(places, nullptr);
    double least = 0;
    for (const Vec2d& point : problem.points) {
      double square = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 3600; ++i) {
        const Complex at = coupler_point(linkage, kTurn * i / 3600);
        square = std::min(square, std::norm(at - Complex(point.x, point.y)));
      }
      least += square;
    }
    EXPECT_LE(places->cost, least * (1 + 1e-9) + 1e-12);
    ++tested;
  }
  EXPECT_EQ(tested, 100);
}

/// Jᵀr against central differences of the sum of squares, over every way that a point is held.
TEST(PathOrder, TheModelsGradientIsThatOfTheLeastSumInOrder) {
  std::mt19937_64 random(3);
  std::map<HeldBy, int> seen;
  int tested = 0, shared = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const FourBar linkage = random_linkage(random);
    PathProblem problem;
    problem.points = points_about(linkage, random, 9);
    std::vector<double> angles(9, 0.0);
    if (trial % 3 == 0) problem.constraints.transmission_angle = Range{0.4, 2.7};
    if (trial % 2) {
      problem.timing = Timing::mixed;
      problem.crank_reference = trial % 4 == 1 ? CrankReference::first : CrankReference::global;
      problem.has_crank_angle = {true, false, false, true, false, false, true, false, false};
      const double start = uniform(random, 0, kTurn), step = uniform(random, 0.02, 0.5);
      for (int j = 0; j < 9; ++j) angles[j] = start + step * j;
      problem.crank_angles = angles;
    }
    const PathModel model(problem, linkage.assembly, false);
    const OrderedPathModel ordered(problem, model, false);
    std::vector<double> x = model.variables_of(linkage, angles);
    x.resize(ordered.variables().size());
    const std::size_t n = x.size(), rows = 18;
    std::vector<double> r(rows), jacobian(rows * n);
    if (!ordered.residuals(x, r, jacobian, {})) continue;
    const auto cost = [&](std::size_t i, double step) {
      std::vector<double> there = x, residuals(rows);
      there[i] += step;
      if (!ordered.residuals(there, residuals, {}, {})) return std::nan("");
      double sum = 0;
      for (const double each : residuals) sum += each * each;
      return sum;
    };
    for (std::size_t i = 0; i < n; ++i) {
      double slope = 0, size = 0;
      for (std::size_t row = 0; row < rows; ++row) {
        slope += 2 * r[row] * jacobian[row * n + i];
        size += std::abs(r[row] * jacobian[row * n + i]);
      }
      constexpr double h = 1e-6;
      const double difference = (cost(i, h) - cost(i, -h)) / (2 * h);
      if (std::isfinite(difference)) {
        EXPECT_NEAR(slope, difference, 1e-3 * (size + 0.1)) << trial;
      }
    }
    const auto whole = ordered.whole(x);
    std::map<std::size_t, int> members;
    for (const PlaceInOrder& place : whole->places.of_point) {
      ++seen[place.held_by];
      if (place.held_by == HeldBy::nothing) shared += ++members[place.block] == 2;
    }
    ++tested;
  }
  EXPECT_GT(tested, 250);
  EXPECT_GT(shared, 50);
  for (const HeldBy by :
       {HeldBy::timing, HeldBy::nothing, HeldBy::range_end, HeldBy::timed_point}) {
    EXPECT_GT(seen[by], 20) << int(by);
  }
}

}  // namespace
}  // namespace cognate::problems::path_order_test
