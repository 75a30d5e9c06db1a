// What an analysis file says becomes a mechanism, its drive, masses, loads and output.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"

namespace cognate::problems::read_analysis_test {
namespace {

AnalysisProblem read(const std::string& text) {
  auto problem = parse_task<AnalysisProblem>("kind = \"analysis\"\n" + text);
  if (problem) return *std::move(problem);
  for (const Fault& fault : problem.error()) {
    ADD_FAILURE() << fault.line << ":" << fault.column << ": " << fault.message << "\n" << text;
  }
  return {};
}

constexpr const char* kFourBar = R"(
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [4, 1]]
crank = 1
coupler = 3
rocker = 2.5
coupler_point = [1, 0.5]
)";

Vec2d position(const AnalysisProblem& problem, const std::string& name, double coordinate) {
  MechanismMotion<0> motion(problem.mechanism.mechanism);
  EXPECT_TRUE(motion.move_to(coordinate));
  for (const NamedPoint& point : problem.mechanism.points) {
    if (point.name == name) return motion.point(point.at)[0];
  }
  ADD_FAILURE() << "no point " << name;
  return {};
}

void expect_near(Vec2d a, Vec2d b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

// Every point of `names` stands in both mechanisms at the same place, all along the drive.
void expect_same_motion(const AnalysisProblem& a, const AnalysisProblem& b,
                        const std::vector<std::string>& names, double from = 0, double to = 6.2) {
  for (int i = 0; i <= 40; ++i) {
    const double angle = from + (to - from) * i / 40;
    for (const std::string& name : names) {
      SCOPED_TRACE(name + " at " + std::to_string(angle));
      expect_near(position(a, name, angle), position(b, name, angle), 1e-9);
    }
  }
}

TEST(ReadAnalysisTest, DefaultsOfAFourBar) {
  const AnalysisProblem problem = read(kFourBar);
  EXPECT_EQ(problem.mechanism.type(), MechanismType::four_bar);
  ASSERT_TRUE(problem.mechanism.four_bar());
  EXPECT_EQ(problem.mechanism.four_bar()->pivot_d, (Vec2d{4, 1}));
  EXPECT_EQ(problem.mechanism.bodies,
            (std::vector<std::string>{"frame", "crank", "coupler", "rocker"}));
  EXPECT_EQ(problem.mechanism.points.size(), 5U);
  EXPECT_EQ(problem.mechanism.output, 3);
  EXPECT_EQ(problem.drive.start, 0);
  EXPECT_DOUBLE_EQ(problem.drive.end, kTurn);
  EXPECT_EQ(problem.drive.steps, 360);
  EXPECT_EQ(problem.drive.rate.speed, 1);
  EXPECT_EQ(problem.drive.rate.acceleration, 0);
  EXPECT_TRUE(problem.output.position && problem.output.velocity && problem.output.acceleration &&
              problem.output.transmission);
  EXPECT_FALSE(problem.output.reactions || problem.output.torque || problem.output.curvature);
  EXPECT_TRUE(problem.output.points.empty());
  EXPECT_EQ(problem.inertias.size(), 4U);
  EXPECT_EQ(problem.gravity, Vec2d{});
}

TEST(ReadAnalysisTest, DriveAndOutput) {
  const AnalysisProblem problem = read(std::string(kFourBar) + R"(
[drive]
speed = -10
acceleration = 2.5
start_deg = 30
steps = 12
[output]
want = ["transmission", "curvature", "P", "C", "P"]
)");
  EXPECT_EQ(problem.drive.rate.speed, -10);
  EXPECT_EQ(problem.drive.rate.acceleration, 2.5);
  EXPECT_DOUBLE_EQ(problem.drive.start, 30 * kDegree);
  EXPECT_DOUBLE_EQ(problem.drive.end, 390 * kDegree);
  EXPECT_EQ(problem.drive.steps, 12);
  EXPECT_TRUE(problem.output.transmission && problem.output.curvature);
  EXPECT_FALSE(problem.output.position || problem.output.velocity);
  EXPECT_EQ(problem.output.points, (std::vector<int>{4, 2}));
}

TEST(ReadAnalysisTest, InstantGeometryAndCognates) {
  const AnalysisProblem one =
      read(std::string(kFourBar) + "[output]\ninstant_geometry = \"coupler\"\ncognates = true\n");
  EXPECT_EQ(one.output.instant_geometry, (std::vector<int>{2}));
  EXPECT_TRUE(one.output.cognates && one.output.position);
  const AnalysisProblem several = read(
      std::string(kFourBar) + "[output]\ninstant_geometry = [\"rocker\", \"crank\", \"rocker\"]\n");
  EXPECT_EQ(several.output.instant_geometry, (std::vector<int>{3, 1}));
  EXPECT_FALSE(several.output.cognates);
}

TEST(ReadAnalysisTest, PointsAloneKeepTheUsualQuantities) {
  const AnalysisProblem listed = read("output.want = \"P\"\n" + std::string(kFourBar));
  EXPECT_TRUE(listed.output.position && listed.output.transmission);
  EXPECT_EQ(listed.output.points, (std::vector<int>{4}));
  const AnalysisProblem keyed =
      read(std::string(kFourBar) + "[output]\npoints = [\"B\"]\nvelocity = false\ntorque = true\n");
  EXPECT_TRUE(keyed.output.position && keyed.output.torque);
  EXPECT_FALSE(keyed.output.velocity);
  EXPECT_EQ(keyed.output.points, (std::vector<int>{1}));
}

// The frame of a link is that of the points in the order of their naming, for any axes of the
// body are: between C and B, u runs from C towards B and v to its left.
TEST(ReadAnalysisTest, LinksInTheAxesOfTheirBodies) {
  const AnalysisProblem problem = read(std::string(kFourBar) + R"(
[[link]]
between = ["C", "B"]
mass = 2
centre = [0.5, 0.25]
inertia = 0.1
[[link]]
between = ["C", "D"]
mass = 3
centre = [1, 0]
[[link]]
name = "crank"
inertia = 5
)");
  const Inertia& coupler = problem.inertias[2];
  EXPECT_EQ(coupler.mass, 2);
  EXPECT_EQ(coupler.moment, 0.1);
  expect_near(coupler.centre, {2.5, -0.25});
  expect_near(problem.inertias[3].centre, {1.5, 0});  // the rocker's origin is D
  EXPECT_EQ(problem.inertias[1].moment, 5);
  EXPECT_TRUE(problem.output.reactions && problem.output.torque);
}

TEST(ReadAnalysisTest, LoadsAtPointsBodiesAndBetween) {
  const AnalysisProblem problem = read("gravity = [0, -9.81]\n" + std::string(kFourBar) + R"(
[[load]]
on = "C"
force = [1, 2]
when = "return"
[[load]]
on = "rocker"
torque = -3
when = [350, 10]
[[load]]
on = ["C", "B"]
at = [1, 0.5]
force = [4, 5]
stroke = [0.05, 0.95]
)");
  EXPECT_EQ(problem.gravity, (Vec2d{0, -9.81}));
  ASSERT_EQ(problem.loads.size(), 3U);
  EXPECT_EQ(problem.loads[0].at.body, 3);  // of the two bodies at C that the drive moves through
  EXPECT_EQ(problem.loads[0].at.at, (Vec2d{2.5, 0}));
  EXPECT_EQ(problem.loads[0].force, (Vec2d{1, 2}));
  EXPECT_EQ(problem.loads[0].sense, LoadSense::retreat);
  EXPECT_EQ(problem.loads[1].torque, -3);
  ASSERT_TRUE(problem.loads[1].between);
  EXPECT_DOUBLE_EQ(problem.loads[1].between->first, 350 * kDegree);
  EXPECT_DOUBLE_EQ(problem.loads[1].between->second, 10 * kDegree);
  EXPECT_EQ(problem.loads[2].at.body, 2);
  expect_near(problem.loads[2].at.at, {2, -0.5});
  EXPECT_EQ(problem.loads[2].within_stroke, (std::pair(0.05, 0.95)));
  EXPECT_TRUE(problem.output.reactions && problem.output.torque);
}

TEST(ReadAnalysisTest, ASliderIsNamedByItsPin) {
  const AnalysisProblem problem = read(R"(
mechanism = {type = "slider-crank", crank = 1, coupler = 3, offset = 0.5, direction_deg = 90}
load = [{on = "C", force = [0, -7]}]
link = [{between = "C", mass = 4}]
)");
  EXPECT_EQ(problem.inertias[3].mass, 4);
  EXPECT_EQ(problem.loads[0].at.body, 3);
  EXPECT_EQ(problem.mechanism.mechanism.dyads.size(), 1U);
  // A quarter turn is exact: no slide line leans by a rounding.
  EXPECT_EQ(std::get<SliderCrank>(problem.mechanism.description).direction, (Vec2d{0, 1}));
}

TEST(ReadAnalysisTest, TablesMayStandWithinTheMechanism) {
  const std::string body = R"(
[mechanism]
type = "chain"
gravity = [0, -1]
[[mechanism.pivot]]
name = "A"
at = [0, 0]
[[mechanism.pivot]]
name = "D"
at = [4, 1]
[mechanism.crank]
at = "A"
pin = "B"
length = 1
[[mechanism.dyad]]
type = "RRR"
joins = ["B", "D"]
lengths = [3, 2.5]
new = "C"
[[mechanism.point]]
name = "P"
on = ["B", "C"]
at = [1, 0.5]
[[mechanism.link]]
name = "CD"
mass = 1
centre = [0, 0]
)";
  const AnalysisProblem chain = read(body);
  expect_same_motion(read(kFourBar), chain, {"A", "B", "C", "D", "P"});
  EXPECT_EQ(chain.mechanism.bodies, (std::vector<std::string>{"frame", "crank", "BC", "CD"}));
  EXPECT_EQ(chain.inertias[3].mass, 1);
  EXPECT_EQ(chain.gravity.y, -1);
}

constexpr const char* kCrankAtOrigin = R"(
mechanism.type = "chain"
crank = {at = "A", pin = "B", length = 1}
)";

TEST(ReadAnalysisTest, ChainOfAnRrpIsASliderCrank) {
  expect_same_motion(
      read("mechanism = {type = \"slider-crank\", crank = 1, coupler = 3, offset = 0.5,"
           " direction_deg = 30, assembly = \"crossed\"}\n"),
      read(std::string(kCrankAtOrigin) + R"(
pivot = [{name = "A", at = [0, 0]}]
[[dyad]]
type = "RRP"
joins = "B"
length = 3
new = "C"
assembly = "crossed"
slide = {through = "A", direction_deg = 30, offset = 0.5}
)"),
      {"B", "C"});
}

TEST(ReadAnalysisTest, ChainOfAnRprIsAGuideBar) {
  expect_same_motion(
      read("mechanism = {type = \"guide-bar\", fixed_pivots = [[0, 0], [2, 1]], crank = 1,"
           " offset = -0.3, assembly = \"crossed\"}\n"
           "point = [{name = \"E\", on = \"guide\", at = [1, 2]}]\n"),
      read(std::string(kCrankAtOrigin) + R"(
pivot = [{name = "A", at = [0, 0]}, {name = "D", at = [2, 1]}]
dyad = [{type = "RPR", joins = ["B", "D"], offset = -0.3, assembly = "crossed"}]
point = [{name = "E", on = "DB", at = [1, 2]}]
)"),
      {"B", "D", "E"});
}

TEST(ReadAnalysisTest, ChainOfAnRppIsAScotchYoke) {
  expect_same_motion(
      read("mechanism = {type = \"scotch-yoke\", crank = 1, offset = 0.2, direction_deg = 20,"
           " slot_deg = 60}\n"),
      read(std::string(kCrankAtOrigin) + R"(
pivot = [{name = "A", at = [0, 0]}]
[[dyad]]
type = "RPP"
joins = "B"
new = "C"
slot_deg = 60
slide = {through = "A", direction_deg = 20, offset = 0.2}
)"),
      {"B", "C"});
}

TEST(ReadAnalysisTest, ChainOfAPrpIsATangentGenerator) {
  expect_same_motion(read("mechanism = {type = \"tangent-generator\", offset = 2}\n"), read(R"(
mechanism.type = "chain"
crank = {at = "A", pin = "K", length = 1, name = "lever"}
pivot = [{name = "A", at = [0, 0]}]
[[dyad]]
type = "PRP"
new = "B"
slides = [{through = "A", on = "lever"}, {through = [0, 2]}]
)"),
                     {"B"}, 0.8, 2.3);
}

// Slider B at (s, 0); B–C 5 and C–D 4 with D at (6, 0).
TEST(ReadAnalysisTest, DrivingSlider) {
  const AnalysisProblem problem = read(R"(
mechanism.type = "chain"
pivot = [{name = "D", at = [6, 0]}]
slider = {slide = {through = [0, 0]}, pin = "B"}
dyad = [{type = "RRR", joins = ["B", "D"], lengths = [5, 4], new = "C", names = ["rod", "lever"]}]
load = [{on = "slider", force = [1, 0], when = [0.5, 2]}]
[drive]
speed = 0.25
start = -2
end = 4
steps = 60
)");
  EXPECT_EQ(problem.drive.start, -2);
  EXPECT_EQ(problem.drive.end, 4);
  EXPECT_EQ(problem.loads[0].between, (std::pair(0.5, 2.0)));
  EXPECT_EQ(problem.mechanism.bodies,
            (std::vector<std::string>{"frame", "slider", "rod", "lever"}));
  expect_near(position(problem, "B", 3), {3, 0});
  expect_near(position(problem, "C", 3), {6, 4});
}

// A point of a link may be joined before its table stands in the file, and carry a further point.
TEST(ReadAnalysisTest, TheOutputOfAChainIsTheBodyNamedOrTheLast) {
  const std::string chain = std::string(kCrankAtOrigin) + R"(
pivot = [{name = "A", at = [0, 0]}, {name = "D", at = [3, 0]}]
dyad = [{type = "RRR", joins = ["B", "D"], lengths = [2.5, 2.5], new = "C"}]
)";
  EXPECT_EQ(read(chain).mechanism.output, 3);
  const AnalysisProblem coupler = read(chain + "mechanism.output = \"BC\"\n");
  EXPECT_EQ(coupler.mechanism.output, 2);
  EXPECT_TRUE(KindTraits<AnalysisProblem>::checked(coupler)) << "what is written names it";
  EXPECT_EQ(read(chain + "mechanism.output = \"CD\"\n").mechanism.output, 3);
}

TEST(ReadAnalysisTest, PointsAreThereOnceTheirBodyIs) {
  const AnalysisProblem problem = read(std::string(kCrankAtOrigin) + R"(
pivot = [{name = "A", at = [0, 0]}, {name = "D", at = [3, 0]}, {name = "G", at = [6, 0]}]
point = [{name = "K", on = ["F", "E"], at = [0.2, 0]},
         {name = "F", on = ["E", "H"], at = [0.5, 0]},
         {name = "E", on = ["B", "C"], at = [1, 1]}]
dyad = [{type = "RRR", joins = ["B", "D"], lengths = [2.5, 2.5], new = "C"},
        {type = "RRR", joins = ["E", "G"], lengths = [4, 3], new = "H"}]
)");
  EXPECT_EQ(problem.mechanism.extra_points.size(), 3U);
  const auto& chain = std::get<ChainDescription>(problem.mechanism.description);
  EXPECT_EQ(chain.dyads[1].names, (std::array<std::string, 2>{"EH", "HG"}));
  const Vec2d e = position(problem, "E", 1);
  const Vec2d f = position(problem, "F", 1);
  EXPECT_NEAR(std::hypot(f.x - e.x, f.y - e.y), 0.5, 1e-12);
  expect_near(position(problem, "K", 1), {0.6 * f.x + 0.4 * e.x, 0.6 * f.y + 0.4 * e.y});
}

}  // namespace
}  // namespace cognate::problems::read_analysis_test
