// The mechanisms of the library close all along their drives, and the published ones stand where
// their sources say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::analysis_library_test {
namespace {

const std::filesystem::path kLibrary = std::filesystem::path(kLibraryFolder) / "analysis";

AnalysisProblem read_or_fail(const std::filesystem::path& file) {
  auto problem = read_task<AnalysisProblem>(file);
  if (problem) return *std::move(problem);
  for (const Fault& fault : problem.error()) {
    ADD_FAILURE() << file << ":" << fault.line << ":" << fault.column << ": " << fault.message;
  }
  return {};
}

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> all;
  for (const auto& entry : std::filesystem::directory_iterator(kLibrary)) {
    all.push_back(entry.path());
  }
  return all;
}

TEST(AnalysisLibraryTest, EveryMechanismClosesAllAlongItsDrive) {
  for (const auto& file : files()) {
    const AnalysisProblem problem = read_or_fail(file);
    EXPECT_FALSE(problem.title.empty()) << file;
    MechanismMotion<0> motion(problem.mechanism.mechanism);
    const DriveSweep& drive = problem.drive;
    for (int i = 0; i <= drive.steps; ++i) {
      const double coordinate = drive.start + (drive.end - drive.start) * i / drive.steps;
      EXPECT_TRUE(motion.move_to(coordinate)) << file << " at " << coordinate;
    }
  }
}

TEST(AnalysisLibraryTest, HasEveryTypeOfMechanism) {
  std::set<MechanismType> types;
  std::set<std::size_t> dyads;
  for (const auto& file : files()) {
    const NamedMechanism mechanism = read_or_fail(file).mechanism;
    types.insert(mechanism.type());
    for (const auto& dyad : mechanism.mechanism.dyads) dyads.insert(dyad.index());
  }
  EXPECT_EQ(types.size(), names<MechanismType>().size());
  constexpr std::size_t kDrivingCylinder = 1;  // a group of its own
  constexpr std::size_t kRestOfGroup = 1;
  EXPECT_EQ(dyads.size(), names<DyadType>().size() + kDrivingCylinder + kRestOfGroup);
}

// Where bodies and points of a mechanism stand.
class Posed {
 public:
  explicit Posed(const std::string& name)
      : problem_(read_or_fail(kLibrary / (name + ".toml"))),
        motion_(problem_.mechanism.mechanism) {}

  void move_to(double degrees) { ASSERT_TRUE(motion_.move_to(degrees * kPi / 180)); }

  // Compared as directions: an angle is known but for whole turns.
  void expect_angle(const std::string& body, double angle) const {
    const auto& bodies = problem_.mechanism.bodies;
    const auto found = std::ranges::find(bodies, body);
    ASSERT_NE(found, bodies.end());
    const Vec2d direction = motion_.bodies()[found - bodies.begin()].direction;
    EXPECT_NEAR(std::remainder(std::atan2(direction.y, direction.x) - angle, kTurn), 0, 1e-12)
        << body;
  }

  Vec2d point(const std::string& name) const {
    const auto& points = problem_.mechanism.points;
    const auto found = std::ranges::find(points, name, &NamedPoint::name);
    EXPECT_NE(found, points.end());
    return found == points.end() ? Vec2d{} : motion_.point(found->at)[0];
  }

 private:
  AnalysisProblem problem_;
  MechanismMotion<0> motion_;
};

// Li and Xu 2011, recomputed with 30 digits from intersections of circles and lines: example 2-1
// (the printed program's positions agree), angles of coupler and rocker in radians.
TEST(AnalysisLibraryTest, CrankRockerOfLiAndXu) {
  Posed mechanism("four-bar-forces");
  mechanism.move_to(30);
  mechanism.expect_angle("coupler", 0.5234698973465661);
  mechanism.expect_angle("rocker", 1.5529382387165134);
  mechanism.move_to(200);
  mechanism.expect_angle("coupler", 0.39732730138390593);
  mechanism.expect_angle("rocker", 2.776160322038053);
}

// Example 2-2.
TEST(AnalysisLibraryTest, SliderCrankOfLiAndXu) {
  Posed mechanism("slider-crank-forces");
  mechanism.move_to(137);
  mechanism.expect_angle("coupler", -0.2293378769929345);
  EXPECT_NEAR(mechanism.point("C").x, 0.8760390762244415, 1e-14);
}

// Example 2-3; the distance of the crank's pin from the guide's pivot.
TEST(AnalysisLibraryTest, GuideBarOfLiAndXu) {
  Posed mechanism("guide-bar-forces");
  mechanism.move_to(290);
  mechanism.expect_angle("guide", 1.3550087490227558);
  const Vec2d pin = mechanism.point("B");
  EXPECT_NEAR(std::hypot(pin.x, pin.y), 0.6389412362426401, 1e-14);
}

// Example 2-4: the bar, the connecting rod, the ram.
TEST(AnalysisLibraryTest, ShaperOfLiAndXu) {
  Posed mechanism("shaper");
  mechanism.move_to(70);
  mechanism.expect_angle("bar", 1.4622899042602095);
  mechanism.expect_angle("rod", 3.285228515764365);
  EXPECT_NEAR(mechanism.point("E").x, -0.08347913680057634, 1e-14);
  mechanism.move_to(290);
  mechanism.expect_angle("bar", 1.3058002381915623);
  mechanism.expect_angle("rod", 3.1686367179435364);
  EXPECT_NEAR(mechanism.point("E").x, 0.007198146235855461, 1e-14);
}

// What the comments of the other files claim, by their closed forms.
TEST(AnalysisLibraryTest, ClaimsOfTheFiles) {
  Posed chebyshev("double-rocker");
  chebyshev.move_to(std::acos(0.6) * 180 / kPi);
  EXPECT_NEAR(chebyshev.point("P").x, 2, 1e-12);
  EXPECT_NEAR(chebyshev.point("P").y, 4, 1e-12);

  Posed trammel("elliptic-trammel");
  trammel.move_to(25);
  const Vec2d p = trammel.point("P");
  EXPECT_NEAR(p.x * p.x / (150 * 150) + p.y * p.y / (50 * 50), 1, 1e-12);

  Posed tangent("tangent-generator");
  tangent.move_to(60);
  EXPECT_NEAR(tangent.point("B").x, 100 * std::tan(kPi / 6), 1e-12);

  Posed oldham("oldham-coupling");
  oldham.move_to(40);
  const Vec2d centre = oldham.point("C");
  EXPECT_NEAR(std::hypot(centre.x - 2, centre.y), 2, 1e-12);
  oldham.expect_angle("driven", 130 * kPi / 180);
}

}  // namespace
}  // namespace cognate::problems::analysis_library_test
