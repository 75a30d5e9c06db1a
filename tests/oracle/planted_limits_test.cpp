/// Targets of planted four-bars with noise or with many limits, which the search has missed: a
/// design no worse than the planted one is found from every seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems::planted_limits_test {
namespace {

/// Noise of one percent of the size: neighbouring poses are out of order at the planted linkage.
constexpr const char* kNoisyMotion = R"(
kind = "motion-generation"
[target]
poses = [
  [0.6501976266569296, -2.003645361527351, -183.29526150637165],
  [0.6790927124312991, -1.8570404277796155, -179.11318637322375],
  [0.701809183298979, -1.62711348667186, -171.57583828824843],
  [0.6605696615053944, -1.4778635548829302, -169.23827378115547],
  [0.6312937825311844, -1.4515113911823208, -166.26230530492217],
  [0.6269210345091254, -1.4604529532872084, -167.50052077552476],
  [0.4814991554681324, -1.2442199378088035, -158.3551214171615],
  [0.3855584409644364, -1.1906657101872444, -153.96216646955753],
  [0.2070139989577232, -1.1085126446052493, -145.87203033040652],
  [0.20590121027585942, -1.1105841240758838, -146.15393145261334],
  [-0.1351421742379692, -1.0896393807634714, -131.16486458879976],
  [-0.17184571787059563, -1.100059833401722, -130.58947248049716]
]
angle_weight = 0.7688958607015409
[mechanism]
dyads = ["RR"]
)";
/// Sum of squares of the planted linkage at its own crank angles.
constexpr double kPlantedMotion = 3.46e-3;

/// Bounds of lengths, transmission angle and pivot region are active at the best design.
constexpr const char* kTimedPath = R"(
kind = "path-generation"
title = "t"
[target]
points = [
  [1.2608860965408288, 1.3837618235040121], [1.07726025891461, 1.5067480784593013],
  [0.97504505987496, 1.5432708299910332], [0.7802319605558543, 1.5535036564051425],
  [0.7584447466661757, 1.5506603236129053], [0.7437201066304607, 1.563221651198472],
  [0.7437195016750936, 1.5405324624465966], [0.6886470554813551, 1.5152016602388616]
]
timing = "prescribed"
crank_deg = [
  191.2683703470715, 228.86907963855916, 252.29648959460803, 291.50019490229374,
  295.93074567834515, 302.602856047479, 308.2071692801228, 319.31360120858784
]
crank_reference = "frame"
[bounds]
length = [0.29733528971416145, 1.7759393703438204]
[constraints]
class = "crank-rocker"
transmission_angle_deg = [40.0, 140.0]
link_ratio_max = 5.0
pivot_region = [
  [0.11897164831672022, 0.4972873412233942], [1.7279414889417863, 1.2402003658029852]
]
)";
/// Found within all limits by an independent search.
constexpr double kTimedBest = 1.35366e-3;

template <class OneProblem>
OneProblem parsed(const char* text) {
  const auto problem = parse_task(text);
  return std::get<OneProblem>(problem.value());
}

double number(const Result& result, const std::string& name) {
  const auto quantity = std::ranges::find(result.quantities, name, &Quantity::name);
  return quantity == result.quantities.end() ? std::nan("") : std::get<double>(quantity->value);
}

TEST(PlantedLimits, NoisyPosesKeepTheirOrderInsideTheSearch) {
  const auto problem = parsed<MotionProblem>(kNoisyMotion);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const Result result = solve(problem, {.seed = seed});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(all_satisfied(result.designs.front().constraints));
    EXPECT_LE(result.designs.front().error.sum_of_squares, kPlantedMotion);
  }
}

TEST(PlantedLimits, ATimedPathReachesTheMinimumWithinAllLimits) {
  const auto problem = parsed<PathProblem>(kTimedPath);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Result result = solve(problem, {.seed = seed});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(all_satisfied(result.designs.front().constraints));
    EXPECT_LE(result.designs.front().error.sum_of_squares, kTimedBest);
    EXPECT_GT(number(result, "chance_of_unseen_minimum"), 0);
  }
}

}  // namespace
}  // namespace cognate::problems::planted_limits_test
