/// Which designs count as one.
#include "problems/linkage/same_design.hpp"

#include <gtest/gtest.h>

#include "analysis/linkage/cognates.hpp"

namespace cognate::problems::same_design_test {
namespace {

FourBar linkage(double scale = 1) {
  return {{1 * scale, 2 * scale}, {3.5 * scale, 3 * scale},       1 * scale, 2.5 * scale, 2 * scale,
          Assembly::open,         Vec2d{0.3 * scale, 0.4 * scale}};
}

TEST(SameDesign, ComparesAtTheSizeOfTheLinkage) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    FourBar other = linkage(scale);
    other.crank *= 1 + 1e-7;
    EXPECT_TRUE(same_design(linkage(scale), other, 1e-6));
    EXPECT_FALSE(same_design(linkage(scale), other, 1e-9));
  }
}

TEST(SameDesign, SeesEveryDimension) {
  const auto differs = [](auto change) {
    FourBar other = linkage();
    change(other);
    return !same_design(linkage(), other, 1e-6) && !is_cognate(linkage(), other, 1e-6);
  };
  EXPECT_TRUE(differs([](FourBar& l) { l.pivot_a.y += 1e-4; }));
  EXPECT_TRUE(differs([](FourBar& l) { l.pivot_d.x += 1e-4; }));
  EXPECT_TRUE(differs([](FourBar& l) { l.crank += 1e-4; }));
  EXPECT_TRUE(differs([](FourBar& l) { l.coupler += 1e-4; }));
  EXPECT_TRUE(differs([](FourBar& l) { l.rocker += 1e-4; }));
  EXPECT_TRUE(differs([](FourBar& l) { l.coupler_point->x += 1e-4; }));
  EXPECT_TRUE(differs([](FourBar& l) { l.coupler_point.reset(); }));
  EXPECT_TRUE(differs([](FourBar& l) { l.assembly = Assembly::crossed; }));
}

TEST(IsCognate, KnowsTheSixLinkagesOfOneCurve) {
  const FourBar original = linkage();
  const FourBar timed = *timed_cognate(original);
  // Each where it stands when the original's crank is at 1 rad.
  const CognateAt coupler = *coupler_cognate(original, 1);
  const double timed_angle = 1 - frame_angle(original) + frame_angle(timed);
  const CognateAt all[] = {{original, 1}, {timed, timed_angle}, coupler};
  for (const CognateAt& one : all) {
    for (const CognateAt& other : all) {
      EXPECT_EQ(is_cognate(one.linkage, other.linkage, 1e-9), &one != &other);
      const auto turned = from_other_end(other.linkage, other.crank_angle);
      ASSERT_TRUE(turned);
      EXPECT_TRUE(is_cognate(one.linkage, turned->linkage, 1e-9));
    }
  }
  EXPECT_FALSE(same_design(original, timed, 1e-6));
  FourBar near = timed;
  near.coupler_point->y += 1e-4;
  EXPECT_FALSE(is_cognate(original, near, 1e-6));
}

}  // namespace
}  // namespace cognate::problems::same_design_test
