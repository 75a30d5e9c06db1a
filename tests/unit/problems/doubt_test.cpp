/// What a search says of its own doubt, where the answer is known: a target that is met to rounding
/// has no better minimum.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "problems/kinds.hpp"
#include "problems/read.hpp"

namespace cognate::problems::doubt_test {
namespace {

Result solved(const std::string& text) {
  const auto task = parse_task(text);
  EXPECT_TRUE(task.has_value()) << (task ? "" : task.error().front().message);
  if (const auto* path = std::get_if<PathProblem>(&*task)) return solve(*path, {});
  if (const auto* function = std::get_if<FunctionProblem>(&*task)) return solve(*function, {});
  return solve(std::get<MotionProblem>(*task), {});
}

class Doubt : public ::testing::TestWithParam<const char*> {};

TEST_P(Doubt, IsSmallWhereTheTargetIsMet) {
  const Result result = solved(GetParam());
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_LT(result.designs.front().error.rms, 1e-9);
  const auto doubt =
      std::ranges::find(result.quantities, "chance_of_unseen_minimum", &Quantity::name);
  ASSERT_NE(doubt, result.quantities.end());
  EXPECT_LT(std::get<double>(doubt->value), 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Doubt,
    ::testing::Values("kind = \"path-generation\"\n[target]\n"
                      "points = [[20, 20], [20, 25], [20, 30], [20, 35], [20, 40], [20, 45]]\n"
                      "[bounds]\nlength = [5, 60]\ncoupler_point = [[-60, -60], [60, 60]]\n"
                      "pivot_a = [[-60, -60], [60, 60]]\npivot_d = [[-60, -60], [60, 60]]\n",
                      "kind = \"function-generation\"\n[target]\n"
                      "pairs_deg = [[0, 0], [30, 20], [60, 45]]\nobjective = \"least-squares\"\n",
                      "kind = \"motion-generation\"\n[target]\nmethod = \"least-squares\"\n"
                      "poses = [[0, 0, 0], [2, 1, 20], [4, 1, 50], [5, 0, 70]]\n"));

}  // namespace
}  // namespace cognate::problems::doubt_test
