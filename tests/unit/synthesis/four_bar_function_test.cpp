// Exact function generators: planted linkages come back, and published ones come out.
#include "synthesis/exact/function/four_bar_function.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "tests/support/planted_generators.hpp"

namespace cognate::synthesis::four_bar_function_test {
namespace {

using test::PlantedFourBar;
using test::Random;

constexpr double kEpsilon = 2.220446049250313e-16;

double turn_between(double a, double b) {
  return std::abs(std::remainder(a - b, kTurn));
}

/// How far `found` is from `planted`: lengths relative to the largest, angles in radians.
double distance(const FourBarFunction& found, const PlantedFourBar& planted) {
  const double size = std::max({1.0, planted.coupler, planted.rocker, planted.frame});
  return std::max({std::abs(found.links.coupler - planted.coupler) / size,
                   std::abs(found.links.rocker - planted.rocker) / size,
                   std::abs(found.links.frame - planted.frame) / size,
                   turn_between(found.input_start, planted.input_start),
                   turn_between(found.output_start, planted.output_start)});
}

/// The error of the output at `point`, by whichever assembly is nearer.
double error_at(const FourBarFunction& found, const PrecisionPoint& point) {
  double least = HUGE_VAL;
  for (const double side : {1.0, -1.0}) {
    const PlantedFourBar linkage{found.links.coupler, found.links.rocker, found.links.frame, side,
                                 found.input_start,   found.output_start};
    if (const auto values = output(linkage, point.input)) {
      least = std::min(least, turn_between((*values)[0], point.output[0]));
    }
  }
  return least;
}

struct Tally {
  int tried = 0, recovered = 0, solutions = 0;
  double worst_residual = 0;
};

/// Plants linkages until `wanted` of them pass through their points, and looks for each.
Tally recover(const std::vector<int>& multiplicities, bool give_input, bool give_output, int wanted,
              double step, unsigned seed) {
  Random random(seed);
  Tally tally;
  while (tally.tried < wanted) {
    const PlantedFourBar planted = test::random_four_bar(random);
    const auto points = planted_points(planted, multiplicities, step, random);
    if (points.empty()) continue;
    ++tally.tried;
    GivenStart start;
    if (give_input) start.input = planted.input_start;
    if (give_output) start.output = planted.output_start;
    const FourBarFunctions found = four_bar_functions(points, start);
    tally.solutions += static_cast<int>(found.solutions.size());
    bool seen = false;
    for (const FourBarFunction& solution : found.solutions) {
      tally.worst_residual = std::max(tally.worst_residual, solution.residual);
      if (solution.outcome != FourBarOutcome::linkage) continue;
      // A double root is found to the root of the rounding only.
      const double allowed = 100 * kEpsilon * solution.condition;
      const double size = std::max({planted.coupler, planted.rocker, planted.frame, 1.0});
      const double stretch = size * size / std::min({planted.rocker, planted.frame, 1.0});
      seen = seen || distance(solution, planted) <= allowed * stretch * stretch;
    }
    tally.recovered += seen;
    if (!seen) {
      ADD_FAILURE() << "coupler " << planted.coupler << " rocker " << planted.rocker << " frame "
                    << planted.frame << " start " << planted.input_start << " "
                    << planted.output_start << " side " << planted.side << " solutions "
                    << found.solutions.size();
    }
  }
  return tally;
}

struct Planting {
  std::string name;
  std::vector<int> multiplicities;
  bool input = false, output = false;
};

class FourBarFunctionTest : public ::testing::TestWithParam<Planting> {};

TEST_P(FourBarFunctionTest, EveryPlantedLinkageIsRecovered) {
  const Planting& c = GetParam();
  const Tally tally = recover(c.multiplicities, c.input, c.output, 3000, 0.4, 7);
  EXPECT_EQ(tally.recovered, tally.tried);
  EXPECT_LT(tally.worst_residual, 1e-13);
  RecordProperty("solutions", tally.solutions);
}

INSTANTIATE_TEST_SUITE_P(Plantings, FourBarFunctionTest,
                         ::testing::Values(Planting{"Five", {1, 1, 1, 1, 1}},
                                           Planting{"FourWithInput", {1, 1, 1, 1}, true},
                                           Planting{"FourWithOutput", {1, 1, 1, 1}, false, true},
                                           Planting{"Three", {1, 1, 1}, true, true},
                                           Planting{"ThreeByOnePoint", {3}, true, true},
                                           Planting{"ThreeByTwoPoints", {2, 1}, true, true},
                                           Planting{"FourByOnePoint", {4}, true},
                                           Planting{"FourByTwoPoints", {2, 2}, false, true},
                                           Planting{"FiveByTwoPoints", {4, 1}},
                                           Planting{"FiveByThreePoints", {2, 1, 2}}),
                         [](const auto& info) { return info.param.name; });

// Li Bincheng, Xu Chao, Mechanism Theory with MATLAB (2011), example 3-6.
TEST(FourBarFunction, ThreePairsOfTheTextbook) {
  const std::array<PrecisionPoint, 3> points{PrecisionPoint{45 * kDegree, {50 * kDegree}},
                                             {90 * kDegree, {80 * kDegree}},
                                             {135 * kDegree, {110 * kDegree}}};
  const auto found = four_bar_functions(points, {0.0, 0.0});
  ASSERT_EQ(found.solutions.size(), 1U);
  const FourBarFunction& linkage = found.solutions[0];
  EXPECT_NEAR(linkage.links.coupler, 1.7830234404270595, 1e-14);
  EXPECT_NEAR(linkage.links.rocker, 1.533039584971189, 1e-14);
  EXPECT_NEAR(linkage.links.frame, 1.442394657972159, 1e-14);
  EXPECT_FALSE(linkage.input_turned || linkage.output_turned);
}

/// The error of the equations with the coefficients k at the five pairs, by φ₀ and ψ₀.
struct Residuals {
  const std::vector<PrecisionPoint>& points;

  Eigen::Matrix<double, 5, 1> operator()(const Eigen::Matrix<double, 5, 1>& x) const {
    Eigen::Matrix<double, 5, 1> r;
    for (int i = 0; i < 5; ++i) {
      const double t1 = points[i].input + x[3], t3 = points[i].output[0] + x[4];
      r[i] = x[0] * std::cos(t1) + x[1] * std::cos(t3) + x[2] - std::cos(t1 - t3);
    }
    return r;
  }

  /// Newton's method with differences for slopes; empty where it does not arrive.
  std::optional<std::array<double, 2>> root_from(double phi, double psi) const {
    Eigen::Matrix<double, 5, 3> m;
    Eigen::Matrix<double, 5, 1> right;
    for (int i = 0; i < 5; ++i) {
      const double t1 = points[i].input + phi, t3 = points[i].output[0] + psi;
      m.row(i) << std::cos(t1), std::cos(t3), 1;
      right[i] = std::cos(t1 - t3);
    }
    Eigen::Matrix<double, 5, 1> x;
    x << m.colPivHouseholderQr().solve(right), phi, psi;
    for (int step = 0; step < 40; ++step) {
      const auto r = (*this)(x);
      if (r.cwiseAbs().maxCoeff() < 1e-12 * (1 + x.cwiseAbs().maxCoeff())) {
        return std::array{std::remainder(x[3], kPi), std::remainder(x[4], kPi)};
      }
      Eigen::Matrix<double, 5, 5> slopes;
      for (int j = 0; j < 5; ++j) {
        const double h = 1e-6 * (1 + std::abs(x[j]));
        auto ahead = x, behind = x;
        ahead[j] += h;
        behind[j] -= h;
        slopes.col(j) = ((*this)(ahead) - (*this)(behind)) / (2 * h);
      }
      x -= slopes.fullPivLu().solve(r);
      if (!x.allFinite() || x.head<3>().cwiseAbs().maxCoeff() > 1e6) return std::nullopt;
    }
    return std::nullopt;
  }
};

/// A second route to the five-point solutions: Newton's method from a grid of start angles.
std::vector<std::array<double, 2>> roots_by_search(const std::vector<PrecisionPoint>& points) {
  std::vector<std::array<double, 2>> roots;
  constexpr int kGrid = 16;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const auto root =
        Residuals{points}.root_from(kPi * (i / kGrid) / kGrid, kPi * (i % kGrid) / kGrid);
    if (!root) continue;
    const bool known = std::ranges::any_of(roots, [&](const auto& other) {
      return std::abs(std::remainder((*root)[0] - other[0], kPi)) < 1e-5 &&
             std::abs(std::remainder((*root)[1] - other[1], kPi)) < 1e-5;
    });
    if (!known) roots.push_back(*root);
  }
  return roots;
}

TEST(FourBarFunction, TheCubicFindsWhatASearchFinds) {
  Random random(11);
  int three = 0, compared = 0, agree = 0;
  while (compared < 40) {
    const auto planted = test::random_four_bar(random);
    const auto points = planted_points(planted, {1, 1, 1, 1, 1}, 0.5, random);
    if (points.empty()) continue;
    const auto found = four_bar_functions(points, {});
    ASSERT_TRUE(found.solutions.size() == 1 || found.solutions.size() == 3);
    ++compared;
    three += found.solutions.size() == 3;
    const auto roots = roots_by_search(points);
    agree += roots.size() == found.solutions.size();
    EXPECT_LE(roots.size(), found.solutions.size());
    for (const auto& root : roots) {
      EXPECT_TRUE(std::any_of(found.solutions.begin(), found.solutions.end(), [&](const auto& f) {
        return std::abs(std::remainder(f.input_start - root[0], kPi)) < 1e-4 &&
               std::abs(std::remainder(f.output_start - root[1], kPi)) < 1e-4;
      }));
    }
  }
  EXPECT_GE(agree, compared - 3);  // Newton's method may miss a root that attracts little
  EXPECT_GT(three, 5);
}

// What is called a linkage meets all pairs by the triangle's formulas.
TEST(FourBarFunction, EveryLinkageMeetsItsPairs) {
  Random random(5);
  int linkages = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<PrecisionPoint> points;
    for (int i = 0; i < 5; ++i) {
      points.push_back({0.4 * i, {0.4 * i * test::between(random, 0.6, 1.4)}});
    }
    const auto found = four_bar_functions(points, {});
    ASSERT_FALSE(found.dependent);
    ASSERT_TRUE(found.solutions.size() == 1 || found.solutions.size() == 3) << trial;
    for (const FourBarFunction& f : found.solutions) {
      if (f.outcome != FourBarOutcome::linkage) continue;
      ++linkages;
      for (const PrecisionPoint& point : points) {
        const double error = error_at(f, point);
        if (error == HUGE_VAL) continue;  // near a dead point, where the formulas are not tried
        EXPECT_LT(error, 1e-12 * f.condition) << trial;
      }
    }
  }
  EXPECT_GT(linkages, 1000);
}

TEST(FourBarFunction, NamesWhatIsNoFourBar) {
  // Two pairs alike.
  const std::vector<PrecisionPoint> same{{0.3, {0.5}}, {0.3, {0.5}}, {1.0, {1.2}}};
  EXPECT_TRUE(four_bar_functions(same, {0.0, 0.0}).dependent);
  // Equal increments of crank and rocker: one body.
  const std::vector<PrecisionPoint> together{{0.3, {0.5}}, {0.6, {0.8}}, {1.0, {1.2}}};
  const auto rigid = four_bar_functions(together, {0.0, 0.0});
  ASSERT_EQ(rigid.solutions.size(), 1U);
  EXPECT_EQ(rigid.solutions[0].outcome, FourBarOutcome::rigid);
  // Equal projections: cos θ₁ = 0.5 cos θ₃ + 0.1.
  std::vector<PrecisionPoint> projections;
  for (const double psi : {0.4, 0.9, 1.7}) {
    projections.push_back({std::acos(0.5 * std::cos(psi) + 0.1), {psi}});
  }
  const auto yoke = four_bar_functions(projections, {0.0, 0.0});
  ASSERT_EQ(yoke.solutions.size(), 1U);
  EXPECT_EQ(yoke.solutions[0].outcome, FourBarOutcome::infinite_frame);
}

// A guide-bar's output: the line through the crank pin, at a distance from D.
TEST(FourBarFunction, FindsTheGuideBarInTheLimit) {
  const double frame = 2.5, offset = 0.3;
  std::vector<PrecisionPoint> points;
  for (const double phi : {0.4, 1.1, 1.9}) {
    // (B − D)·e₃ = offset.
    const double x = std::cos(phi) - frame, y = std::sin(phi), d = std::hypot(x, y);
    points.push_back({phi, {std::atan2(y, x) + std::acos(offset / d)}});
  }
  const auto found = four_bar_functions(points, {0.0, 0.0});
  ASSERT_EQ(found.solutions.size(), 1U);
  const FourBarFunction& bar = found.solutions[0];
  ASSERT_EQ(bar.outcome, FourBarOutcome::infinite_rocker);
  EXPECT_NEAR(bar.links.frame, frame, 1e-12);
  EXPECT_NEAR(bar.guide_offset, offset, 1e-12);
}

// Directions that come out reversed are turned and said to be.
TEST(FourBarFunction, ReportsWhichLinksAreTurned) {
  const PlantedFourBar planted{1.7, 1.9, 2.1, 1, 0.4, 0.9};
  Random random(1);
  const auto points = planted_points(planted, {1, 1, 1}, 0.4, random);
  for (const bool input : {false, true}) {
    for (const bool output : {false, true}) {
      const GivenStart start{planted.input_start + (input ? kPi : 0),
                             planted.output_start + (output ? kPi : 0)};
      const auto found = four_bar_functions(points, start);
      ASSERT_EQ(found.solutions.size(), 1U);
      EXPECT_EQ(found.solutions[0].input_turned, input);
      EXPECT_EQ(found.solutions[0].output_turned, output);
      EXPECT_LT(distance(found.solutions[0], planted), 1e-12);
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis::four_bar_function_test
