/// Gears drawn where they stand while they turn: they touch on the line of action, and nowhere
/// overlap.
#include <gtest/gtest.h>

#include "analysis/gear/mesh.hpp"
#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear_mesh_test {
namespace {

using gear::Mesh;
using gear::SpurGear;
using gear::SpurPair;

using Polygon = std::vector<Vec2d>;

std::vector<SpurPair> pairs() {
  const SpurGear pinion{.teeth = 18, .profile_shift = 0.3};
  const SpurGear wheel{.teeth = 31, .coarsening = 0.02};
  return {
      {{SpurGear{.teeth = 20, .module = 5}, SpurGear{.teeth = 40, .module = 5}}, 150},
      {{SpurGear{.teeth = 20, .module = 5}, SpurGear{.teeth = 40, .module = 5}}, 152},
      {{pinion, wheel}, gear::centre_distance_with_backlash({pinion, wheel}, 0.05)},
      {{wheel, pinion}, gear::centre_distance_without_backlash({wheel, pinion})},
      {{SpurGear{.teeth = 11, .profile_shift = 0.4}, SpurGear{.teeth = 12, .profile_shift = 0.4}},
       12.5}};
}

Polygon outline(const SpurGear& g, double tolerance) {
  Polygon corners;
  for (const auto& point : gear_outline(g, tolerance)) corners.push_back(point.at);
  return corners;
}

/// Turned and moved to the gear's place.
Polygon placed(const Polygon& polygon, const Vec2d& centre, double angle) {
  Polygon result;
  const Vec2d turn{std::cos(angle), std::sin(angle)};
  for (const Vec2d& corner : polygon) result.push_back(centre + turn * corner);
  return result;
}

Polygon part_near(const Polygon& polygon, const Vec2d& place, double reach) {
  Polygon result;
  for (const Vec2d& corner : polygon) {
    if (norm(corner - place) < reach) result.push_back(corner);
  }
  return result;
}

/// Signed distance from the polygon, counter-clockwise: negative within. Of its chords only those
/// near `point` count.
double distance(const Polygon& polygon, const Vec2d& point, double reach) {
  double nearest = reach;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d from = polygon[i];
    const Vec2d to = polygon[(i + 1) % polygon.size()];
    if ((from.y > point.y) != (to.y > point.y) &&
        point.x < from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y)) {
      inside = !inside;
    }
    if (squared_norm(from - point) > reach * reach) continue;
    const Vec2d chord = to - from;
    const double share = std::clamp(dot(point - from, chord) / squared_norm(chord), 0.0, 1.0);
    nearest = std::min(nearest, norm(point - from - share * chord));
  }
  return inside ? -nearest : nearest;
}

struct Stand {
  Polygon pinion;
  Polygon wheel;  ///< its teeth near the pitch point, closed at its centre
};

Stand stand(const SpurPair& pair, const Mesh& mesh, double angle, double tolerance) {
  const double ratio = pair.gears[0].teeth / pair.gears[1].teeth;
  const Polygon wheel = placed(outline(pair.gears[1], tolerance), mesh.wheel_centre,
                               mesh.wheel_angle - ratio * angle);
  Stand result{placed(outline(pair.gears[0], tolerance), {}, angle), {mesh.wheel_centre}};
  const double reach = 7 * kPi / pair.gears[1].teeth;
  // The first corner, next to the first tooth, is in the mesh: from the middle of the outline on.
  for (std::size_t i = 0; i < wheel.size(); ++i) {
    const Vec2d corner = wheel[(i + wheel.size() / 2) % wheel.size()];
    const Vec2d seen = corner - mesh.wheel_centre;
    if (std::abs(std::atan2(seen.x, -seen.y)) < reach) result.wheel.push_back(corner);
  }
  return result;
}

constexpr std::array kShares = {0.0, 0.35, 0.81};

TEST(GearMesh, TheOutlinesTouchAndDoNotOverlap) {
  for (const SpurPair& pair : pairs()) {
    const Mesh mesh = gear::mesh(pair);
    const double m = pair.gears[0].module;
    for (const double share : kShares) {
      const double angle = share * kTurn / pair.gears[0].teeth;
      const Stand at = stand(pair, mesh, angle, 5e-5 * m);
      double closest = m;
      for (const Vec2d& corner : part_near(at.pinion, mesh.pitch_point, 2.5 * m)) {
        const double d = distance(at.wheel, corner, 0.3 * m);
        closest = std::min(closest, d);
        EXPECT_GT(d, -1.2e-4 * m) << share;
      }
      EXPECT_LT(closest, 1e-3 * m);
    }
  }
}

TEST(GearMesh, ContactsLieOnBothFlanks) {
  for (const SpurPair& pair : pairs()) {
    const Mesh mesh = gear::mesh(pair);
    const double m = pair.gears[0].module;
    int contacts = 0;
    for (const double share : kShares) {
      const double angle = share * kTurn / pair.gears[0].teeth;
      const Stand at = stand(pair, mesh, angle, 5e-5 * m);
      const double moved = mesh.contact + angle * base_radius(pair.gears[0]);
      for (int k = -3; k <= 3; ++k) {
        const double along = moved + k * mesh.line.base_pitch;
        if (along < mesh.line.start || along > mesh.line.end) continue;
        const Vec2d point = mesh.base_points[0] + along * mesh.direction;
        EXPECT_NEAR(distance(at.pinion, point, m), 0, 1.2e-4 * m);
        EXPECT_NEAR(distance(at.wheel, point, m), 0, 1.2e-4 * m);
        ++contacts;
      }
    }
    EXPECT_GE(contacts, static_cast<int>(kShares.size()));
    EXPECT_GE(mesh.contact, mesh.line.start);
    EXPECT_LT(mesh.contact, mesh.line.start + mesh.line.base_pitch);
  }
}

/// The flank that does not drive is as far from its mate as the backlash along the line of action.
TEST(GearMesh, AllBacklashIsBehindTheTooth) {
  for (const SpurPair& pair : pairs()) {
    const Mesh mesh = gear::mesh(pair);
    const double m = pair.gears[0].module;
    const double backlash = geometry(pair).normal_backlash;
    // Turned on by what the backlash is, the pinion touches with its other flanks.
    const double back = -backlash / base_radius(pair.gears[0]);
    const Stand at = stand(pair, mesh, 0, 5e-5 * m);
    for (const double share : {0.0, 0.99}) {
      const Polygon pinion = placed(at.pinion, {}, share * back);
      double closest = m;
      for (const Vec2d& corner : part_near(pinion, mesh.pitch_point, 2.5 * m)) {
        closest = std::min(closest, distance(at.wheel, corner, 0.5 * m));
      }
      const double left = std::min(share, 1 - share) * backlash;
      EXPECT_NEAR(closest, left, 5e-4 * m);
      EXPECT_GT(closest, -1.2e-4 * m);
    }
  }
}

/// How deep corners of one gear lie in the other, at most, while a tooth goes through the mesh.
double greatest_overlap(const SpurPair& pair) {
  constexpr int kStands = 16;
  const Mesh mesh = gear::mesh(pair);
  const double m = pair.gears[0].module;
  double least = m;
  for (int i = 0; i < kStands; ++i) {
    const double angle = i * kTurn / pair.gears[0].teeth / kStands;
    const Stand at = stand(pair, mesh, angle, 5e-4 * m);
    for (const Vec2d& corner : part_near(at.pinion, mesh.pitch_point, 2.5 * m)) {
      least = std::min(least, distance(at.wheel, corner, 0.4 * m));
    }
  }
  return -least;
}

SpurPair pair_of(const SpurGear& pinion, const SpurGear& wheel) {
  return {{pinion, wheel}, gear::centre_distance_without_backlash({pinion, wheel})};
}

/// Whether tips dig into fillets is seen of the outlines. Neither undercut, where the flank has
/// made room, nor is a flank that is touched above the form circle alone a sign.
TEST(GearMesh, InterferenceIsOverlap) {
  const gear::BasicRack flat{16.9 * kPi / 180, 0.8227, 0.1358};
  const std::vector<std::pair<SpurPair, bool>> cases = {
      {pair_of({.teeth = 20}, {.teeth = 60}), false},
      {pair_of({.teeth = 20}, {.teeth = 60, .tip_reduction = -0.25}), true},
      {pair_of({.teeth = 20, .tip_reduction = -0.2}, {.teeth = 60}), false},
      {pair_of({.teeth = 12}, {.teeth = 60}), false},
      {pair_of({.teeth = 9}, {.teeth = 20}), false},
      {pair_of({.teeth = 12}, {.teeth = 60, .tip_reduction = -0.2}), true},
      {pair_of({.teeth = 36, .profile_shift = 0.789, .rack = flat},
               {.teeth = 43, .profile_shift = 0.485, .rack = flat}),
       true},
      {pair_of({.teeth = 36, .profile_shift = 0.2, .rack = flat},
               {.teeth = 43, .profile_shift = 0.2, .rack = flat}),
       false}};
  for (const auto& [pair, overlaps] : cases) {
    const auto result = geometry(pair);
    EXPECT_EQ(result.gears[0].interference > 0 || result.gears[1].interference > 0, overlaps);
    const SpurPair swapped{{pair.gears[1], pair.gears[0]}, pair.centre_distance};
    EXPECT_NEAR(geometry(swapped).gears[0].interference, result.gears[1].interference, 1e-12);
    EXPECT_NEAR(geometry(swapped).gears[1].interference, result.gears[0].interference, 1e-12);
    const double overlap = std::max(greatest_overlap(pair), greatest_overlap(swapped));
    if (overlaps) {
      EXPECT_GT(overlap, 5e-3) << pair.gears[0].teeth;
    } else {
      EXPECT_LT(overlap, 1.5e-3) << pair.gears[0].teeth;
    }
  }
}

TEST(GearMesh, TheLineOfActionTouchesBothBaseCircles) {
  for (const SpurPair& pair : pairs()) {
    const Mesh mesh = gear::mesh(pair);
    const auto& [first, second] = mesh.base_points;
    EXPECT_NEAR(norm(first), base_radius(pair.gears[0]), 1e-10);
    EXPECT_NEAR(norm(second - mesh.wheel_centre), base_radius(pair.gears[1]), 1e-10);
    EXPECT_NEAR(dot(first, mesh.direction), 0, 1e-10);
    EXPECT_NEAR(dot(second - mesh.wheel_centre, mesh.direction), 0, 1e-10);
    EXPECT_NEAR(norm(second - first - mesh.line.length * mesh.direction), 0, 1e-10);
    EXPECT_NEAR(mesh.pitch_point.x, 0, 1e-10);
    EXPECT_NEAR(norm(mesh.path_end), flank_end_radius(pair.gears[0]), 1e-10);
    EXPECT_NEAR(norm(mesh.path_start - mesh.wheel_centre), flank_end_radius(pair.gears[1]), 1e-10);
  }
}

}  // namespace
}  // namespace cognate::gear_mesh_test
