/// Pinions in rings and on racks: published numbers, and brute force on the outlines as they are
/// cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/gear/internal_pair.hpp"
#include "analysis/gear/rack_pair.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear_partners_test {
namespace {

using namespace cognate::gear;

InternalPair internal(double z1, double z2, double x1 = 0, double x2 = 0, double cutter = 20) {
  InternalPair pair;
  pair.pinion = {.teeth = z1, .profile_shift = x1};
  pair.ring = {{.teeth = z2, .profile_shift = x2}, cutter};
  pair.centre_distance = internal_centre_distance(pair.pinion, pair.ring, 0);
  return pair;
}

// KHK, Gear Technical Reference, "calculations of a profile shifted internal gear": m = 3, 16 and
// 24 teeth, x2 = 0.5.
TEST(GearPartners, ThePublishedInternalPair) {
  InternalPair pair = internal(16, 24, 0, 0.5, 16);
  pair.pinion.module = pair.ring.twin.module = 3;
  pair.centre_distance = internal_centre_distance(pair.pinion, pair.ring, 0);
  EXPECT_NEAR(pair.centre_distance, 13.1683, 5e-5);
  const auto all = geometry(pair);
  EXPECT_NEAR(all.mesh.working_pressure_angle * 180 / kPi, 31.0937, 1e-4);
  EXPECT_NEAR(2 * all.mesh.gears[0].working_radius, 52.673, 5e-4);
  EXPECT_NEAR(2 * all.mesh.gears[1].working_radius, 79.010, 5e-4);
  EXPECT_NEAR(2 * tip_radius(pair.ring), 69, 1e-12);
  EXPECT_NEAR(2 * base_radius(pair.ring.twin), 67.658, 5e-4);
}

/// The material of a ring or a rack as its outline has it: by how far a point of the pinion is
/// within, along the ring's circle or the rack's line, on the side of positive and of negative
/// angles of its space.
class RingMaterial {
 public:
  explicit RingMaterial(const RingGear& ring) : pitch_(2 * kPi / ring.twin.teeth) {
    for (const auto& point : ring_half(ring, 1e-5)) {
      radii_.push_back(norm(point.at));
      spaces_.push_back(0.5 * pitch_ - std::atan2(-point.at.x, point.at.y));
    }
    std::ranges::reverse(radii_);
    std::ranges::reverse(spaces_);
  }

  bool exists() const { return radii_.size() > 3; }

  /// Arc by which the point at `radius`, `angle` counter-clockwise of a tooth's middle, is beyond
  /// the flank that bounds its space in the sense of `side`; −∞ where there is none.
  double beyond(double radius, double angle, double side) const {
    if (radius <= radii_.front()) return -HUGE_VAL;
    if (radius >= radii_.back()) return radius - radii_.back();
    const auto i =
        static_cast<std::size_t>(std::ranges::upper_bound(radii_, radius) - radii_.begin());
    const double share = (radius - radii_[i - 1]) / std::max(1e-300, radii_[i] - radii_[i - 1]);
    const double half = spaces_[i - 1] + share * (spaces_[i] - spaces_[i - 1]);
    const double from_middle = std::remainder(angle - 0.5 * pitch_, pitch_);
    return radius * (side * from_middle - half);
  }

 private:
  double pitch_;
  std::vector<double> radii_, spaces_;  ///< half the angle of the space there
};

/// The deepest that any point of the pinion is in the ring's material on that side; its points at
/// `turn` counter-clockwise, the ring's tooth at `ring_turn`, the centres `distance` apart.
double deepest(const std::vector<OutlinePoint>& outline, const RingMaterial& ring, double turn,
               double ring_turn, double distance, double side) {
  double most = -HUGE_VAL;
  const Vec2d rotation{std::cos(turn), std::sin(turn)};
  for (const auto& point : outline) {
    const Vec2d at = rotation * point.at + Vec2d{0, distance};
    const double angle = std::atan2(-at.x, at.y) - ring_turn;
    most = std::max(most, ring.beyond(norm(at), angle, side));
  }
  return most;
}

// The ring's material is nowhere entered, and both flanks touch without backlash, at every angle:
// the outlines are conjugate.
TEST(GearPartners, AnInternalMeshIsConjugate) {
  for (const InternalPair& pair :
       {internal(18, 45, 0.3, 0.8), internal(18, 60, 0, 0.5), internal(25, 70, 0.5, 0.8, 30)}) {
    ASSERT_EQ(geometry(pair).mesh.gears[0].interference, 0);
    ASSERT_EQ(ring_fault(pair.ring), RingFault::none);
    const RingMaterial ring(pair.ring);
    const auto outline = gear_outline(pair.pinion, 1e-6);
    const double start = ring_angle(pair), ratio = pair.pinion.teeth / pair.ring.twin.teeth;
    for (int i = 0; i < 24; ++i) {
      const double turn = kTurn / pair.pinion.teeth * i / 24;
      for (const double side : {1.0, -1.0}) {
        const double depth =
            deepest(outline, ring, turn, start + ratio * turn, pair.centre_distance, side);
        EXPECT_NEAR(depth, 0, 2e-5) << i << ' ' << side;
      }
    }
  }
}

// With backlash the driving flank still touches, and the other is as far off as the backlash says.
TEST(GearPartners, BacklashOfAnInternalMeshIsWhereItIsSaidToBe) {
  InternalPair pair = internal(22, 65, 0.3, 0.8);
  const double wanted = 0.08;
  pair.centre_distance = internal_centre_distance(pair.pinion, pair.ring, wanted);
  const auto all = geometry(pair);
  EXPECT_NEAR(all.mesh.backlash, wanted, 1e-12);
  const RingMaterial ring(pair.ring);
  const auto outline = gear_outline(pair.pinion, 1e-6);
  const double start = ring_angle(pair), working = all.mesh.gears[1].working_radius;
  for (int i = 0; i < 12; ++i) {
    const double turn = kTurn / 22 * i / 12, ring_turn = start + turn * 22 / 65;
    EXPECT_NEAR(deepest(outline, ring, turn, ring_turn, pair.centre_distance, 1), 0, 2e-5);
    // Turned on by the backlash the ring touches on the other side.
    EXPECT_NEAR(
        deepest(outline, ring, turn, ring_turn + wanted / working, pair.centre_distance, -1), 0,
        2e-4);
  }
}

// The mean number of teeth that touch, counted one by one on the outlines.
TEST(GearPartners, TheContactRatioIsTheMeanNumberOfTeethThatTouch) {
  for (const InternalPair& pair : {internal(18, 60, 0, 0.5), internal(30, 75, 0.3, 0.8)}) {
    const RingMaterial ring(pair.ring);
    const auto outline = gear_outline(pair.pinion, 1e-7);
    const auto teeth = static_cast<std::size_t>(pair.pinion.teeth);
    const std::size_t each = outline.size() / teeth;
    const double start = ring_angle(pair), ratio = pair.pinion.teeth / pair.ring.twin.teeth;
    int touching = 0;
    constexpr int kSteps = 60;
    for (int i = 0; i < kSteps; ++i) {
      const double turn = kTurn / pair.pinion.teeth * i / kSteps;
      for (std::size_t k = 0; k < teeth; ++k) {
        const std::vector<OutlinePoint> tooth(outline.begin() + std::ptrdiff_t(k * each),
                                              outline.begin() + std::ptrdiff_t((k + 1) * each));
        const double depth =
            deepest(tooth, ring, turn, start + ratio * turn, pair.centre_distance, 1);
        if (depth > -3e-5) ++touching;
      }
    }
    EXPECT_NEAR(geometry(pair).mesh.contact_ratio, double(touching) / kSteps, 0.06);
  }
}

/// The deepest that the pinion is in the ring's material over a pitch, moved `closer` to the ring's
/// centre.
double deepest_of_pitch(const InternalPair& pair, double closer) {
  const RingMaterial ring(pair.ring);
  const auto outline = gear_outline(pair.pinion, 1e-3);
  const double start = ring_angle(pair), ratio = pair.pinion.teeth / pair.ring.twin.teeth;
  constexpr int kTurns = 8;
  double most = -HUGE_VAL;
  for (int k = 0; k < kTurns; ++k) {
    const double turn = kTurn / pair.pinion.teeth * k / kTurns;
    for (const double side : {1.0, -1.0}) {
      most = std::max(most, deepest(outline, ring, turn, start + ratio * turn,
                                    pair.centre_distance - closer, side));
    }
  }
  return most;
}

// Where the ring's tips pass the pinion's form circle they dig into its fillet, and else nowhere.
TEST(GearPartners, TipsInterfereWhereTheOutlinesDo) {
  int digging = 0, clear = 0;
  for (const double x1 : {0.0, 0.2, 0.4}) {
    for (const double x2 : {0.0, 0.2, 0.5, 0.8}) {
      const InternalPair pair = internal(22, 62, x1, x2);
      const auto all = geometry(pair);
      const double passed = all.mesh.gears[0].interference;
      if (passed > 0 && passed < 0.15) continue;
      const bool digs = deepest_of_pitch(pair, 0) > 4e-4;
      EXPECT_EQ(digs, passed > 0) << x1 << ' ' << x2 << ' ' << passed;
      (digs ? digging : clear) += 1;
    }
  }
  EXPECT_GT(digging, 2);
  EXPECT_GT(clear, 2);
}

// Whether tips overlap beside the path, and whether the pinion goes in radially, by moving it.
TEST(GearPartners, TipsOverlapWhereTheOutlinesDo) {
  constexpr double kDug = 3e-3;  // beyond what chords leave
  int overlapping = 0, clear = 0, axial = 0, radial = 0;
  for (double z1 = 22; z1 <= 46; z1 += 6) {
    for (double more = 2; more <= 23; more += more < 8 ? 1 : 3) {
      const double shift = more < 8 ? 0.6 : 0.3;
      const InternalPair pair = internal(z1, z1 + more, shift, 0.8, std::floor(0.6 * z1));
      const auto all = geometry(pair);
      const auto& [pinion, wheel] = all.mesh.gears;
      const bool is_sound = ring_fault(pair.ring) == RingFault::none && pinion.interference == 0 &&
                            wheel.interference == 0 &&
                            std::min(pinion.tip_clearance, wheel.tip_clearance) > 0.02;
      if (!is_sound || std::abs(all.tip_room) < 0.05) continue;
      const bool overlaps = deepest_of_pitch(pair, 0) > kDug;
      EXPECT_EQ(overlaps, all.tip_room < 0) << z1 << ' ' << more << ' ' << all.tip_room;
      (overlaps ? overlapping : clear) += 1;
      if (overlaps || std::abs(all.radial_room) < 0.05) continue;
      double on_the_way = -HUGE_VAL;
      for (double closer = 0; closer < 2.6; closer += 0.2) {
        on_the_way = std::max(on_the_way, deepest_of_pitch(pair, closer));
      }
      const bool blocked = on_the_way > kDug;
      EXPECT_EQ(blocked, all.radial_room < 0) << z1 << ' ' << more << ' ' << all.radial_room;
      (blocked ? axial : radial) += 1;
    }
  }
  EXPECT_GT(overlapping, 2);
  EXPECT_GT(clear, 8);
  EXPECT_GT(axial, 2);
  EXPECT_GT(radial, 2);
}

// Sliding from the velocities of the two flanks along their common tangent at the ends of the path.
TEST(GearPartners, SlidingOfAnInternalMeshIsThatOfItsVelocities) {
  const InternalPair pair = internal(20, 60, 0.2, 0.3);
  const auto all = geometry(pair);
  const double angle = all.mesh.working_pressure_angle, ratio = 3;
  const Vec2d direction{-std::cos(angle), std::sin(angle)};
  const Vec2d foot = base_radius(pair.pinion) * Vec2d{std::sin(angle), std::cos(angle)};
  const Vec2d tangent{std::sin(angle), std::cos(angle)};
  for (const bool at_start : {true, false}) {
    const Vec2d at = foot + (at_start ? all.path_start : all.path_end) * direction;
    const auto along = [&](const Vec2d& arm, double omega) {
      return dot(omega * Vec2d{-arm.y, arm.x}, tangent);
    };
    // The parts of the velocities across the line of action, of points of either gear.
    const double own = along(at, 1), other = along(at + Vec2d{0, pair.centre_distance}, 1 / ratio);
    const auto& pinion = all.mesh.gears[0];
    const auto& wheel = all.mesh.gears[1];
    EXPECT_NEAR(at_start ? pinion.sliding_start : pinion.sliding_end, 1 - other / own, 1e-12);
    EXPECT_NEAR(at_start ? wheel.sliding_end : wheel.sliding_start, 1 - own / other, 1e-12);
  }
}

RackPair rack(double teeth, double shift = 0, double backlash = 0) {
  RackPair pair;
  pair.pinion = {.teeth = teeth, .profile_shift = shift};
  pair.distance = rack_distance(pair.pinion, backlash);
  return pair;
}

// A wheel of so many teeth that it is a rack to five digits.
TEST(GearPartners, ARackIsALargeWheel) {
  for (const double shift : {0.0, 0.4}) {
    const RackPair pair = rack(24, shift, 0.05);
    const auto mesh = geometry(pair);
    SpurPair wheel{{SpurGear{.teeth = 24, .profile_shift = shift}, SpurGear{.teeth = 4e6}}, 0};
    wheel.centre_distance = pair.distance + 2e6;
    const auto nearly = geometry_of_line(wheel);
    EXPECT_NEAR(mesh.contact_ratio, nearly.contact_ratio, 2e-5);
    EXPECT_NEAR(mesh.backlash, nearly.backlash, 1e-5);
    EXPECT_NEAR(mesh.approach, nearly.approach, 5e-5);
    EXPECT_NEAR(mesh.recess, nearly.recess, 5e-5);
    for (const std::size_t i : {0u, 1u}) {
      EXPECT_NEAR(mesh.gears[i].sliding_start, nearly.gears[i].sliding_start, 1e-3);
      EXPECT_NEAR(mesh.gears[i].sliding_end, nearly.gears[i].sliding_end, 1e-3);
      EXPECT_NEAR(mesh.gears[i].tip_clearance, nearly.gears[i].tip_clearance, 1e-6);
    }
  }
}

// ε = [z (tan α_a − tan α) + 4 h_a*/sin 2α]/(2π) of textbooks: 1.7645 of 20 teeth.
TEST(GearPartners, TheTextbooksContactRatioOfARack) {
  const double alpha = kPi / 9, tip = std::acos(20 * std::cos(alpha) / 22);
  const double expected =
      (20 * (std::tan(tip) - std::tan(alpha)) + 4 / std::sin(2 * alpha)) / (2 * kPi);
  EXPECT_NEAR(geometry(rack(20)).contact_ratio, expected, 1e-12);
  EXPECT_NEAR(expected, 1.7645, 5e-3);
}

// The pinion's outline as it is cut never enters the rack that slides by, and touches both flanks.
TEST(GearPartners, ARackIsConjugate) {
  for (const RackPair& pair : {rack(20), rack(13, 0.35), rack(40, -0.2)}) {
    const auto outline = gear_outline(pair.pinion, 1e-6);
    const auto tooth = rack_tooth(pair);
    for (int i = 0; i < 24; ++i) {
      const double turn = kTurn / pair.pinion.teeth * i / 24;
      const double moved = -turn * reference_radius(pair.pinion);
      const Vec2d rotation{std::cos(turn), std::sin(turn)};
      double left = -HUGE_VAL, right = -HUGE_VAL;
      for (const auto& point : outline) {
        const Vec2d at = rotation * point.at;
        const double height = at.y - pair.distance;
        if (height < tooth[2].y || std::abs(at.x) > 12) continue;
        // Of the rack's tooth at this height: its flanks are straight.
        const double share = (height - tooth[3].y) / (tooth[4].y - tooth[3].y);
        const double half = tooth[3].x + share * (tooth[4].x - tooth[3].x);
        const double beside = std::remainder(at.x - moved - 0.5 * kPi, kPi);
        // How far inside the tooth, from its nearer flank.
        (beside < 0 ? left : right) = std::max(beside < 0 ? left : right, half - std::abs(beside));
      }
      EXPECT_NEAR(left, 0, 2e-5) << i;
      EXPECT_NEAR(right, 0, 2e-5) << i;
    }
  }
}

TEST(GearPartners, RingsThatCannotBe) {
  EXPECT_EQ(ring_fault(internal(10, 20, 0, 0, 19).ring), RingFault::inside_base);
  EXPECT_EQ(ring_fault(internal(10, 60, 0, 0, 60).ring), RingFault::no_cutting);
  EXPECT_EQ(ring_fault({{.teeth = 60, .profile_shift = -3}, 50}), RingFault::no_cutting);
  EXPECT_EQ(ring_fault({{.teeth = 60}, 5}), RingFault::pointed_tool);
  EXPECT_TRUE(ring_half({{.teeth = 20}, 12}, 1e-3).empty());
}

// The fillet that the tool's corner leaves joins the involute and the root without a step.
TEST(GearPartners, TheOutlineOfARingHasNoStep) {
  for (const double cutter : {15.0, 20.0, 40.0}) {
    for (const double shift : {-0.1, 0.0, 0.6}) {
      const RingGear ring{{.teeth = 64, .profile_shift = shift}, cutter};
      ASSERT_EQ(ring_fault(ring), RingFault::none);
      const auto half = ring_half(ring, 1e-5);
      double before = HUGE_VAL;
      for (std::size_t i = 1; i < half.size(); ++i) {
        EXPECT_LT(norm(half[i].at - half[i - 1].at), 0.15) << i;
        EXPECT_LE(norm(half[i].at), before + 1e-9);
        before = norm(half[i].at);
      }
      EXPECT_NEAR(norm(half.front().at), root_radius(ring), 1e-9);
      EXPECT_NEAR(norm(half.back().at), tip_radius(ring), 1e-9);
    }
  }
}

}  // namespace
}  // namespace cognate::gear_partners_test
