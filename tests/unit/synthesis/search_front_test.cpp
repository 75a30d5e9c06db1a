/// Fronts and explanations over a model, against what geometry says.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "synthesis/search/infeasibility.hpp"
#include "synthesis/search/pareto_front.hpp"
#include "tests/support/optimisation_problems.hpp"

namespace cognate::synthesis::testing::search_front_test {
namespace {

constexpr double kApart = 4;

/// Their sum of squares is |x|².
Values distance_from_origin(Point x) {
  return {x[0], x[1]};
}

double distance_to(const std::vector<double>& x, double to) {
  return std::hypot(x[0] - to, x[1]);
}

/// Least |x|² and least distance from (4, 0): the front is the line between, and the distances of
/// each of its points add up to 4.
TEST(ParetoFront, IsTheLineBetweenTwoPoints) {
  const ModelWithin within = [&](std::optional<double> bound) -> std::shared_ptr<const Model> {
    FunctionModel::Parts parts{boxes({{-10, 10}, {-10, 10}}), distance_from_origin};
    if (bound) {
      if (*bound <= 0) return nullptr;
      parts.constraints = [most = *bound](Point x) -> Values {
        return {1.0 - ((x[0] - kApart) * (x[0] - kApart) + x[1] * x[1]) / (most * most)};
      };
    }
    return std::make_shared<FunctionModel>(parts);
  };
  const FrontMeasure distance{.best = 0,
                              .level = [](double value) { return -value; },
                              .value_at = [](double level) { return -level; }};
  SearchOptions options{.rule = {.starts = 5}};
  constexpr int kPoints = 6;
  const auto front = pareto_front(
      within, distance, [&](const Minimum& one) { return distance_to(one.solution.x, kApart); },
      kPoints, 1e-18, options);
  ASSERT_EQ(front.size(), static_cast<std::size_t>(kPoints));
  for (const FrontMinimum& point : front) {
    EXPECT_NEAR(std::sqrt(point.minimum.solution.objective) + point.value, kApart, 1e-5);
    EXPECT_NEAR(point.minimum.solution.x[1], 0, 1e-5);
  }
  EXPECT_NEAR(front.front().value, kApart, 1e-5);
  EXPECT_LT(front.back().value, 1e-2);
  for (std::size_t i = 1; i < front.size(); ++i) EXPECT_LT(front[i].value, front[i - 1].value);
}

FunctionModel constrained(Function constraints) {
  return FunctionModel(
      {boxes({{-10, 10}, {-10, 10}}), distance_from_origin, std::move(constraints)});
}

const SearchOptions kFewStarts{.rule = {.starts = 8}};

/// x ≥ 2 and x ≤ 1: either may give way, by 1; y ≥ −5 is no help.
TEST(ModelInfeasibility, NamesEachConstraintThatAloneStandsInTheWay) {
  const FunctionModel model = constrained([](Point x) -> Values {
    return {x[0] - 2.0, 1.0 - x[0], x[1] + 5.0};
  });
  const Infeasibility found = explain_infeasibility(model, kFewStarts);
  ASSERT_EQ(found.finding, Infeasibility::Finding::any_of);
  ASSERT_EQ(found.ways.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found.ways[i].constraints, std::vector<std::size_t>{i});
    EXPECT_GE(slack_at(found.ways[i].share), 1 - 1e-6);
    EXPECT_LT(slack_at(found.ways[i].share), 1.05);
  }
}

/// Two such fights: one of each pair must give way, by 1 and by 3.
TEST(ModelInfeasibility, NamesTheFewestThatMustGiveWayTogether) {
  const FunctionModel model = constrained([](Point x) -> Values {
    return {x[0] - 2.0, 1.0 - x[0], x[1] - 2.0, -1.0 - x[1]};
  });
  const Infeasibility found = explain_infeasibility(model, kFewStarts);
  ASSERT_EQ(found.finding, Infeasibility::Finding::together);
  ASSERT_EQ(found.ways.size(), 1U);
  const auto& [constraints, share] = found.ways.front();
  ASSERT_EQ(constraints.size(), 2U);
  EXPECT_NE(constraints[0] / 2, constraints[1] / 2);
  EXPECT_GE(slack_at(share), 3 - 1e-6);
  EXPECT_LT(slack_at(share), 3.2);
}

TEST(ModelInfeasibility, SaysThatADesignMeetsAllOfThem) {
  const FunctionModel model = constrained([](Point x) -> Values { return {x[0] - 1.0}; });
  EXPECT_EQ(explain_infeasibility(model, kFewStarts).finding, Infeasibility::Finding::feasible);
}

/// What no constraint of the list is the reason for, equalities here, is not explained.
TEST(ModelInfeasibility, KnowsNothingWhereNothingHelps) {
  FunctionModel::Parts parts{boxes({{-10, 10}, {-10, 10}}), distance_from_origin,
                             [](Point x) -> Values {
                               return {x[0] - 1.0, x[0] - 2.0, x[1]};
                             }};
  parts.equality_count = 2;
  const Infeasibility found = explain_infeasibility(FunctionModel(parts), kFewStarts);
  EXPECT_EQ(found.finding, Infeasibility::Finding::unknown);
  EXPECT_TRUE(found.ways.empty());
}

TEST(ModelInfeasibility, GivesUpWhenTimeIsUp) {
  const FunctionModel model = constrained([](Point x) -> Values {
    return {x[0] - 2.0, 1.0 - x[0]};
  });
  SearchOptions options = kFewStarts;
  options.time_limit = 0;
  EXPECT_EQ(explain_infeasibility(model, options).finding, Infeasibility::Finding::unknown);
}

}  // namespace
}  // namespace cognate::synthesis::testing::search_front_test
