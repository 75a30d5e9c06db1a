/// Designs of the same links, and those whose links run to infinity.
#include "problems/linkage/twins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/long_links.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems::twins_test {
namespace {

Design design_with(const FourBar& linkage) {
  Design design;
  design.mechanism = named(linkage);
  return design;
}

FourBar traced() {
  return {.pivot_a = {0.2, -0.1},
          .pivot_d = {3.4, 0.7},
          .crank = 1,
          .coupler = 2.8,
          .rocker = 2.6,
          .assembly = Assembly::open,
          .coupler_point = Vec2d{1.1, 0.6}};
}

/// The image in the x axis.
FourBar mirrored(FourBar linkage) {
  for (Vec2d* place : {&linkage.pivot_a, &linkage.pivot_d, &*linkage.coupler_point}) {
    place->y = -place->y;
  }
  linkage.assembly = Assembly::crossed;
  return linkage;
}

Vec2d coupler_point_at(const FourBar& linkage, double crank) {
  MechanismMotion<0> motion(as_mechanism(linkage));
  EXPECT_TRUE(motion.move_to(crank));
  return point_motion(motion.bodies()[2], *linkage.coupler_point)[0];
}

TEST(Twins, KnowAMirrorImageByItsMotion) {
  const FourBar one = traced(), other = mirrored(one);
  for (const double crank : {0.3, 2.1, 5.5}) {
    const Vec2d p = coupler_point_at(one, crank), q = coupler_point_at(other, -crank);
    EXPECT_NEAR(p.x, q.x, 1e-14);
    EXPECT_NEAR(p.y, -q.y, 1e-14);
  }
  std::vector<Design> designs{design_with(one), design_with(other)};
  mark_twins(designs);
  EXPECT_EQ(designs[1].mirror_of, 0);
  EXPECT_FALSE(designs[1].twin_of);
  EXPECT_EQ(designs[1].differs, (std::vector<std::string>{"assembly", "direction", "pivots"}));
  EXPECT_TRUE(designs[0].differs.empty());
}

TEST(Twins, SayInWhatTheyDiffer) {
  FourBar assembled = traced(), moved = traced(), flipped = traced(), longer = traced();
  assembled.assembly = Assembly::crossed;
  moved.pivot_a = moved.pivot_a + Vec2d{1, 0};
  moved.pivot_d = moved.pivot_d + Vec2d{1, 0};
  flipped.coupler_point->y = -flipped.coupler_point->y;
  longer.rocker += 1e-3;
  std::vector<Design> designs;
  for (const FourBar& each : {traced(), assembled, moved, flipped, longer}) {
    designs.push_back(design_with(each));
  }
  mark_twins(designs);
  EXPECT_EQ(designs[1].differs, std::vector<std::string>{"assembly"});
  EXPECT_EQ(designs[2].differs, std::vector<std::string>{"pivots"});
  EXPECT_EQ(designs[3].differs, std::vector<std::string>{"coupler point"});
  for (int i = 1; i < 4; ++i) EXPECT_EQ(designs[static_cast<std::size_t>(i)].twin_of, 0);
  EXPECT_FALSE(designs[4].twin_of);
}

/// A crank, a coupler, and a rocker of some length whose end moves about a line.
FourBar with_rocker(double rocker, double offset = 0.4) {
  const Vec2d normal{0.6, 0.8};
  return {.pivot_a = {1, 2},
          .pivot_d = Vec2d{1, 2} + (rocker + offset) * normal,
          .crank = 1,
          .coupler = 2.5,
          .rocker = rocker,
          .assembly = Assembly::open,
          .coupler_point = Vec2d{1, 1}};
}

/// The limit moves as the four-bar does, the nearer the longer its links are.
TEST(LongLinks, TendToASliderCrank) {
  for (const double rocker : {1e3, 1e5}) {
    const FourBar linkage = with_rocker(rocker);
    const auto limit = slider_limit(linkage);
    ASSERT_TRUE(limit);
    EXPECT_FALSE(limit->slider_drives);
    const SliderCrank slider{.pivot = limit->pivot,
                             .crank = limit->crank,
                             .coupler = limit->coupler,
                             .offset = -limit->offset,
                             .direction = perp(limit->normal),
                             .assembly = linkage.assembly};
    MechanismMotion<0> motion(as_mechanism(slider));
    for (const double crank : {0.1, 1.7, 3.2, 5.0}) {
      ASSERT_TRUE(motion.move_to(crank));
      const Vec2d p = point_motion(motion.bodies()[2], *linkage.coupler_point)[0];
      EXPECT_LT(norm(p - coupler_point_at(linkage, crank)), 20 / rocker);
    }
  }
  EXPECT_FALSE(slider_limit(with_rocker(70)));
  EXPECT_FALSE(slider_limit(traced()));
}

TEST(LongLinks, LeaveOneDesignWithANote) {
  Result result;
  for (const FourBar& each :
       {with_rocker(400), traced(), with_rocker(1e4), with_rocker(400, 0.8), with_rocker(90)}) {
    result.designs.push_back(design_with(each));
  }
  result.designs[3].cognate_of = 1;
  merge_long_links(result);
  ASSERT_EQ(result.designs.size(), 3u);
  EXPECT_EQ(four_bar(result.designs[0]).rocker, 400);
  EXPECT_EQ(four_bar(result.designs[1]).rocker, traced().rocker);
  EXPECT_EQ(four_bar(result.designs[2]).pivot_d, with_rocker(400, 0.8).pivot_d);
  EXPECT_EQ(result.designs[2].cognate_of, 1);
  ASSERT_EQ(result.notes.size(), 2u);
  EXPECT_EQ(result.notes[0].find("Design 1: rocker and frame run to infinity together"), 0u);
  EXPECT_NE(result.notes[0].find("crank 1, coupler 2.5, its slide 0.4 away"), std::string::npos);
  // The slide's direction is at a right angle to that of the frame.
  const double along = std::atan2(0.6, -0.8) / kDegree;
  const auto at = result.notes[0].find("direction of ");
  EXPECT_NEAR(std::stod(result.notes[0].substr(at + 13)), along, 1e-3);
}

}  // namespace
}  // namespace cognate::problems::twins_test
