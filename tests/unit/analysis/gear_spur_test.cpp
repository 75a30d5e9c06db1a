/// Radii, thicknesses and what can't be made of spur gears, against their definitions.
#include <gtest/gtest.h>

#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear_spur_test {
namespace {

using gear::BasicRack;
using gear::SpurGear;
using gear::ToothFault;

TEST(SpurGear, Radii) {
  const SpurGear g{.teeth = 20, .module = 4, .profile_shift = 0.25, .tip_reduction = 0.1};
  EXPECT_DOUBLE_EQ(reference_radius(g), 40);
  EXPECT_DOUBLE_EQ(base_radius(g), 40 * std::cos(20 * kDegree));
  EXPECT_DOUBLE_EQ(tip_radius(g), 4 * (10 + 1 + 0.25 - 0.1));
  EXPECT_DOUBLE_EQ(root_radius(g), 4 * (10 - 1.25 + 0.25));
  EXPECT_NEAR(tip_radius(BasicRack{}), 0.38, 1e-4);  // as ISO 53 rounds it
}

// ISO 53: clearance, dedendum and tip radius of profiles A to D; D is a full round but for little.
TEST(SpurGear, RacksOfTheStandard) {
  struct Profile {
    double dedendum, radius;
  };
  const double alpha = 20 * kDegree;
  for (const auto& [dedendum, radius] :
       {Profile{1.25, 0.38}, Profile{1.25, 0.3}, Profile{1.25, 0.25}, Profile{1.4, 0.39}}) {
    const BasicRack rack{alpha, 1, dedendum - 1, radius};
    // ISO 53, 4.4: the greatest radius is that of a full round.
    const double greatest =
        (kPi / 4 - dedendum * std::tan(alpha)) / std::tan((kRightAngle - alpha) / 2);
    EXPECT_NEAR(gear::greatest_tip_radius(rack), greatest, 1e-15);
    EXPECT_EQ(gear::tip_radius(rack), radius);
    EXPECT_GE(gear::tip_half_width(rack), 0) << dedendum;
    EXPECT_NEAR(gear::flank_depth(rack), dedendum - radius * (1 - std::sin(alpha)), 1e-15);
    EXPECT_EQ(gear::tooth_fault({.teeth = 30, .rack = rack}), ToothFault::none);
  }
  EXPECT_EQ(gear::flank_depth(BasicRack{}), 1);
  EXPECT_NEAR(gear::greatest_tip_radius({alpha, 1, 0.4}), 0.3939, 5e-5);
  EXPECT_EQ(gear::tip_radius(BasicRack{alpha, 1, 0.4}), gear::greatest_tip_radius({alpha, 1, 0.4}));
  EXPECT_EQ(gear::tip_half_width({25 * kDegree, 1, 0.25}), 0);
}

TEST(SpurGear, UndercutBeginsWhereTheLeastShiftAndTheLeastTeethSay) {
  for (int teeth = 5; teeth < 30; ++teeth) {
    SpurGear g{.teeth = static_cast<double>(teeth)};
    const double least = least_profile_shift(g.rack, teeth);
    EXPECT_NEAR(least_teeth(g.rack, least), teeth, 1e-12 * teeth);
    g.profile_shift = least;
    EXPECT_FALSE(is_undercut(g)) << teeth;
    EXPECT_NEAR(form_radius(g), base_radius(g), 1e-7);
    g.profile_shift = least + 1e-12;
    EXPECT_FALSE(is_undercut(g)) << teeth;
    g.profile_shift = least + 1e-6;  // the radius grows with the square of the tangent, not seen
    EXPECT_NEAR(form_tangent(g) * std::sin(g.rack.pressure_angle), 1e-6, 1e-14);
    g.profile_shift = least - 1e-12;
    EXPECT_TRUE(is_undercut(g)) << teeth;
    EXPECT_NEAR(form_radius(g), base_radius(g), 1e-7);
    g.profile_shift = least - 1e-3;
    EXPECT_GE(form_radius(g), base_radius(g));
    EXPECT_LT(form_radius(g), base_radius(g) + 2e-3);
  }
  EXPECT_TRUE(gear::is_undercut({.teeth = 17}));
  EXPECT_FALSE(gear::is_undercut({.teeth = 18}));
}

/// Where trochoid and involute cross, with 40 digits, from the equations of both.
TEST(SpurGear, FormCircleOfUndercutGears) {
  struct Known {
    double teeth, shift, radius, tolerance;
  };
  for (const auto& [teeth, shift, radius, tolerance] :
       {Known{5, 0, 2.4489354413393343, 1e-15}, Known{9, 0, 4.2651927176641368, 1e-15},
        Known{12, 0, 5.6513535632741068, 1e-15}, Known{17, 0, 7.9873915890797525, 1e-14},
        Known{9, 0.47, 4.2286200538941178, 1e-14}, Known{30, -0.76, 14.095391463448289, 1e-14},
        // The curves touch nearly where undercut begins.
        Known{9, 0.4735, 4.2286167960631396, 1e-12}}) {
    const double computed = gear::form_radius({.teeth = teeth, .profile_shift = shift});
    EXPECT_NEAR(computed, radius, tolerance * radius) << teeth << " " << shift;
  }
}

TEST(SpurGear, FormCircleOfAnUndercutGearRisesAsTheShiftFalls) {
  double before = 0;
  for (double shift = 0.47; shift > -0.3; shift -= 0.005) {
    const SpurGear g{.teeth = 9, .profile_shift = shift};
    // Over the root circle, which moves with the shift.
    const double height = form_radius(g) - root_radius(g);
    EXPECT_GT(height, before) << shift;
    before = height;
  }
}

TEST(SpurGear, ThicknessIsThatOfTheOutline) {
  int tested = 0;
  for (const double shift : {-0.4, 0.0, 0.6}) {
    const SpurGear g{.teeth = 23, .module = 2, .profile_shift = shift, .coarsening = 0.1};
    EXPECT_NEAR(tooth_thickness(g, reference_radius(g)),
                kPi + 4 * shift * std::tan(20 * kDegree) - 0.1, 1e-13);
    for (const gear::OutlinePoint& point : tooth_half(g, 0.01)) {
      if (point.part != gear::OutlinePart::involute) continue;
      ++tested;
      const double radius = norm(point.at);
      EXPECT_NEAR(tooth_thickness(g, radius), 2 * radius * std::atan2(-point.at.x, point.at.y),
                  1e-12);
    }
  }
  EXPECT_GE(tested, 21);
}

TEST(SpurGear, FlanksMeetAtThePointedRadius) {
  for (const double teeth : {5.0, 12.0, 30.0, 400.0}) {
    for (const double shift : {-0.5, 0.0, 1.0}) {
      const SpurGear g{.teeth = teeth, .module = 3, .profile_shift = shift};
      const double pointed = pointed_radius(g);
      EXPECT_NEAR(tooth_thickness(g, pointed), 0, 1e-12 * pointed);
      EXPECT_GT(tooth_thickness(g, 0.999 * pointed), 0);
      EXPECT_LT(tooth_thickness(g, 1.001 * pointed), 0);
      EXPECT_EQ(flank_end_radius(g), std::min(pointed, tip_radius(g)));
    }
  }
  const SpurGear sharp{.teeth = 8, .profile_shift = 0.9};
  EXPECT_LT(pointed_radius(sharp), tip_radius(sharp));
  const auto outline = tooth_half(sharp, 1e-3);
  EXPECT_EQ(outline.back().part, gear::OutlinePart::involute);
  EXPECT_NEAR(outline.back().at.y, pointed_radius(sharp), 1e-12);
}

TEST(SpurGear, WaistIsTheNarrowestPlaceOfTheOutline) {
  for (const double teeth : {4.0, 6.0, 9.0, 14.0, 18.0, 40.0}) {
    const SpurGear g{.teeth = teeth};
    double narrowest = teeth;
    for (const gear::OutlinePoint& point : tooth_half(g, 1e-6)) {
      if (point.part == gear::OutlinePart::fillet) {
        narrowest = std::min(narrowest, -2 * point.at.x);
      }
    }
    EXPECT_NEAR(waist_thickness(g), narrowest, 1e-5) << teeth;
    EXPECT_LE(waist_thickness(g), narrowest + 1e-12) << teeth;
  }
}

TEST(SpurGear, WhatCannotBeMade) {
  EXPECT_EQ(gear::tooth_fault({.teeth = 20}), ToothFault::none);
  EXPECT_EQ(gear::tooth_fault({.teeth = 9}), ToothFault::none);  // undercut, but a gear
  EXPECT_EQ(gear::tooth_fault({.teeth = 2}), ToothFault::no_root);
  EXPECT_EQ(gear::tooth_fault({.teeth = 4, .profile_shift = -0.6, .rack = {20 * kDegree, 1, 0.1}}),
            ToothFault::cut_through);
  EXPECT_EQ(gear::tooth_fault({.teeth = 20, .rack = {25 * kDegree, 1, 0.25, 0.4}}),
            ToothFault::rack_overlaps);
  EXPECT_EQ(gear::tooth_fault({.teeth = 20, .rack = {35 * kDegree, 1, 0.25}}),
            ToothFault::rack_overlaps);  // flanks that meet
  EXPECT_EQ(gear::tooth_fault({.teeth = 20, .tip_reduction = 1.9}), ToothFault::no_flank);
  EXPECT_EQ(gear::tooth_fault({.teeth = 6, .profile_shift = 3}), ToothFault::no_flank);  // pointed
}

}  // namespace
}  // namespace cognate::gear_spur_test
