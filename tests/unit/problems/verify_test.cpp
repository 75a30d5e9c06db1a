/// What is reported of a finished design, on designs whose every number is known.
#include "problems/linkage/verify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems::verify_test {
namespace {

constexpr double pi = kPi;
constexpr double degree = pi / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Grashof with the crank shortest: 1 + 3 < 2 + 2.5. Pivots off the origin, frame along 30°.
const FourBar kCrankRocker{
    {1, 2},         Vec2d{1, 2} + 3.0 * Vec2d{std::cos(pi / 6), 0.5}, 1, 2.5, 2, Assembly::open,
    Vec2d{0.3, 0.4}};
// Longest + shortest > the others; closes for |θ| ≤ 135.2° from A→D.
const FourBar kTripleRocker{{0, 0}, {2, 0}, 1, 1.3, 1.5, Assembly::crossed, {}};

Metrics metrics_of(const FourBar& linkage, std::vector<double> angles_deg,
                   const MotionKind& motion = {}) {
  for (double& angle : angles_deg) angle *= degree;
  return design_metrics(linkage, angles_deg, motion);
}

TEST(DesignMetrics, OfATurningCrankCoverTheFullTurn) {
  // The eighteen points of Kunjur & Krishnamurty: best design known, transmission range published
  // with it in the same recomputation (43.2565…154.6163°).
  const Vec2d a{0.2676555017766404, 0.15464956476517155};
  const double direction = 0.28482454670612944;
  const FourBar linkage{a,
                        a + 1.053943434877064 * Vec2d{std::cos(direction), std::sin(direction)},
                        0.42387499380145927,
                        0.9142498244271919,
                        0.5989168878083408,
                        Assembly::open,
                        Vec2d{0.3705973533271451, 0.39934665568008776}};
  std::vector<double> angles;
  for (int i = 0; i < 18; ++i) angles.push_back(direction + 0.8915558539500477 + i * pi / 9);
  const Metrics metrics = design_metrics(linkage, angles, {});
  EXPECT_EQ(metrics.mobility, MobilityClass::crank_rocker);
  EXPECT_FALSE(metrics.change_point);
  EXPECT_NEAR(metrics.transmission_min / degree, 43.256503861505955, 1e-9);
  EXPECT_NEAR(metrics.transmission_max / degree, 154.61625155763323, 1e-9);
  EXPECT_NEAR(metrics.transmission_acute_min / degree, 180 - 154.61625155763323, 1e-9);
  EXPECT_GT(metrics.time_ratio.value_or(0), 1);
  EXPECT_TRUE(metrics.defects.empty());

  const Vec2d points[] = {{0.5, 1.1},   {0.4, 1.1},  {0.3, 1.1}, {0.2, 1.0}, {0.1, 0.9},
                          {0.05, 0.75}, {0.02, 0.6}, {0, 0.5},   {0, 0.4},   {0.03, 0.3},
                          {0.1, 0.25},  {0.15, 0.2}, {0.2, 0.3}, {0.3, 0.4}, {0.4, 0.5},
                          {0.5, 0.7},   {0.6, 0.9},  {0.6, 1.0}};
  const TargetError error = path_error(linkage, points, angles);
  EXPECT_NEAR(error.sum_of_squares, 0.009028884630975686, 1e-14);
  EXPECT_NEAR(error.rms, 0.022396533252288655, 1e-14);
  EXPECT_GT(error.max, error.rms);
}

TEST(DesignMetrics, OfAnotherCrankCoverWhatItUses) {
  const Metrics metrics = metrics_of(kTripleRocker, {-20, 50, 100});
  double least = pi, greatest = 0;
  for (int i = 0; i <= 1200; ++i) {
    const auto pose = Motion(kTripleRocker).at((-20 + 0.1 * i) * degree);
    least = std::min(least, pose->transmission_angle);
    greatest = std::max(greatest, pose->transmission_angle);
  }
  EXPECT_NEAR(metrics.transmission_min, least, 1e-12);  // at 0°, which is a sample
  EXPECT_NEAR(metrics.transmission_max, greatest, 1e-12);
  EXPECT_TRUE(metrics.defects.empty());
  EXPECT_FALSE(metrics.time_ratio);
  // Where the positions do not lie in one range nothing less than the whole will do.
  const Metrics open = metrics_of(kTripleRocker, {-20, 180});
  EXPECT_EQ(open.transmission_max, pi);
  EXPECT_EQ(open.defects, std::vector{Defect::circuit});
}

TEST(DesignMetrics, NamesEachDefect) {
  EXPECT_EQ(metrics_of(kCrankRocker, {10, 90, 60, 200}).defects, std::vector{Defect::order});
  EXPECT_TRUE(metrics_of(kCrankRocker, {10, 90, 60, 200}, {PointOrder::any}).defects.empty());
  EXPECT_TRUE(metrics_of(kCrankRocker, {10, 90, 60, 200}, {.timed = true}).defects.empty());
  EXPECT_EQ(metrics_of(kTripleRocker, {120, 200}).defects, std::vector{Defect::circuit});
  const CrankPosition branches[] = {{0.1, Assembly::open}, {0.4, Assembly::crossed}};
  EXPECT_EQ(design_metrics(kTripleRocker, branches, {}).defects, std::vector{Defect::branch});
  EXPECT_EQ(design_metrics(kCrankRocker, branches, {}).defects,
            (std::vector{Defect::circuit, Defect::branch}));
}

TEST(PathError, IsInfiniteWhereThereIsNoPoint) {
  const Vec2d points[] = {{1, 1}};
  const double closed[] = {0.3}, open[] = {pi};
  FourBar linkage = kTripleRocker;
  EXPECT_EQ(path_error(linkage, points, closed).max, infinity);
  linkage.coupler_point = Vec2d{0.1, 0.2};
  EXPECT_LT(path_error(linkage, points, closed).max, 5);
  EXPECT_EQ(path_error(linkage, points, open).rms, infinity);
}

TEST(PathError, OfAPlantedMissIsThatMiss) {
  std::vector<Vec2d> points;
  const std::vector<double> angles{0.1, 0.9, 2.2, 4.0};
  for (const double angle : angles)
    points.push_back(*Motion(kCrankRocker).at(angle)->coupler_point);
  EXPECT_EQ(path_error(kCrankRocker, points, angles).max, 0);
  points[2] = points[2] + Vec2d{0.3, -0.4};
  const TargetError error = path_error(kCrankRocker, points, angles);
  EXPECT_NEAR(error.sum_of_squares, 0.25, 1e-15);
  EXPECT_NEAR(error.rms, 0.25, 1e-15);
  EXPECT_NEAR(error.max, 0.5, 1e-15);
}

/// The checks of the crank-rocker above at positions without defects.
std::vector<ConstraintCheck> check(const Constraints& constraints, const Bounds& bounds = {},
                                   const Given& given = {}, const FourBar& linkage = kCrankRocker) {
  return check_constraints(constraints, bounds, given, linkage, metrics_of(linkage, {0, 50, 100}));
}

const ConstraintCheck& named(const std::vector<ConstraintCheck>& checks, const std::string& name) {
  for (const auto& check : checks) {
    if (check.name == name) return check;
  }
  static const ConstraintCheck missing{"missing", infinity, infinity, false};
  ADD_FAILURE() << "no check named " << name;
  return missing;
}

constexpr Constraints kNothing{.required_class = {},
                               .transmission_angle = {},
                               .link_ratio_max = {},
                               .pivot_region = {},
                               .no_branch_defect = false,
                               .no_order_defect = false,
                               .no_circuit_defect = false};

TEST(CheckConstraints, OnlyWhatTheFileAsks) {
  EXPECT_TRUE(check(kNothing).empty());
  const auto defaults = check({});
  ASSERT_EQ(defaults.size(), 3u);
  for (const auto& defect : defaults) {
    EXPECT_EQ(std::get<std::string>(defect.value), "none");
    EXPECT_TRUE(defect.satisfied);
  }
  EXPECT_TRUE(all_satisfied(defaults));
  EXPECT_EQ(violation(defaults), 0);
}

TEST(CheckConstraints, DefectsFailByName) {
  Metrics metrics;
  metrics.defects = {Defect::circuit, Defect::order};
  const auto checks = check_constraints({}, {}, {}, kCrankRocker, metrics);
  EXPECT_TRUE(named(checks, "no_branch_defect").satisfied);
  EXPECT_FALSE(named(checks, "no_order_defect").satisfied);
  EXPECT_FALSE(named(checks, "no_circuit_defect").satisfied);
  EXPECT_EQ(std::get<std::string>(named(checks, "no_circuit_defect").value), "circuit");
  EXPECT_EQ(violation(checks), 1);
}

TEST(CheckConstraints, BoundsHoldTo1e9) {
  Bounds bounds;
  bounds.crank = Range{0.5, 1 - 1e-10};
  bounds.rocker = Range{0.5, 1.9};
  bounds.coupler = Range{0, 60};
  bounds.frame_angle = Range{380 * degree, 400 * degree};
  bounds.pivot_a = Box{{0, 2.5}, {1, 5}};
  bounds.coupler_point = Box{{-1, -1}, {1, 1}};
  const auto checks = check(kNothing, bounds);
  EXPECT_EQ(checks.size(), 8u);
  EXPECT_TRUE(named(checks, "bounds.crank").satisfied);
  EXPECT_FALSE(named(checks, "bounds.rocker").satisfied);
  EXPECT_EQ(std::get<double>(named(checks, "bounds.rocker").value), 2);
  EXPECT_TRUE(named(checks, "bounds.coupler").satisfied);
  EXPECT_TRUE(named(checks, "bounds.frame_angle_deg").satisfied);
  EXPECT_NEAR(std::get<double>(named(checks, "bounds.frame_angle_deg").value), 390, 1e-10);
  EXPECT_TRUE(named(checks, "bounds.pivot_a.x").satisfied);
  EXPECT_FALSE(named(checks, "bounds.pivot_a.y").satisfied);
  EXPECT_TRUE(named(checks, "bounds.coupler_point.u").satisfied);
  EXPECT_NEAR(violation(checks), 0.2, 1e-15);  // 2 instead of 2.5
  bounds.crank = Range{0.5, 1 - 1e-8};
  EXPECT_FALSE(named(check(kNothing, bounds), "bounds.crank").satisfied);
}

TEST(CheckConstraints, LengthsArePositive) {
  FourBar linkage = kCrankRocker;
  linkage.crank = 2.9e-6;  // the frame is 3
  ASSERT_EQ(check(kNothing, {}, {}, linkage).size(), 1u);
  EXPECT_FALSE(named(check(kNothing, {}, {}, linkage), "bounds.crank").satisfied);
  Bounds bounds;
  bounds.crank = Range{0, 5};
  EXPECT_FALSE(named(check(kNothing, bounds, {}, linkage), "bounds.crank").satisfied);
  EXPECT_GT(violation(check(kNothing, bounds, {}, linkage)), 0.01);
  bounds.crank = Range{1e-6, 5};  // the file may ask for less
  EXPECT_TRUE(named(check(kNothing, bounds, {}, linkage), "bounds.crank").satisfied);
  linkage.crank = 3.1e-6;
  EXPECT_TRUE(check(kNothing, {}, {}, linkage).empty());
}

TEST(CheckConstraints, FixedDimensionsAreKept) {
  Given given;
  given.coupler = 2.5;
  given.frame = 3.1;
  given.pivot_a = Vec2d{1, 2};
  given.frame_angle = 30 * degree - 2 * pi;
  given.assembly = Assembly::crossed;
  given.coupler_point = Vec2d{0.3, 0.5};
  const auto checks = check(kNothing, {}, given);
  EXPECT_TRUE(named(checks, "mechanism.coupler").satisfied);
  EXPECT_FALSE(named(checks, "mechanism.frame").satisfied);
  EXPECT_TRUE(named(checks, "mechanism.pivot_a.y").satisfied);
  EXPECT_TRUE(named(checks, "mechanism.frame_angle_deg").satisfied);
  EXPECT_FALSE(named(checks, "mechanism.assembly").satisfied);
  EXPECT_TRUE(named(checks, "mechanism.coupler_point.u").satisfied);
  EXPECT_FALSE(named(checks, "mechanism.coupler_point.v").satisfied);
}

bool has_class(const FourBar& linkage, RequiredClass required) {
  Constraints constraints = kNothing;
  constraints.required_class = required;
  return named(check(constraints, {}, {}, linkage), "class").satisfied;
}

TEST(CheckConstraints, ClassesAreThoseReported) {
  EXPECT_TRUE(has_class(kCrankRocker, RequiredClass::crank_rocker));
  EXPECT_TRUE(has_class(kCrankRocker, RequiredClass::grashof));
  EXPECT_FALSE(has_class(kCrankRocker, RequiredClass::double_crank));
  EXPECT_FALSE(has_class(kCrankRocker, RequiredClass::non_grashof));
  EXPECT_TRUE(has_class(kTripleRocker, RequiredClass::triple_rocker));
  EXPECT_FALSE(has_class(kTripleRocker, RequiredClass::crank_rocker));
  const FourBar change_point{{0, 0}, {0.7, 0}, 0.1, 0.3, 0.5, Assembly::open, {}};
  EXPECT_TRUE(has_class(change_point, RequiredClass::crank_rocker));
  EXPECT_FALSE(has_class(change_point, RequiredClass::non_grashof));
  const FourBar parallelogram{{0, 0}, {3, 0}, 1, 3, 1, Assembly::open, {}};
  EXPECT_FALSE(has_class(parallelogram, RequiredClass::crank_rocker));
  EXPECT_FALSE(has_class(parallelogram, RequiredClass::rocker_crank));
  EXPECT_TRUE(has_class(parallelogram, RequiredClass::double_crank));
}

TEST(CheckConstraints, TransmissionRatioAndRegionInTheFilesUnits) {
  // cos μ = (6.25 + 4 − d²)/10 with d = 2 and 4.
  const double least = std::acos(0.625) / degree, greatest = std::acos(-0.575) / degree;
  Constraints constraints = kNothing;
  constraints.transmission_angle = Range{30 * degree, 120 * degree};
  constraints.link_ratio_max = 3;
  constraints.pivot_region = Box{{0, 0}, {3.5, 5}};
  auto checks = check(constraints);
  EXPECT_EQ(checks.size(), 6u);
  const auto& transmission = named(checks, "transmission_angle_deg");
  EXPECT_FALSE(transmission.satisfied);
  EXPECT_NEAR(std::get<double>(transmission.value), greatest, 1e-12);
  EXPECT_NEAR(std::get<Range>(transmission.bound).max, 120, 1e-12);
  EXPECT_TRUE(named(checks, "link_ratio_max").satisfied);
  EXPECT_NEAR(std::get<double>(named(checks, "link_ratio_max").value), 3, 1e-14);
  EXPECT_TRUE(named(checks, "pivot_region.pivot_a.x").satisfied);
  EXPECT_FALSE(named(checks, "pivot_region.pivot_d.x").satisfied);
  constraints.transmission_angle = Range{(least - 1) * degree, pi};
  constraints.link_ratio_max = 2.99;
  checks = check(constraints);
  EXPECT_TRUE(named(checks, "transmission_angle_deg").satisfied);
  EXPECT_NEAR(std::get<double>(named(checks, "transmission_angle_deg").value), least, 1e-12);
  EXPECT_FALSE(named(checks, "link_ratio_max").satisfied);
}

// Radians and back: what the file says is what a check repeats, to the last digit.
TEST(CheckConstraints, AnglesAreRepeatedAsGiven) {
  for (int least = 1; least < 90; ++least) {
    Constraints constraints = kNothing;
    constraints.transmission_angle = Range{least * degree, (180 - least) * degree};
    const auto bound = std::get<Range>(named(check(constraints), "transmission_angle_deg").bound);
    EXPECT_EQ(bound.min, least);
    EXPECT_EQ(bound.max, 180 - least);
  }
}

}  // namespace
}  // namespace cognate::problems::verify_test
