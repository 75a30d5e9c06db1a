// Swings, circuits and classes of single four-bars; random ones are in stress/motion_ranges_test.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems::linkage_ranges_test {
namespace {

AnalysisResult over_a_turn(const FourBar& linkage) {
  AnalysisProblem problem;
  problem.mechanism = named(linkage);
  problem.drive.start = 0;
  problem.drive.end = kTurn;
  problem.drive.steps = 36;
  return analyse(problem, Run{.threads = 1});
}

template <class T>
std::optional<T> quantity(const AnalysisResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.quantities, name, &Quantity::name);
  if (found == result.quantities.end()) return std::nullopt;
  return std::get<T>(found->value);
}

FourBar linkage_of(const Lengths<double>& l) {
  return {{0, 0}, {l.frame, 0}, l.crank, l.coupler, l.rocker, Assembly::open, {}};
}

TEST(LinkageRanges, ADoubleRockerSwingsWithinItsOwnRange) {
  const auto result = over_a_turn(linkage_of({4.5, 1.5, 3, 5}));
  EXPECT_NEAR(*quantity<double>(result, "output_swing_deg"), 37.57, 0.005);
  EXPECT_NEAR(*quantity<double>(result, "circuit_swing_deg"), 60.27, 0.005);
}

TEST(LinkageRanges, AParallelogramIsADoubleCrank) {
  FourBar linkage = linkage_of({1, 4, 1, 4});
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    linkage.assembly = assembly;
    const auto result = over_a_turn(linkage);
    EXPECT_EQ(quantity<std::string>(result, "class"), "double-crank");
    EXPECT_EQ(quantity<std::string>(result, "change_point_kind"),
              assembly == Assembly::open ? "parallelogram" : "antiparallelogram");
    EXPECT_EQ(quantity<bool>(result, "rocker_turns_fully"), true);
  }
  EXPECT_EQ(quantity<std::string>(over_a_turn(linkage_of({2, 3, 3, 2})), "change_point_kind"),
            "kite");
  EXPECT_EQ(quantity<std::string>(over_a_turn(linkage_of({3, 3, 3, 3})), "change_point_kind"),
            "rhombus");
  EXPECT_EQ(quantity<std::string>(over_a_turn(linkage_of({1, 3, 5, 7})), "change_point_kind"),
            "single");
}

}  // namespace
}  // namespace cognate::problems::linkage_ranges_test
