/// The choice among designs by their layers, and the searches that are repeated for it. Two planted
/// four-bars.
#include "problems/linkage/design_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems::design_layers_test {
namespace {

Design design_of(const FourBar& linkage, double error) {
  Design design;
  design.mechanism = named(linkage);
  design.error.rms = error;
  return design;
}

Design flat(double error) {
  return design_of({{8.97526483, 12.2044486},
                    {6.18535761, 27.9593341},
                    8.39405744,
                    13.0177979,
                    12.2359197,
                    Assembly::crossed,
                    Vec2d{-1.52274429, -2.6095104}},
                   error);
}

Design high(double error) {
  return design_of({{11.4015499, 7.81558612},
                    {-4.53031684, 9.29058545},
                    9.23758604,
                    13.054751,
                    13.0731202,
                    Assembly::open,
                    Vec2d{0.147984321, -3.35388619}},
                   error);
}

PathProblem layered(std::optional<int> max) {
  PathProblem problem;
  problem.solve.designs = 1;
  problem.layers = DesignLayers{{.link_width = 4, .pin_diameter = 2, .clearance = 0.1}, max};
  return problem;
}

/// What searches find one after the other, the last again and again.
struct Searches {
  std::vector<std::vector<Design>> found;
  std::vector<std::uint64_t> seeds{};

  Result operator()(const PathProblem& /*problem*/, const Run& run) {
    const std::size_t round = std::min(seeds.size(), found.size() - 1);
    seeds.push_back(run.seed);
    Result result;
    result.designs = found[round];
    result.status = Status::solved;
    return result;
  }
};

Result solved(std::optional<int> max, Searches& searches) {
  return solve_in_layers(
      layered(max), {.threads = 1}, DesignSource::search,
      [&](const PathProblem& one, const Run& run) { return searches(one, run); });
}

TEST(DesignLayers, OfADesignAreStatedWithoutALimit) {
  Searches searches{{{high(0.1)}}};
  const Result result = solved({}, searches);
  EXPECT_EQ(searches.seeds.size(), 1u);
  ASSERT_TRUE(result.designs.at(0).layers);
  EXPECT_EQ(result.designs[0].layers->count, 3);
  EXPECT_TRUE(result.designs[0].constraints.empty());
}

TEST(DesignLayers, ABetterDesignThatNeedsMoreIsPassedOver) {
  Searches searches{{{high(0.1), flat(0.2)}}};
  const Result result = solved(2, searches);
  EXPECT_EQ(searches.seeds.size(), 1u);
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.designs.size(), 1u);
  EXPECT_EQ(result.designs[0].error.rms, 0.2);
  EXPECT_EQ(result.designs[0].layers->count, 2);
  EXPECT_EQ(result.notes.size(), 1u);
}

TEST(DesignLayers, ASearchIsRepeatedWithOtherStartsUntilOneFits) {
  Searches searches{{{high(0.1)}, {flat(0.2)}}};
  const Result result = solved(2, searches);
  ASSERT_EQ(searches.seeds.size(), 2u);
  EXPECT_NE(searches.seeds[0], searches.seeds[1]);
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.designs.size(), 1u);
  EXPECT_EQ(result.designs[0].layers->count, 2);
}

TEST(DesignLayers, WhereNoneFitsTheFewestAreReported) {
  Searches searches{{{high(0.1)}}};
  const Result result = solved(2, searches);
  EXPECT_EQ(searches.seeds.size(), 4u);
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_EQ(result.designs.at(0).constraints.size(), 1u);
  EXPECT_FALSE(result.designs[0].constraints[0].satisfied);
  EXPECT_EQ(std::get<double>(result.designs[0].constraints[0].value), 3);
}

TEST(DesignLayers, OfDesignsThatMeetNoOtherLimitTheSearchEnds) {
  Design missed = high(0.1);
  missed.constraints.push_back({"crank", 9.2, 8.0, false});
  Searches searches{{{missed}}};
  const Result result = solved(2, searches);
  EXPECT_EQ(searches.seeds.size(), 1u);
  EXPECT_EQ(result.designs.size(), 1u);
}

}  // namespace
}  // namespace cognate::problems::design_layers_test
