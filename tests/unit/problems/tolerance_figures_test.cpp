/// Tolerances: published figures and 113-bit values, corners, samples, clearance, allocation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"
#include "problems/tolerance/draws.hpp"
#include "problems/tolerance/grades.hpp"
#include "synthesis/tolerance/allocation.hpp"
#include "tests/support/quad_four_bar.hpp"

namespace cognate::problems::tolerance_figures_test {
namespace {

using test::Quad;
using test::QuadDimensions;

constexpr double kDegree = 180 / kPi;

ToleranceResult tolerances_of(const std::string& mechanism, const std::string& tolerance,
                              double from, double to, int steps, int threads = 1) {
  const auto read = parse_task<AnalysisProblem>(
      "kind = \"analysis\"\n[mechanism]\n" + mechanism +
      "\n[drive]\nstart_deg = " + std::to_string(from) + "\nend_deg = " + std::to_string(to) +
      "\nsteps = " + std::to_string(steps) + "\n[tolerance]\n" + tolerance + "\n");
  if (!read) {
    ADD_FAILURE() << read.error().front().message;
    return {};
  }
  Run run;
  run.threads = threads;
  const auto result = analyse(*read, run);
  if (!result.tolerance) ADD_FAILURE() << "no tolerances";
  return result.tolerance.value_or(ToleranceResult{});
}

double sensitivity(const ToleranceFigures& figures, const std::string& dimension) {
  const auto found = std::ranges::find(figures.contributions, dimension, &Contribution::dimension);
  return found == figures.contributions.end() ? NAN : found->sensitivity;
}

const std::string kRocker =
    "type = \"four-bar\"\nfixed_pivots = [[0, 0], [110, 0]]\ncrank = 40\ncoupler = 120\n"
    "rocker = 80";
const QuadDimensions kRockerQuad{40, 120, 80, 110, 0, 0};
const char* const kNames[] = {"crank", "coupler", "rocker", "frame"};

// Figures of a published example, at crank 0°, each length ± 0.1.
TEST(ToleranceFigures, TheTextbooksRockerHasItsPrintedFigures) {
  const auto result =
      tolerances_of(kRocker, "length = 0.1\ndistribution = \"uniform\"", 0, 0.001, 1);
  const ToleranceFigures& rocker = result.quantities.front();
  const double printed[] = {-0.98108, -1.27768, 1.05808, 0.98108};
  // The contributions are those of the worst of two positions a thousandth of a degree apart.
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(sensitivity(rocker, kNames[i]), printed[i], 3e-5);
  const PositionFigures& at = rocker.positions.front();
  EXPECT_NEAR(at.linear, 0.42979, 6e-6);
  EXPECT_NEAR(at.low, -0.43176, 6e-6);
  EXPECT_NEAR(at.high, 0.42785, 6e-6);
  EXPECT_NEAR(at.rss, 0.21626, 6e-6);
}

TEST(ToleranceFigures, PartialsAndCornersAreThoseOf113Bits) {
  for (const int degrees : {0, 60, 178, 251}) {
    const auto result =
        tolerances_of(kRocker, "length = 0.1\nsamples = 0", degrees, degrees + 0.001, 1);
    const ToleranceFigures& rocker = result.quantities.front();
    const Quad angle = Quad(degrees) * boost::math::constants::pi<Quad>() / 180;
    for (int i = 0; i < 4; ++i) {
      const double exact =
          static_cast<double>(test::quad_rocker_rate(kRockerQuad, i, angle, 1)) * kDegree;
      const auto found =
          std::ranges::find(rocker.contributions, std::string(kNames[i]), &Contribution::dimension);
      // The contributions are those of the worst of two positions a thousandth of a degree apart.
      EXPECT_NEAR(found->sensitivity, exact, 2e-4) << degrees << ' ' << kNames[i];
    }
    const Quad nominal = test::quad_position(kRockerQuad, angle, 1).rocker;
    double low = 0, high = 0;
    test::each_corner(kRockerQuad, Quad("0.1"), 4, [&](const QuadDimensions& at) {
      const auto change =
          static_cast<double>(test::quad_position(at, angle, 1).rocker - nominal) * kDegree;
      low = std::min(low, change);
      high = std::max(high, change);
    });
    EXPECT_NEAR(rocker.positions.front().low, low, 1e-9);
    EXPECT_NEAR(rocker.positions.front().high, high, 1e-9);
  }
}

// Near a dead point first order is far off, and a note says so: ± 0.001 at crank 178°.
TEST(ToleranceFigures, NearADeadPointTheExactWorstCaseIsLopsided) {
  const auto result = tolerances_of(
      "type = \"four-bar\"\nfixed_pivots = [[0, 0], [3.99, 0]]\ncrank = 1\ncoupler = 3\nrocker = 2",
      "length = 0.001", 178, 178.001, 1);
  const ToleranceFigures& rocker = result.quantities.front();
  const PositionFigures& at = rocker.positions.front();
  EXPECT_NEAR(at.linear, 0.866, 6e-4);
  EXPECT_NEAR(at.low, -0.796, 6e-4);
  EXPECT_NEAR(at.high, 0.970, 6e-4);
  for (const auto& one : rocker.contributions) EXPECT_NEAR(std::abs(one.sensitivity), 217, 2);
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes.front().find("exact"), std::string::npos);
}

TEST(ToleranceFigures, ASliderCrankAndACouplerPointHaveTheirPrintedFigures) {
  const auto slider =
      tolerances_of("type = \"slider-crank\"\ncrank = 50\ncoupler = 150\noffset = 10",
                    "length = 0.05", 0, 0.001, 1);
  const PositionFigures& at = slider.quantities.front().positions.front();
  EXPECT_NEAR(std::max(at.high, -at.low), 0.10346, 6e-6);
  EXPECT_NEAR(at.rss, 0.07087, 6e-6);
  const auto point = tolerances_of(
      "type = \"four-bar\"\nfixed_pivots = [[0, 0], [3.2, 0]]\ncrank = 1\ncoupler = 3\n"
      "rocker = 2.5\ncoupler_point = [1.5, 1]",
      "length = 0.01\nof = \"P\"\nsamples = 0", 0, 0.001, 1);
  const ToleranceFigures& p = point.quantities[1];
  EXPECT_NEAR(p.positions[p.worst_exact].high, 0.0381, 6e-5);
  const QuadDimensions d{1, 3, Quad("2.5"), Quad("3.2"), Quad("1.5"), 1};
  const Quad angle =
      p.worst_exact == 0 ? Quad(0) : Quad("0.001") * boost::math::constants::pi<Quad>() / 180;
  const auto nominal = test::quad_position(d, angle, 1);
  double farthest = 0;
  test::each_corner(d, Quad("0.01"), 6, [&](const QuadDimensions& corner) {
    const auto moved = test::quad_position(corner, angle, 1);
    const Quad dx = moved.x - nominal.x, dy = moved.y - nominal.y;
    farthest = std::max(farthest, static_cast<double>(sqrt(Quad(dx * dx + dy * dy))));
  });
  EXPECT_NEAR(p.positions[p.worst_exact].high, farthest, 1e-9);
}

// 1 + 4 = 2 + 3: a published tutorial prints a sensitivity for this one.
TEST(ToleranceFigures, AChangePointIsRefusedWithTheShareThatAssembles) {
  const auto result = tolerances_of(
      "type = \"four-bar\"\nfixed_pivots = [[0, 0], [4, 0]]\ncrank = 1\ncoupler = 3\nrocker = 2",
      "length = 0.001\nsamples = 2000", 0, 360, 360);
  ASSERT_TRUE(result.refused);
  EXPECT_NE(result.refused->find("change point"), std::string::npos);
  EXPECT_TRUE(result.quantities.empty());
  EXPECT_EQ(result.samples, 2000u);
  EXPECT_LT(result.assembled, 1300u);
  EXPECT_GT(result.assembled, 800u);
}

TEST(ToleranceFigures, MayReachPastAnOffsetAndAddMoreThanTheLength) {
  EXPECT_FALSE(
      tolerances_of(kRocker, "length = { plus = 50, minus = 1 }\nsamples = 100", 0, 90, 3).refused);
  EXPECT_FALSE(tolerances_of("type = \"slider-crank\"\ncrank = 50\ncoupler = 150\noffset = 1",
                             "offset = 2\nsamples = 100", 0, 90, 3)
                   .refused);
}

// Mean and deviation of 200 000 samples against the integral over a Gauss grid of the box.
TEST(ToleranceFigures, SamplesAgreeWithTheirMomentsAndForAnyThreads) {
  const auto one = tolerances_of(kRocker,
                                 "length = 0.1\ndistribution = \"uniform\"\n"
                                 "samples = 200000",
                                 0, 0.001, 1, 1);
  const auto two = tolerances_of(kRocker,
                                 "length = 0.1\ndistribution = \"uniform\"\n"
                                 "samples = 200000",
                                 0, 0.001, 1, 2);
  const PositionFigures &at = one.quantities[0].positions[0],
                        &other = two.quantities[0].positions[0];
  EXPECT_EQ(at.mean, other.mean);
  EXPECT_EQ(at.sigma, other.sigma);
  EXPECT_EQ(one.quantities[0].quantiles[3].error, two.quantities[0].quantiles[3].error);
  // Gauss' points of three in each dimension: exact to the fifth power.
  const double node[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)},
               weight[] = {5.0 / 18, 4.0 / 9, 5.0 / 18};
  const Quad nominal = test::quad_position(kRockerQuad, 0, 1).rocker;
  double mean = 0, square = 0;
  for (int k = 0; k < 81; ++k) {
    QuadDimensions d = kRockerQuad;
    double w = 1;
    for (int i = 0, rest = k; i < 4; ++i, rest /= 3) {
      d[static_cast<std::size_t>(i)] += 0.1 * node[rest % 3];
      w *= weight[rest % 3];
    }
    const auto change =
        static_cast<double>(test::quad_position(d, 0, 1).rocker - nominal) * kDegree;
    mean += w * change;
    square += w * change * change;
  }
  const double sigma = std::sqrt(square - mean * mean);
  EXPECT_NEAR(at.mean, mean, 4 * sigma / std::sqrt(200000.0));
  EXPECT_NEAR(at.sigma, sigma, 4 * sigma / std::sqrt(2 * 200000.0));
  EXPECT_NEAR(sigma, one.quantities[0].positions[0].rss / std::sqrt(3.0), 1e-4);
}

// Garrett & Hall: a two-force link changes its length by the sum of its clearances.
TEST(ToleranceFigures, MasslessPinsLengthenTheirLink) {
  const auto result = tolerances_of(
      kRocker, "length = 0.1\nsamples = 0\nclearance = {B = 0.02, C = 0.03}", 60, 60.001, 1);
  const double by_coupler = std::abs(sensitivity(result.quantities.front(), "coupler"));
  ASSERT_EQ(result.clearances.size(), 2u);
  EXPECT_NEAR(result.clearances[0].massless, 0.02 * by_coupler, 1e-4 * by_coupler);
  EXPECT_NEAR(result.clearances[1].massless, 0.03 * by_coupler, 1e-4 * by_coupler);
}

// Nothing but a load on the output presses the pins: each gives way to it as far as it can.
TEST(ToleranceFigures, PinsGiveWayToALoadOnTheOutput) {
  for (const double sense : {1.0, -1.0}) {
    const std::string loaded =
        kRocker + "\n[[load]]\non = \"rocker\"\ntorque = " + std::to_string(6 * sense);
    const auto result = tolerances_of(
        loaded, "length = 0.1\nsamples = 0\nclearance = {A = 0.01, B = 0.02, C = 0.03}", 60, 60.001,
        1);
    ASSERT_EQ(result.clearances.size(), 3u);
    for (const ClearanceFigures& pin : result.clearances) {
      ASSERT_TRUE(pin.loaded) << pin.joint;
      EXPECT_NEAR(*pin.loaded, sense * pin.massless, 1e-9 * pin.massless) << pin.joint;
    }
  }
}

// The weight of a point on the coupler lowers it as far as the play of the crank's pin allows.
TEST(ToleranceFigures, AWeightOnTheCouplerSinksIntoThePlayOfThePin) {
  const double play = 1e-5;
  const Vec2d force{3, -7}, at{50, 30};
  for (const double degrees : {20.0, 60.0, 145.0, 230.0, 301.0}) {
    const Vec2d b = 40 * Vec2d{std::cos(degrees / kDegree), std::sin(degrees / kDegree)};
    // The rocker's angle in degrees and the loaded point, the coupler's hole `offset` from the pin.
    const auto placed = [&](const Vec2d& offset) {
      const Vec2d hole = b + offset, d{110, 0}, way = d - hole;
      const double square = squared_norm(way);
      const double along = (120.0 * 120 - 80.0 * 80 + square) / (2 * square);
      const Vec2d c = hole + along * way +
                      -std::sqrt(120.0 * 120 / square - along * along) * Vec2d{way.y, -way.x};
      const Vec2d u = (1 / 120.0) * (c - hole);
      return std::pair(std::atan2(c.y - d.y, c.x - d.x) * kDegree,
                       hole + at.x * u + at.y * Vec2d{-u.y, u.x});
    };
    double lowest = -1, change = 0;
    for (int k = 0; k < 3600; ++k) {
      const double turn = k / 10.0 / kDegree;
      const auto [angle, point] = placed(play * Vec2d{std::cos(turn), std::sin(turn)});
      const double work = dot(force, point - placed({}).second);
      if (work <= lowest) continue;
      lowest = work;
      change = angle - placed({}).first;
    }
    const std::string loaded =
        kRocker + "\ncoupler_point = [50, 30]\n[[load]]\non = \"P\"\nforce = [3, -7]";
    const auto result = tolerances_of(loaded, "length = 0.1\nsamples = 0\nclearance = {B = 1e-5}",
                                      degrees, degrees + 1e-6, 1);
    ASSERT_EQ(result.clearances.size(), 1u);
    ASSERT_TRUE(result.clearances[0].loaded);
    EXPECT_NEAR(*result.clearances[0].loaded, change, 2e-3 * result.clearances[0].massless)
        << degrees;
  }
}

TEST(ToleranceFigures, ATwoDyadChainHasThePartialsOf113Bits) {
  // The same four-bar, whose rocker drives a second one of the same size: C–E, E–F.
  const std::string chain =
      "type = \"chain\"\n"
      "pivot = [{name = \"A\", at = [0, 0]}, {name = \"D\", at = [110, 0]}, {name = \"G\", at = "
      "[260, 0]}]\n"
      "crank = {at = \"A\", pin = \"B\", length = 40}\n"
      "dyad = [{type = \"RRR\", joins = [\"B\", \"D\"], lengths = [120, 80], new = \"C\", "
      "names = [\"coupler\", \"rocker\"]}, {type = \"RRR\", joins = [\"C\", \"G\"], "
      "lengths = [150, 90], new = \"E\", names = [\"rod\", \"arm\"]}]";
  const auto result = tolerances_of(chain, "length = 0.1\nsamples = 0", 60, 60.001, 1);
  const ToleranceFigures& arm = result.quantities.front();
  const auto angle_of_arm = [](const std::array<Quad, 5>& d) {
    const Quad angle = Quad(60) * boost::math::constants::pi<Quad>() / 180;
    const auto first = test::quad_position({d[0], d[1], d[2], 110, 0, 0}, angle, 1);
    const Quad cx = 110 + d[2] * cos(first.rocker), cy = d[2] * sin(first.rocker);
    const Quad dx = 260 - cx, dy = -cy, square = dx * dx + dy * dy;
    const Quad along = (d[3] * d[3] - d[4] * d[4] + square) / (2 * square);
    const Quad across = sqrt(d[3] * d[3] / square - along * along);
    return Quad(
        atan2(Quad(cy + along * dy + across * dx), Quad(cx + along * dx - across * dy - 260)));
  };
  const std::array<Quad, 5> nominal{40, 120, 80, 150, 90};
  const char* const names[] = {"crank", "coupler", "rocker", "rod", "arm"};
  for (std::size_t i = 0; i < 5; ++i) {
    const Quad step("1e-11");
    auto low = nominal, high = nominal;
    low[i] -= step;
    high[i] += step;
    const auto exact =
        static_cast<double>(Quad((angle_of_arm(high) - angle_of_arm(low)) / (2 * step))) * kDegree;
    EXPECT_NEAR(sensitivity(arm, names[i]), exact, 2e-4 * std::abs(exact)) << names[i];
  }
}

// Worst case Σ aᵢtᵢ = L at least Σ kᵢ/tᵢ: tᵢ = L √(kᵢ/aᵢ)/Σ √(kⱼ aⱼ).
TEST(ToleranceAllocation, OneDemandIsMetInClosedForm) {
  const std::vector<double> costs{1, 4, 2}, factors{0.5, 2, 1};
  const auto best = synthesis::cheapest_tolerances(costs, {{factors, 0.3}}, 1);
  ASSERT_TRUE(best);
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::sqrt(costs[i] * factors[i]);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(best->tolerances[i], 0.3 * std::sqrt(costs[i] / factors[i]) / sum, 1e-12);
  }
  EXPECT_NEAR(best->cost, sum * sum / 0.3, 1e-10);
}

// Several demands: no random tolerances that meet them are cheaper, and duality bounds the cost.
TEST(ToleranceAllocation, NothingThatMeetsTheDemandsIsCheaper) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.05, 1);
  for (const int power : {1, 2}) {
    for (int trial = 0; trial < 30; ++trial) {
      std::vector<double> costs(4);
      for (double& cost : costs) cost = unit(random);
      std::vector<synthesis::ToleranceDemand> demands(3);
      for (auto& demand : demands) {
        demand.limit = unit(random);
        for (int i = 0; i < 4; ++i) demand.factors.push_back(unit(random));
      }
      const auto best = synthesis::cheapest_tolerances(costs, demands, power);
      ASSERT_TRUE(best);
      EXPECT_LE(best->bound, best->cost);
      EXPECT_NEAR(best->bound, best->cost, 1e-3 * best->cost);
      for (int other = 0; other < 2000; ++other) {
        std::vector<double> t(4);
        for (double& one : t) one = unit(random);
        double most = 0;
        for (const auto& demand : demands) {
          double spent = 0;
          for (int i = 0; i < 4; ++i) spent += demand.factors[i] * std::pow(t[i], power);
          most = std::max(most, spent / demand.limit);
        }
        double cost = 0;
        for (int i = 0; i < 4; ++i) cost += costs[i] / (t[i] * std::pow(most, -1.0 / power));
        EXPECT_GE(cost, best->cost * (1 - 1e-12));
      }
    }
  }
}

// ISO 286-1: IT6 = 10 i … with i = 0.45 ∛D + 0.001 D µm, D the geometric mean of a range's ends.
TEST(ToleranceGrades, TheTableFollowsTheStandardsFormula) {
  const double ends[] = {3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};
  const std::pair<ToleranceGrade, double> grades[] = {
      {ToleranceGrade::it6, 10},   {ToleranceGrade::it7, 16},   {ToleranceGrade::it8, 25},
      {ToleranceGrade::it9, 40},   {ToleranceGrade::it10, 64},  {ToleranceGrade::it11, 100},
      {ToleranceGrade::it12, 160}, {ToleranceGrade::it13, 250}, {ToleranceGrade::it14, 400}};
  for (std::size_t k = 0; k + 1 < std::size(ends); ++k) {
    const double mean = std::sqrt(ends[k] * ends[k + 1]);
    const double unit = 0.45 * std::cbrt(mean) + 0.001 * mean;
    for (const auto& [grade, factor] : grades) {
      const auto deviation = deviation_mm(grade, ends[k + 1]);
      ASSERT_TRUE(deviation);
      EXPECT_NEAR(2000 * *deviation, factor * unit, 0.11 * factor * unit) << k;
    }
  }
  EXPECT_EQ(deviation_mm(ToleranceGrade::medium, 30), 0.2);
  EXPECT_EQ(deviation_mm(ToleranceGrade::medium, 30.01), 0.3);
  EXPECT_FALSE(deviation_mm(ToleranceGrade::fine, 2500));
  EXPECT_FALSE(deviation_mm(ToleranceGrade::it8, 4000));
}

TEST(ToleranceDraws, NormalNumbersAreThoseOfTheErrorFunction) {
  for (const double p : {1e-15, 1e-6, 0.01, 0.074, 0.076, 0.3, 0.5, 0.9, 0.999, 1 - 1e-9}) {
    EXPECT_NEAR(0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2.0)), p, 1e-14 * (1 + 1 / p) * p);
  }
}

}  // namespace
}  // namespace cognate::problems::tolerance_figures_test
