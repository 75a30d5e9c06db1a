#include "problems/basics/names.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace cognate::problems::names_test {
namespace {

template <class Enum>
class EnumNamesTest : public ::testing::Test {};

using Enums = ::testing::Types<Assembly, MobilityClass, RequiredClass, synthesis::Solver,
                               synthesis::Loss, Timing, CrankReference, CrankSense, PointOrder,
                               FunctionStart, FunctionObjective, Status, Defect, cam::FollowerType,
                               cam::ArmSide, cam::Closure, cam::MotionLaw, CamObjective>;
TYPED_TEST_SUITE(EnumNamesTest, Enums);

TYPED_TEST(EnumNamesTest, EveryNameLeadsBackToItsValue) {
  std::set<std::string_view> seen;
  int ordinal = 0;
  for (const auto& [name, value] : names<TypeParam>()) {
    EXPECT_EQ(static_cast<int>(value), ordinal++) << name;
    EXPECT_EQ(to_string(value), name);
    EXPECT_EQ(from_string<TypeParam>(name), value);
    EXPECT_TRUE(seen.insert(name).second) << name << " stands for two values";
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
              std::string_view::npos);
  }
  EXPECT_EQ(to_string(static_cast<TypeParam>(ordinal)), "") << "a value without a name";
}

TYPED_TEST(EnumNamesTest, WhatIsNoNameHasNoValue) {
  EXPECT_EQ(from_string<TypeParam>(""), std::nullopt);
  EXPECT_EQ(from_string<TypeParam>("crank_rocker"), std::nullopt);
}

// The contract with users, word for word.
TEST(NamesTest, SpellingsOfTheContract) {
  EXPECT_EQ(to_string(RequiredClass::crank_rocker), "crank-rocker");
  EXPECT_EQ(to_string(synthesis::Solver::automatic), "auto");
  EXPECT_EQ(to_string(FunctionStart::outer_dead_centre), "outer-dead-centre");
  EXPECT_EQ(to_string(FunctionObjective::least_squares), "least-squares");
  EXPECT_EQ(to_string(Status::no_solution), "no-solution");
}

}  // namespace
}  // namespace cognate::problems::names_test
