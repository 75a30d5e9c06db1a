/// Helical, bevel and worm gears against the geometry in space that their formulas come from.
#include <gtest/gtest.h>

#include <array>

#include "analysis/gear/involute.hpp"
#include "analysis/gear/other_gears.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear_kinds_test {
namespace {

using gear::BevelPair;
using gear::HelicalGear;
using gear::SpurGear;
using gear::WormPair;

using Vec3 = std::array<double, 3>;

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

HelicalGear helical(double teeth, double helix_deg) {
  return {.normal = {.teeth = teeth, .module = 4, .profile_shift = 0.2},
          .helix = helix_deg * kDegree,
          .face_width = 40};
}

TEST(HelicalGear, WithoutHelixIsTheSpurGear) {
  const HelicalGear g = helical(25, 0);
  EXPECT_EQ(tip_radius(transverse(g)), tip_radius(g.normal));
  EXPECT_EQ(base_radius(transverse(g)), base_radius(g.normal));
  EXPECT_EQ(virtual_teeth(g), 25);
  EXPECT_EQ(overlap_ratio(g), 0);
  EXPECT_EQ(base_helix(g), 0);
  EXPECT_TRUE(std::isinf(lead(g)));
}

TEST(HelicalGear, TransverseSectionOfTheRack) {
  for (const double helix : {-30.0, 12.0, 45.0}) {
    const HelicalGear g = helical(25, helix);
    const SpurGear section = transverse(g);
    // The rack's flank, a plane along its teeth at the pressure angle in their normal section.
    const double beta = g.helix;
    const double alpha = g.normal.rack.pressure_angle;
    const Vec3 along_teeth{std::sin(beta), 0, std::cos(beta)};
    const Vec3 up_the_flank{std::sin(alpha) * std::cos(beta), std::cos(alpha),
                            -std::sin(alpha) * std::sin(beta)};
    const Vec3 normal = cross(along_teeth, up_the_flank);
    const Vec3 in_section = cross(normal, {0, 0, 1});
    EXPECT_NEAR(std::abs(in_section[0] / in_section[1]), std::tan(section.rack.pressure_angle),
                1e-14);
    // Depths in length are the same in every section.
    EXPECT_NEAR(tip_radius(section) - reference_radius(section), 4 * 1.2, 1e-13);
    EXPECT_NEAR(tip_radius(section) - root_radius(section), 4 * 2.25, 1e-13);
    // The thickness is that of the normal section over the cosine.
    const double normal_thickness = 4 * (kRightAngle + 0.4 * std::tan(alpha));
    EXPECT_NEAR(tooth_thickness(section, reference_radius(section)),
                normal_thickness / std::cos(beta), 1e-13);
    HelicalGear coarsened = g;
    coarsened.normal.coarsening = 0.1;
    EXPECT_NEAR(tooth_thickness(transverse(coarsened), reference_radius(section)),
                (normal_thickness - 0.1) / std::cos(beta), 1e-13);
  }
}

// A corner of its own is in the transverse section one that is as deep, and has room there too.
TEST(HelicalGear, TransverseSectionOfTheRacksCorner) {
  for (const double radius : {0.0, 0.25, 0.39}) {
    HelicalGear g = helical(25, 30);
    g.normal.rack = {20 * kDegree, 1, 0.4, radius};
    const SpurGear section = transverse(g);
    const auto flank = [](const SpurGear& gear) {
      const double sine = std::sin(gear.rack.pressure_angle);
      return gear.module *
             (gear.rack.addendum + gear.rack.clearance - *gear.rack.corner_radius * (1 - sine));
    };
    EXPECT_NEAR(flank(section), flank(g.normal), 1e-13);
    EXPECT_GE(tip_half_width(section.rack), 0);
  }
}

TEST(HelicalGear, BaseHelixAndLead) {
  for (const double helix : {-30.0, 12.0, 45.0}) {
    const HelicalGear g = helical(25, helix);
    const SpurGear section = transverse(g);
    // One lead on every cylinder: tan β/r is the same.
    EXPECT_NEAR(std::tan(base_helix(g)),
                std::tan(g.helix) * base_radius(section) / reference_radius(section), 1e-14);
    EXPECT_NEAR(lead(g) * std::tan(std::abs(g.helix)), kTurn * reference_radius(section), 1e-11);
    // Normal and transverse base pitch.
    EXPECT_NEAR(section.module * std::cos(section.rack.pressure_angle) * std::cos(base_helix(g)),
                4 * std::cos(g.normal.rack.pressure_angle), 1e-13);
    // The teeth overlap by the share of the axial pitch that the face is wide.
    EXPECT_NEAR(overlap_ratio(g) * lead(g) / g.normal.teeth, g.face_width, 1e-12);
  }
}

/// The plane across the tooth cuts the reference cylinder in an ellipse; the virtual gear is that
/// of its circle of curvature, here by differences.
TEST(HelicalGear, VirtualTeethAreThoseOfTheEllipse) {
  for (const double helix : {10.0, 30.0}) {
    const HelicalGear g = helical(25, helix);
    const double minor = reference_radius(transverse(g));
    const double major = minor / std::cos(g.helix);
    const double t = 1e-3;  // from the end of the minor axis
    const double x = major * std::sin(t);
    const double sagitta = minor * 2 * std::pow(std::sin(t / 2), 2);
    const double curvature_radius = (x * x + sagitta * sagitta) / (2 * sagitta);
    EXPECT_NEAR(virtual_teeth(g), 2 * curvature_radius / g.normal.module, 1e-4);
  }
}

TEST(BevelGear, ConesRollOnEachOther) {
  for (const double shaft : {60.0, 90.0, 110.0}) {
    const BevelPair pair{
        .teeth = {17, 43}, .module = 3, .shaft_angle = shaft * kDegree, .face_width = 30};
    const auto pinion = bevel_gear(pair, 0);
    const auto wheel = bevel_gear(pair, 1);
    EXPECT_NEAR(pinion.cone_angle + wheel.cone_angle, pair.shaft_angle, 1e-15);
    EXPECT_NEAR(std::sin(pinion.cone_angle) / std::sin(wheel.cone_angle), 17.0 / 43, 1e-14);
    EXPECT_NEAR(pinion.cone_distance, wheel.cone_distance, 1e-11);
    EXPECT_NEAR(2 * pinion.cone_distance * std::sin(pinion.cone_angle), 3 * 17, 1e-12);
    // The reference circle shrinks along the cone to the middle of the face.
    const double middle = pinion.cone_distance - 15;
    EXPECT_NEAR(17 * pinion.mean_module, 2 * middle * std::sin(pinion.cone_angle), 1e-12);
  }
}

/// The tips and roots at the outer end lie on the back cone, at right angles to the pitch cone.
TEST(BevelGear, TipAndRootCones) {
  const BevelPair pair{.teeth = {20, 35}, .module = 4, .profile_shift = {0.3, -0.3}};
  for (int i = 0; i < 2; ++i) {
    const auto g = bevel_gear(pair, i);
    const double shift = i == 0 ? 0.3 : -0.3;
    const double sine = std::sin(g.cone_angle);
    const double cosine = std::cos(g.cone_angle);
    const auto at_back_cone =
        [&](double height) {  // radius and distance from the apex, along the axis
          return std::array{g.cone_distance * sine + height * cosine,
                            g.cone_distance * cosine - height * sine};
        };
    const auto tip = at_back_cone(4 * (1 + shift));
    const auto root = at_back_cone(-4 * (1.25 - shift));
    EXPECT_NEAR(g.outer_tip_diameter, 2 * tip[0], 1e-12);
    EXPECT_NEAR(g.outer_root_diameter, 2 * root[0], 1e-12);
    EXPECT_NEAR(std::tan(g.tip_angle), tip[0] / tip[1], 1e-13);
    EXPECT_NEAR(std::tan(g.root_angle), root[0] / root[1], 1e-13);
    // The back cone's side, from the pitch circle to its apex, is the virtual pitch radius.
    EXPECT_NEAR(reference_radius(g.virtual_gear), g.cone_distance * std::tan(g.cone_angle), 1e-11);
    EXPECT_EQ(g.virtual_gear.profile_shift, shift);
  }
}

TEST(BevelGear, VirtualPairTouchesAtTheBackCones) {
  const BevelPair pair{.teeth = {20, 35}, .module = 4, .profile_shift = {0.3, -0.3}};
  const auto virtual_gears = virtual_pair(pair);
  const double cones =
      bevel_gear(pair, 0).cone_distance *
      (std::tan(bevel_gear(pair, 0).cone_angle) + std::tan(bevel_gear(pair, 1).cone_angle));
  EXPECT_NEAR(virtual_gears.centre_distance, cones, 1e-10);
  EXPECT_EQ(geometry(virtual_gears).backlash, 0);
  // Mitre gears: each the mate of its like, of 45 degrees.
  const auto mitre = gear::bevel_gear({.teeth = {25, 25}, .module = 2}, 0);
  EXPECT_DOUBLE_EQ(mitre.cone_angle, 45 * kDegree);
  EXPECT_DOUBLE_EQ(mitre.virtual_gear.teeth, 25 * std::sqrt(2.0));
}

const WormPair kWorm{.starts = 2,
                     .wheel_teeth = 40,
                     .module = 5,
                     .diameter_quotient = 10,
                     .wheel_shift = -0.5,
                     .rack = {20 * kDegree, 1, 0.2}};

TEST(WormPair, Diameters) {
  const auto g = geometry(kWorm);
  EXPECT_DOUBLE_EQ(g.worm_reference_diameter, 50);
  EXPECT_DOUBLE_EQ(g.worm_tip_diameter, 60);
  EXPECT_DOUBLE_EQ(g.worm_root_diameter, 38);
  EXPECT_DOUBLE_EQ(g.wheel_reference_diameter, 200);
  EXPECT_DOUBLE_EQ(g.wheel_throat_diameter, 205);
  EXPECT_DOUBLE_EQ(g.wheel_root_diameter, 183);
  EXPECT_DOUBLE_EQ(g.centre_distance, 122.5);
  // From every tip to the mating root is the clearance.
  EXPECT_DOUBLE_EQ(g.centre_distance - 0.5 * (g.worm_tip_diameter + g.wheel_root_diameter), 1);
  EXPECT_DOUBLE_EQ(g.centre_distance - 0.5 * (g.wheel_throat_diameter + g.worm_root_diameter), 1);
}

TEST(WormPair, LeadAndSliding) {
  const auto g = geometry(kWorm);
  EXPECT_DOUBLE_EQ(g.lead, kTurn * 5);
  EXPECT_NEAR(std::tan(g.lead_angle), g.lead / (kPi * 50), 1e-15);
  // Rims at right angles: the worm's at 1, the wheel's at tan γ.
  EXPECT_NEAR(g.sliding_speed_ratio, std::hypot(1, std::tan(g.lead_angle)), 1e-15);
}

/// The forces of a block on the thread: what drives it against what it lifts.
TEST(WormPair, EfficiencyIsThatOfTheForcesOnTheThread) {
  for (const double friction : {0.0, 0.03, 0.08, 0.2}) {
    const auto g = geometry(kWorm);
    const double gamma = g.lead_angle;
    const double alpha = g.normal_pressure_angle;
    // A unit normal force: its part in the tangent plane's normal section is cos α, friction is
    // along the thread.
    const double axial = std::cos(alpha) * std::cos(gamma) - friction * std::sin(gamma);
    const double tangential = std::cos(alpha) * std::sin(gamma) + friction * std::cos(gamma);
    EXPECT_NEAR(efficiency(kWorm, friction), axial / tangential * std::tan(gamma), 1e-14);
    // Driven by the wheel friction points the other way; it holds where nothing turns the worm.
    const double turning = std::cos(alpha) * std::sin(gamma) - friction * std::cos(gamma);
    EXPECT_EQ(locks_itself(kWorm, friction), turning <= 0) << friction;
  }
  EXPECT_DOUBLE_EQ(efficiency(kWorm, 0), 1);
  EXPECT_EQ(gear::efficiency({.starts = 20, .wheel_teeth = 40, .diameter_quotient = 5}, 1), 0);
}

TEST(WormPair, AxialAndNormalSectionOfTheThread) {
  const auto g = geometry(kWorm);
  // As for a helical gear, whose helix is what the lead angle leaves of a right angle.
  EXPECT_NEAR(std::tan(g.normal_pressure_angle), std::tan(20 * kDegree) * std::cos(g.lead_angle),
              1e-15);
}

}  // namespace
}  // namespace cognate::gear_kinds_test
