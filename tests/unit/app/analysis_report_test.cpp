// What the report of an analysis draws: motion, shapes, vectors and rows.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/convex_hull.hpp"
#include "app/drawing/mechanism_poses.hpp"
#include "app/drawing/mechanism_shapes.hpp"
#include "app/kinds/kinds.hpp"
#include "app/report/analysis_report_data.hpp"
#include "app/report/column_vectors.hpp"
#include "app/report/drawn_rows.hpp"
#include "app/report/mechanism_json.hpp"
#include "app/report/report.hpp"
#include "problems/read.hpp"

namespace cognate::app::analysis_report_test {
namespace {

using problems::AnalysisProblem;
using problems::AnalysisResult;
using problems::Column;
using problems::NamedMechanism;

NamedMechanism named(Mechanism<double> mechanism, std::vector<std::string> bodies) {
  NamedMechanism result;
  result.mechanism = std::move(mechanism);
  result.bodies = std::move(bodies);
  return result;
}

NamedMechanism four_bar(double crank) {
  FourBar linkage;
  linkage.pivot_d = {4, 0};
  linkage.crank = crank;
  linkage.coupler = 3;
  linkage.rocker = 2.5;
  NamedMechanism result = named(as_mechanism(linkage), {"frame", "crank", "coupler", "rocker"});
  result.points = {{"B", {1, {crank, 0}}}, {"P", {2, {1, 2}}}};
  return result;
}

NamedMechanism slider_crank() {
  SliderCrank mechanism;
  mechanism.crank = 1;
  mechanism.coupler = 3;
  mechanism.offset = 0.5;
  return named(as_mechanism(mechanism), {"frame", "crank", "coupler", "slider"});
}

double distance(const Vec2d& a, const Vec2d& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

std::vector<double> lengths(const std::vector<Rail>& rails) {
  std::vector<double> all;
  for (const Rail& rail : rails) all.push_back(distance(rail.from, rail.to));
  return all;
}

// The inner joint, carried by either link, is one place: the loop closes at every sample.
TEST(MechanismPoses, CloseTheLoopOnBothSidesOfAJoint) {
  const auto poses = sample_poses(four_bar(1).mechanism, 0, kTurn, 361);
  ASSERT_EQ(poses.size(), 361u);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Vec2d by_coupler = place(poses.bodies[2], k, {3, 0});
    const Vec2d by_rocker = place(poses.bodies[3], k, {2.5, 0});
    EXPECT_LT(distance(by_coupler, by_rocker), 1e-13);
    EXPECT_NEAR(distance(by_rocker, {4, 0}), 2.5, 1e-13);
  }
}

TEST(MechanismPoses, FollowAnAngleThroughWholeTurns) {
  const auto poses = sample_poses(four_bar(1).mechanism, 0, 2 * kTurn, 721);
  const auto& angle = poses.bodies[1].angle;
  EXPECT_NEAR(angle.back() - angle.front(), 2 * kTurn, 1e-12);
}

// A crank of 2.6 with coupler 3 and rocker 2.5 over a frame of 4 closes where |B − D| ≤ 5.5.
TEST(MechanismPoses, SampleTheEndsOfARangeAndPlaceTheDriveAloneBeyond) {
  const auto poses = sample_poses(four_bar(2.6).mechanism, 0, kTurn, 91);
  const double end = std::acos((2.6 * 2.6 + 16 - 5.5 * 5.5) / (2 * 2.6 * 4));
  double last = 0;
  std::size_t gaps = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_TRUE(std::isfinite(poses.bodies[1].angle[k]));
    const bool closes = std::isfinite(poses.bodies[2].x[k]);
    if (closes && poses.drive[k] < kPi) last = poses.drive[k];
    gaps += closes ? 0 : 1;
  }
  EXPECT_NEAR(last, end, 1e-9);
  EXPECT_GT(gaps, 10u);
  EXPECT_GT(poses.size(), 91u);
}

// A parallelogram stays one through its change points.
TEST(MechanismPoses, GoSmoothlyThroughChangePoints) {
  FourBar linkage;
  linkage.pivot_d = {3, 0};
  linkage.crank = linkage.rocker = 1;
  linkage.coupler = 3;
  const double start = 0.7;
  linkage.assembly = Assembly::open;
  const auto poses = sample_poses(as_mechanism(linkage), start, start + kTurn, 361);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_NEAR(std::remainder(poses.bodies[3].angle[k] - poses.bodies[1].angle[k], kTurn), 0, 1e-6)
        << poses.drive[k];
  }
}

TEST(MechanismShapes, ConnectJointsAndNamedPointsOfABody) {
  const auto mechanism = four_bar(1);
  const auto shapes = mechanism_shapes(mechanism, sample_poses(mechanism.mechanism, 0, kTurn, 91));
  ASSERT_EQ(shapes.bodies.size(), 4u);
  EXPECT_TRUE(shapes.bodies[0].outline.empty());
  EXPECT_EQ(shapes.bodies[1].outline.size(), 2u);
  EXPECT_EQ(shapes.bodies[2].outline.size(), 3u);
  EXPECT_EQ(shapes.bodies[3].outline.size(), 2u);
  ASSERT_EQ(shapes.pins.size(), 4u);
  EXPECT_EQ(std::ranges::count_if(shapes.pins, [](const Pin& pin) { return pin.fixed; }), 2);
}

// The stroke of an offset slider-crank is √((l+r)² − e²) − √((l−r)² − e²).
TEST(MechanismShapes, MakeAGuideAsLongAsTheStroke) {
  const auto mechanism = slider_crank();
  const auto shapes =
      mechanism_shapes(mechanism, sample_poses(mechanism.mechanism, 0, kTurn, 7201));
  ASSERT_EQ(shapes.bodies[0].rails.size(), 1u);
  const double stroke = std::sqrt(16 - 0.25) - std::sqrt(4 - 0.25);
  EXPECT_NEAR(lengths(shapes.bodies[0].rails)[0], stroke, 1e-6);
  EXPECT_NEAR(shapes.bodies[0].rails[0].from.y, 0.5, 1e-15);
  EXPECT_TRUE(shapes.bodies[3].block);
}

// A block travels on a guide-bar from frame − crank to frame + crank.
TEST(MechanismShapes, MakeABarReachFromItsPivotToTheFarEndOfTheSlot) {
  GuideBar guide;
  guide.pivot_a = {0, 4};
  guide.crank = 1;
  const auto mechanism = named(as_mechanism(guide), {"frame", "crank", "block", "bar"});
  const auto shapes = mechanism_shapes(mechanism, sample_poses(mechanism.mechanism, 0, kTurn, 721));
  ASSERT_EQ(shapes.bodies[3].rails.size(), 1u);
  EXPECT_NEAR(shapes.bodies[3].rails[0].from.x, 3, 1e-4);
  EXPECT_NEAR(shapes.bodies[3].rails[0].to.x, 5, 1e-4);
  ASSERT_EQ(shapes.bodies[3].outline.size(), 2u);
  EXPECT_NEAR(distance(shapes.bodies[3].outline[0], shapes.bodies[3].outline[1]), 5, 1e-4);
  EXPECT_TRUE(shapes.bodies[2].block);
}

TEST(MechanismShapes, GiveAYokeASlotAcrossItsGuide) {
  ScotchYoke yoke;
  yoke.crank = 2;
  const auto mechanism = named(as_mechanism(yoke), {"frame", "crank", "block", "yoke"});
  const auto shapes = mechanism_shapes(mechanism, sample_poses(mechanism.mechanism, 0, kTurn, 721));
  EXPECT_NEAR(lengths(shapes.bodies[0].rails).at(0), 4, 1e-4);
  EXPECT_NEAR(lengths(shapes.bodies[3].rails).at(0), 4, 1e-4);
  EXPECT_NEAR(shapes.bodies[3].rails[0].from.x, 0, 1e-15);
}

TEST(ConvexHull, LeavesOutWhatIsInsideAndOnEdges) {
  const auto hull =
      convex_hull({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {2, 2}, {0, 2}, {0, 0}, {2, 1}}, 1e-9);
  const std::vector<Vec2d> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(hull, square);
  EXPECT_EQ(convex_hull({{0, 0}, {1, 1}, {3, 3}}, 1e-9).size(), 2u);
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}}, 1e-9).size(), 1u);
}

Column column(const std::string& name, std::vector<double> values = {}) {
  return {name, "velocity", "B", "length/s", std::move(values)};
}

TEST(ColumnVectors, AreNeighboursThatDifferInXAndYAlone) {
  const auto mechanism = four_bar(1);
  auto force = column("frame-crank_Fx_N");
  force.of = "frame-crank";
  auto other_force = column("frame-crank_Fy_N");
  other_force.of = "frame-crank";
  const auto vectors =
      column_vectors(mechanism, {column("B_deg"), column("B_vx_per_s"), column("B_vy_per_s"),
                                 column("x"), column("z"), force, other_force});
  ASSERT_EQ(vectors.size(), 2u);
  EXPECT_EQ(vectors[0].x, 1u);
  EXPECT_EQ(vectors[0].y, 2u);
  ASSERT_TRUE(vectors[0].at);
  EXPECT_EQ(vectors[0].at->body, 1);
  ASSERT_TRUE(vectors[1].at);
  EXPECT_EQ(vectors[1].at->body, 0);
}

// A slider-crank's guide is along x: its force is along y.
TEST(NormalForces, ActAcrossTheirGuide) {
  const auto mechanism = slider_crank();
  auto normal = column("frame_on_slider_N");
  normal.quantity = "reactions";
  const auto forces = normal_forces(mechanism, {column("B_deg"), normal});
  ASSERT_EQ(forces.size(), 1u);
  EXPECT_EQ(forces[0].column, 1u);
  EXPECT_EQ(forces[0].at.body, 3);
  EXPECT_EQ(forces[0].normal, (Vec2d{0, 1}));
  EXPECT_TRUE(normal_forces(mechanism, {column("B_deg")}).empty());
}

TEST(DrawnRows, AreAllWhereTheyAreFew) {
  const std::vector<Column> columns = {column("a", {1, 2, 3}), column("b", {1, kNaN, 2})};
  EXPECT_EQ(drawn_rows(columns, 100, 1000), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(drawn_rows({}, 100, 1000).empty());
  EXPECT_EQ(drawn_rows(std::vector{column("a", {1})}, 100, 1000), std::vector<std::size_t>{0});
}

TEST(DrawnRows, KeepTheEndsAndThePeaks) {
  std::vector<double> values(10'001, 0.0);
  values[1234] = 5;
  values[4321] = -7;
  values[17] = kNaN;
  const auto rows = drawn_rows(std::vector{column("a", values)}, 100, 100'000);
  const std::set<std::size_t> kept(rows.begin(), rows.end());
  EXPECT_EQ(kept.size(), rows.size());
  EXPECT_LE(rows.size(), 102u);
  for (const std::size_t row : {0u, 1234u, 4321u, 10'000u}) EXPECT_TRUE(kept.contains(row)) << row;
}

AnalysisProblem problem_of(NamedMechanism mechanism) {
  AnalysisProblem problem;
  problem.title = "</script><b>";
  problem.mechanism = std::move(mechanism);
  problem.inertias.resize(4);
  problem.drive.end = kTurn;
  problem.drive.rate.speed = 1;
  return problem;
}

// What is embedded in `html`.
nlohmann::ordered_json embedded_data(const std::string& html) {
  const std::string opening = R"(<script type="application/json" id="data">)";
  const auto begin = html.find(opening) + opening.size();
  return nlohmann::ordered_json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

TEST(AnalysisReport, HasGapsAsNullAndNothingThatEndsTheData) {
  const auto problem = problem_of(four_bar(2.6));
  const AnalysisResult result = analyse(problem, {.threads = 1});
  const auto html = report_html({{"problem", {{"title", problem.title}}}}, problem, result);
  const auto data = embedded_data(html);
  EXPECT_EQ(data["result"]["problem"]["title"], problem.title);
  EXPECT_EQ(data["table"]["rows"], 361);
  std::size_t gaps = 0;
  for (const auto& value : data["table"]["columns"][1]["values"]) gaps += value.is_null() ? 1 : 0;
  EXPECT_GT(gaps, 50u);
  EXPECT_FALSE(data["mechanism"]["bodies"][2]["deg"].empty());
  EXPECT_EQ(html.find("NaN,"), std::string::npos);
}

// The work of all loads, weights and the drive in a small step of a slow motion is nothing: it
// holds each arrow's place, size and rows, and the unit of gravity, against places alone.
TEST(AnalysisReport, DrawsLoadsThatTheDriveBalances) {
  const auto problem = *problems::parse_task<AnalysisProblem>(R"(
kind = "analysis"
length_unit = "mm"
gravity = [0, -9806.65]
[mechanism]
type = "slider-crank"
pivot = [0, 0]
crank = 100
coupler = 300
offset = 20
[[link]]
name = "coupler"
mass = 3
centre = [120, 10]
[[load]]
on = "slider"
force = [-50, 7]
when = "advance"
[[load]]
on = "crank"
torque = 0.75
when = [30, 200]
[[load]]
on = "coupler"
at = [40, -5]
force = [3, 4]
[drive]
speed = 1e-5
steps = 90
[output]
want = ["torque"]
)");
  const AnalysisResult result = analyse(problem, {.threads = 1});
  const auto data = analysis_report_data(problem, result);
  const auto& loads = data["loads"];
  ASSERT_EQ(loads.size(), 5u);
  const auto& torque = data["table"]["columns"][loads[4]["column"].get<std::size_t>()]["values"];
  MechanismMotion<0> motion(problem.mechanism.mechanism);
  // m, and the angle, of an arrow at a crank angle.
  const auto stand = [&](const auto& entry, double crank) {
    motion.move_to(crank);
    const auto& body = motion.bodies()[entry["body"].template get<std::size_t>()];
    const Vec2d at{entry["at"][0], entry["at"][1]};
    return std::pair(0.001 * (body.origin[0] + body.direction * at), body.direction);
  };
  int off = 0;
  for (std::size_t row = 0; row < torque.size(); ++row) {
    const double crank = data["table"]["drive"][row].get<double>() * kDegree, step = 1e-4;
    double work = torque[row].get<double>() * 2 * step;
    for (std::size_t i = 0; i + 1 < loads.size(); ++i) {
      const auto& entry = loads[i];
      if (!entry["acts"].is_null() && !entry["acts"][row].get<bool>()) {
        ++off;
        continue;
      }
      const auto [before, from] = stand(entry, crank - step);
      const auto [after, to] = stand(entry, crank + step);
      const Vec2d force{entry["force"][0], entry["force"][1]};
      work += dot(force, after - before) + entry["torque"].get<double>() * cross(from, to);
    }
    EXPECT_NEAR(work / (2 * step), 0, 1e-5) << row;
  }
  EXPECT_GT(off, 60);
  EXPECT_EQ(loads[3]["kind"], "weight");
  EXPECT_TRUE(loads[2]["acts"].is_null());
}

TEST(AnalysisReport, DrawsNoLoadsWhereNoForcesAreAsked) {
  auto problem = problem_of(four_bar(1));
  problem.loads = {{.at = {1, {}}, .force = {1, 0}}};
  const auto data = analysis_report_data(problem, analyse(problem, {.threads = 1}));
  EXPECT_TRUE(data["loads"].empty());
}

// A chain of fifty four-bars over ten thousand rows stays a page that opens at once.
TEST(AnalysisReport, StaysSmallForALongChain) {
  NamedMechanism chain = four_bar(0.5);
  chain.description = problems::ChainDescription{};
  chain.points.clear();
  for (int i = 1; i < 50; ++i) {
    const Rrr<double> dyad{{1, {0.5, 0}}, {0, {4, 0.01 * i}}, 3, 2.5, Assembly::open};
    chain.mechanism.dyads.push_back(dyad);
    chain.bodies.insert(chain.bodies.end(),
                        {"coupler " + std::to_string(i), "rocker " + std::to_string(i)});
    chain.points.push_back({"C" + std::to_string(i), {2 + 2 * i, {3, 0}}});
  }
  auto problem = problem_of(chain);
  problem.inertias.resize(chain.bodies.size());
  problem.drive.steps = 10'000;
  const auto html = report_html({{"status", "solved"}}, problem, analyse(problem, {.threads = 1}));
  EXPECT_LT(html.size(), 1'600'000u);  // 770 000 of them are the kernel
}

}  // namespace
}  // namespace cognate::app::analysis_report_test
