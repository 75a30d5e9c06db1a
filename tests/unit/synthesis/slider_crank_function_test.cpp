// Exact slider-crank function generators: planted ones come back, limits are named.
#include "synthesis/exact/function/slider_crank_function.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "tests/support/planted_generators.hpp"

namespace cognate::synthesis::slider_crank_function_test {
namespace {

using test::PlantedSliderCrank;
using test::Random;

constexpr double kEpsilon = 2.220446049250313e-16;

double distance(const SliderCrankFunction& found, const PlantedSliderCrank& planted) {
  const double size = std::max(planted.crank, planted.coupler);
  return std::max({std::abs(found.crank - planted.crank) / size,
                   std::abs(found.coupler - planted.coupler) / size,
                   std::abs(found.offset - planted.offset) / size,
                   std::abs(found.output_start - planted.output_start) / size,
                   std::abs(std::remainder(found.input_start - planted.input_start, kTurn))});
}

struct Planting {
  std::string name;
  std::vector<int> multiplicities;
  bool input = false, output = false;
};

class SliderCrankFunctionTest : public ::testing::TestWithParam<Planting> {};

TEST_P(SliderCrankFunctionTest, EveryPlantedMechanismIsRecovered) {
  const Planting& c = GetParam();
  Random random(19);
  int tried = 0, recovered = 0;
  double worst_residual = 0;
  while (tried < 3000) {
    const PlantedSliderCrank planted = test::random_slider_crank(random);
    const auto points = planted_points(planted, c.multiplicities, 0.4, random);
    if (points.empty()) continue;
    ++tried;
    GivenStart start;
    if (c.input) start.input = planted.input_start;
    if (c.output) start.output = planted.output_start;
    bool seen = false;
    double nearest = HUGE_VAL;
    for (const auto& solution : slider_crank_functions(points, start).solutions) {
      worst_residual = std::max(worst_residual, solution.residual);
      if (solution.outcome != SliderCrankOutcome::linkage) continue;
      const double off = distance(solution, planted);
      nearest = std::min(nearest, off / solution.condition);
      const double stretch = planted.coupler / planted.crank + planted.crank / planted.coupler;
      seen = seen || off <= 100 * kEpsilon * solution.condition * stretch * stretch;
    }
    recovered += seen;
    if (!seen) {
      ADD_FAILURE() << planted.crank << " " << planted.coupler << " " << planted.offset << " "
                    << planted.side << " " << planted.input_start << " " << planted.output_start
                    << " nearest/condition " << nearest;
    }
  }
  EXPECT_EQ(recovered, tried);
  EXPECT_LT(worst_residual, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Plantings, SliderCrankFunctionTest,
                         ::testing::Values(Planting{"Five", {1, 1, 1, 1, 1}},
                                           Planting{"FourWithInput", {1, 1, 1, 1}, true},
                                           Planting{"FourWithOutput", {1, 1, 1, 1}, false, true},
                                           Planting{"Three", {1, 1, 1}, true, true},
                                           Planting{"ThreeByOnePoint", {3}, true, true},
                                           Planting{"FourByTwoPoints", {2, 2}, true},
                                           Planting{"FourByOnePoint", {4}, false, true},
                                           Planting{"FiveByTwoPoints", {3, 2}},
                                           Planting{"FiveByThreePoints", {1, 2, 2}}),
                         [](const auto& info) { return info.param.name; });

class SliderCrankOffsetTest : public ::testing::TestWithParam<Planting> {};

// With the offset given every planted mechanism comes back, and whatever comes is found again by
// the equations in which the offset is an unknown, through its own start angle.
TEST_P(SliderCrankOffsetTest, EveryPlantedMechanismIsRecovered) {
  const Planting& c = GetParam();
  Random random(23);
  int tried = 0, recovered = 0, again = 0, linkages = 0;
  while (tried < 2000) {
    PlantedSliderCrank planted = test::random_slider_crank(random);
    // Equal links in line hardly move the slider over half of the turn.
    const double apart = std::abs(planted.crank - planted.coupler);
    if (tried % 4 == 0 && apart > 0.05 * planted.crank) planted.offset = 0;
    const auto points = planted_points(planted, c.multiplicities, 0.4, random);
    if (points.empty()) continue;
    ++tried;
    GivenStart start;
    if (c.input) start.input = planted.input_start;
    if (c.output) start.output = planted.output_start;
    bool seen = false;
    for (const auto& solution : slider_crank_functions(points, start, planted.offset).solutions) {
      EXPECT_LT(solution.residual, 1e-12);
      if (solution.outcome != SliderCrankOutcome::linkage) continue;
      EXPECT_EQ(solution.offset, planted.offset);
      const double stretch = planted.coupler / planted.crank + planted.crank / planted.coupler;
      seen = seen ||
             distance(solution, planted) <= 100 * kEpsilon * solution.condition * stretch * stretch;
      if (solution.condition > 1e4 || points.size() != 4) continue;
      ++linkages;
      const PlantedSliderCrank found{solution.crank,       solution.coupler,     solution.offset, 1,
                                     solution.input_start, solution.output_start};
      bool known = false;
      for (const auto& other :
           slider_crank_functions(points, {solution.input_start, std::nullopt}).solutions) {
        known = known || (other.outcome == SliderCrankOutcome::linkage &&
                          distance(other, found) <= 1e-11 * (other.condition + solution.condition));
      }
      again += known;
    }
    recovered += seen;
    if (!seen) {
      ADD_FAILURE() << planted.crank << " " << planted.coupler << " " << planted.offset << " "
                    << planted.input_start << " " << planted.output_start;
    }
  }
  EXPECT_EQ(recovered, tried);
  EXPECT_EQ(again, linkages);
  if (c.multiplicities.size() == 4) {
    EXPECT_GT(linkages, 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Plantings, SliderCrankOffsetTest,
                         ::testing::Values(Planting{"Four", {1, 1, 1, 1}},
                                           Planting{"ThreeWithInput", {1, 1, 1}, true},
                                           Planting{"ThreeWithOutput", {1, 1, 1}, false, true},
                                           Planting{"FourByTwoPoints", {2, 2}},
                                           Planting{"FourByOnePoint", {4}},
                                           Planting{"ThreeByTwoPoints", {2, 1}, true},
                                           Planting{"ThreeByOnePoint", {3}, false, true}),
                         [](const auto& info) { return info.param.name; });

TEST(SliderCrankOffset, NamesWhatIsNoSliderCrank) {
  std::vector<PrecisionPoint> harmonic;
  for (int i = 0; i < 4; ++i) harmonic.push_back({0.5 * i, {7 + 2 * std::cos(0.5 * i + 0.4)}});
  int yokes = 0;
  for (const auto& f : slider_crank_functions(harmonic, {}, 0.3).solutions) {
    if (f.outcome != SliderCrankOutcome::scotch_yoke) continue;
    EXPECT_NEAR(f.crank, 2, 1e-9);
    ++yokes;
  }
  EXPECT_EQ(yokes, 1);
  harmonic.pop_back();
  yokes = 0;
  for (const auto& f : slider_crank_functions(harmonic, {0.4, std::nullopt}, 0.3).solutions) {
    yokes += f.outcome == SliderCrankOutcome::scotch_yoke && std::abs(f.crank - 2) < 1e-9;
  }
  EXPECT_EQ(yokes, 1);
  const std::vector<PrecisionPoint> same{{0.3, {0.5}}, {0.3, {0.5}}, {1.0, {1.2}}, {1.5, {2}}};
  EXPECT_TRUE(slider_crank_functions(same, {}, 0.0).dependent);
  const std::vector<PrecisionPoint> few(same.begin(), same.begin() + 3);
  EXPECT_TRUE(slider_crank_functions(few, {0.1, std::nullopt}, 0.0).dependent);
  EXPECT_TRUE(slider_crank_functions(few, {std::nullopt, 0.1}, 0.0).dependent);
}

// The same problem in another unit, with displacements counted from elsewhere.
TEST(SliderCrankFunction, DependsOnNoUnitAndNoOrigin) {
  const PlantedSliderCrank planted{1, 3, 0.4, 1, 0.3, 2.5};
  Random random(2);
  const auto points = planted_points(planted, {1, 1, 1, 1, 1}, 0.5, random);
  for (const double unit : {1e-12, 1e-3, 1e6, 1e12}) {
    auto scaled = points;
    for (auto& point : scaled) point.output[0] *= unit;
    bool seen = false;
    for (const auto& f : slider_crank_functions(scaled, {}).solutions) {
      const PlantedSliderCrank same{unit, 3 * unit, 0.4 * unit, 1, 0.3, 2.5 * unit};
      seen = seen || distance(f, same) < 1e-10;
    }
    EXPECT_TRUE(seen) << unit;
  }
}

// A crank that turns the other way, and a slider that runs the other way, are other solutions of
// mirrored data.
TEST(SliderCrankFunction, TakesBothSenses) {
  const PlantedSliderCrank planted{1, 3, 0.4, 1, 0.3, 2.5};
  Random random(2);
  auto points = planted_points(planted, {1, 1, 1, 1}, 0.5, random);
  for (auto& point : points) point.output[0] *= -1;
  // s → −s is the mechanism turned by half a turn: θ + π, offset to the other side.
  bool seen = false;
  for (const auto& f : slider_crank_functions(points, {0.3 + kPi, std::nullopt}).solutions) {
    seen = seen || distance(f, {1, 3, -0.4, -1, 0.3 + kPi, -2.5}) < 1e-11;
  }
  EXPECT_TRUE(seen);
}

TEST(SliderCrankFunction, NamesWhatIsNoSliderCrank) {
  int tested = 0;
  const std::vector<PrecisionPoint> same{{0.3, {0.5}}, {0.3, {0.5}}, {1.0, {1.2}}};
  EXPECT_TRUE(slider_crank_functions(same, {0.0, 0.0}).dependent);
  // A harmonic displacement is a Scotch yoke's.
  std::vector<PrecisionPoint> harmonic;
  for (int i = 0; i < 5; ++i) harmonic.push_back({0.5 * i, {7 + 2 * std::cos(0.5 * i + 0.4)}});
  bool yoke = false;
  for (const auto& f : slider_crank_functions(harmonic, {}).solutions) {
    if (f.outcome != SliderCrankOutcome::scotch_yoke) continue;
    ++tested;
    yoke = true;
    EXPECT_NEAR(f.crank, 2, 1e-9);
  }
  EXPECT_TRUE(yoke);
  // A slider that stands still needs no crank.
  const std::vector<PrecisionPoint> still{{0.1, {2}}, {0.7, {2}}, {1.3, {2}}};
  const auto none = slider_crank_functions(still, {0.0, 0.0});
  EXPECT_TRUE(none.dependent || none.solutions[0].outcome != SliderCrankOutcome::linkage);
  EXPECT_GE(tested, 1);
}

}  // namespace
}  // namespace cognate::synthesis::slider_crank_function_test
