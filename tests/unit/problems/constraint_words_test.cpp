/// The names, relations and units of rows of constraints.
#include "problems/linkage/constraint_words.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "problems/linkage/cycle/cycle_quantities.hpp"

namespace cognate::problems::constraint_words_test {
namespace {

constexpr double kOpen = std::numeric_limits<double>::infinity();

void expect_words(const ConstraintCheck& check, std::string_view label, std::string_view relation,
                  std::string_view unit) {
  const ConstraintWords words = words_of(check);
  EXPECT_EQ(words.label, label) << check.name;
  EXPECT_EQ(words.relation, relation) << check.name;
  EXPECT_EQ(words.unit, unit) << check.name;
}

TEST(ConstraintWords, NameKeysOfEachKind) {
  expect_words({"bounds.crank", 2.0, Range{1, 3}}, "crank", "in", "length");
  expect_words({"bounds.crank", 2.0, Range{1, kOpen}}, "crank", ">=", "length");
  expect_words({"bounds.pivot_a.x", 2.0, Range{-kOpen, 3}}, "pivot A (x)", "<=", "length");
  expect_words({"mechanism.rocker", 2.0, 2.0}, "rocker", "=", "length");
  expect_words({"mechanism.assembly", std::string("open"), std::string("open")}, "assembly", "=",
               "");
  expect_words({"class", std::string("a"), std::string("b")}, "class", "=", "");
  expect_words({"transmission_angle_deg", 40.0, Range{30, 150}}, "transmission angle", "in", "deg");
  expect_words({"link_ratio_max", 4.0, 5.0}, "longest over shortest link", "<=", "");
  expect_words({"clearance[2]", 0.1, 0.0}, "clearance (2)", ">=", "length");
  expect_words({"pivot_region.pivot_d.y", 0.1, Range{0, 1}}, "pivot D (y)", "in", "length");
  expect_words({"dwell[1].half_band_deg_max", 0.1, 0.2}, "half band (1)", "<=", "deg");
  expect_words({"swing_deg_min", 61.0, 60.0}, "swing", ">=", "deg");
  expect_words({"second_cam.torque_max", 1.0, 2.0}, "torque of the cam (second cam)", "<=", "N m");
  expect_words({"no_undercut.outer_wall", 1.0, 0.0},
               "radius of curvature without undercut (outer wall)", ">=", "length");
  expect_words({"no_undercut.pinion", 0.1, 0.05}, "profile shift without undercut (pinion)",
               ">=", "");
  expect_words({"tip_clearance_min.wheel", 0.3, 0.25}, "tip clearance (wheel)", ">=", "module");
}

TEST(ConstraintWords, TakeTheSideThatACheckSays) {
  ConstraintCheck check{"bounds.profile_shift.pinion", 0.1, 0.5};
  check.relation = BoundSide::most;
  expect_words(check, "profile shift (pinion)", "<=", "");
  check.relation = BoundSide::least;
  expect_words(check, "profile shift (pinion)", ">=", "");
}

TEST(ConstraintWords, GivePeaksTheUnitOfTheirOutput) {
  const ConstraintCheck check{"peak_speed_max", 1.0, 2.0};
  EXPECT_EQ(words_of(check).unit, "length/s");
  EXPECT_EQ(words_of(check, true).unit, "rad/s");
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    EXPECT_TRUE(has_words(quantity.limit_key));
    expect_words({std::string(quantity.limit_key), 1.0, 2.0}, quantity.heading,
                 "<=", quantity.unit_of(false));
  }
}

}  // namespace
}  // namespace cognate::problems::constraint_words_test
