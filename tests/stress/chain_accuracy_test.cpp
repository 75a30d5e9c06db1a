/// The dyads keep the bounds that tests/stress states near their dead points.
#include "tests/stress/chain_accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cognate::stress {

static std::ostream& operator<<(std::ostream& out, const ChainFamily& family) {
  return out << family.name;
}

namespace {

class ChainAccuracyOf : public ::testing::TestWithParam<ChainFamily> {};

TEST_P(ChainAccuracyOf, KeepsItsBounds) {
  std::mt19937_64 random(3);
  ChainAccuracy worst;
  for (int decade = 2; decade <= 16; ++decade) {
    worst.include(GetParam().draw(std::pow(10.0, -decade), random));
    worst.include(GetParam().draw(std::pow(10.0, -decade), random));
  }
  EXPECT_GT(worst.positions.closed, 15);
  EXPECT_LE(worst.positions.well_conditioned, 10);
  EXPECT_LE(worst.positions.per_condition, 2);
  EXPECT_LE(worst.positions.wrong_flag_distance, 1);
  EXPECT_LE(worst.velocities.well_conditioned, 10);
  EXPECT_LE(worst.velocities.per_condition, 3);
}

INSTANTIATE_TEST_SUITE_P(Dyads, ChainAccuracyOf, ::testing::ValuesIn(chain_families()));

}  // namespace
}  // namespace cognate::stress
