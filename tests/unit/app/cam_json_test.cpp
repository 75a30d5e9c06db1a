/// The result document of a cam, planted by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/documents/result_json.hpp"
#include "app/export/result_cam.hpp"
#include "app/kinds/kinds.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::app::cam_json_test {
namespace {

using nlohmann::json;
using problems::CamProblem;
using problems::CamResult;

/// A roller over an eccentric motion, its base radius and its return's angle free.
CamProblem planted_problem() {
  CamProblem problem = translating_roller(std::nullopt, -3.5, 8);
  problem.clockwise = true;
  problem.has_operation = true;
  problem.operation.speed = 10;
  problem.operation.inertia = 0.5;
  problem.motion = {segment(cam::MotionLaw::harmonic, 120, 20), segment(cam::MotionLaw::dwell, 60),
                    segment(cam::MotionLaw::cycloidal, 80, -20),
                    segment(cam::MotionLaw::dwell, 100)};
  problem.free_motion = {{2, problems::MotionParameter::over, {60 * kDegree, 100 * kDegree}},
                         {3, problems::MotionParameter::over, {80 * kDegree, 120 * kDegree}}};
  return problem;
}

CamResult planted_result(const CamProblem& problem) {
  problems::CamDesign design;
  design.motion = problem.motion;
  design.motion[2].over = 90 * kDegree;
  design.motion[3].over = 90 * kDegree;
  auto& system = design.cam.system;
  system.follower = {problem.follower, problem.side, {42.25, -3.5, 8, 0, 0, 0}};
  system.start = starting_place(system.follower);
  design.cam.programme = *programme_of(design.motion);
  design.operation.preload = 17.5;
  design.metrics = {{"pressure_angle_deg_max_rise", 29.5},
                    {"pressure_angle_deg_max_rise_at_deg", 51.0},
                    {"curvature_radius_min", HUGE_VAL},
                    {"undercut", true}};
  design.constraints = {{"pressure_angle_deg_max_rise", 29.5, 30.0, true},
                        {"no_undercut", -1.25, 0.0, false}};
  design.origin = "exact:half-planes";
  design.proof = {41.0, {{52 * kDegree, "pressure_angle_deg_max_rise", 30}}};
  CamResult result;
  result.status = problems::Status::infeasible;
  result.designs = {design};
  result.segments = {{{1.5, 4.5, HUGE_VAL}, cam::PeakFactors{1.5, 4.5, 15}}, {}, {}, {}};
  result.jumps = {{120 * kDegree, 2, -9, 0}};
  result.notes = {"A note."};
  return result;
}

json read_back(const CamProblem& problem, const CamResult& result) {
  const auto document = result_document(problem, result, 7);
  EXPECT_TRUE(document.has_value()) << (document ? "" : document.error());
  return document ? json::parse(write_json(*document)) : json();
}

TEST(CamJson, MechanismIsTheWholeCam) {
  const auto problem = planted_problem();
  const json mechanism = read_back(problem, planted_result(problem))["designs"][0]["mechanism"];
  const json expected = {{"type", "cam"},
                         {"follower", "translating-roller"},
                         {"closure", "force"},
                         {"base_radius", 42.25},
                         {"offset", -3.5},
                         {"roller_radius", 8.0},
                         {"rotation", "cw"},
                         {"preload", 17.5},
                         {"motion",
                          {{{"law", "harmonic"}, {"over_deg", 120.0}, {"rise", 20.0}},
                           {{"law", "dwell"}, {"over_deg", 60.0}},
                           {{"law", "cycloidal"}, {"over_deg", 90.0}, {"rise", -20.0}},
                           {{"law", "dwell"}, {"over_deg", 90.0}}}}};
  EXPECT_EQ(mechanism, expected);
}

TEST(CamJson, MetricsHoldFactsAndWhatEveryDesignHas) {
  const auto problem = planted_problem();
  const json design = read_back(problem, planted_result(problem))["designs"][0];
  const json& metrics = design["metrics"];
  EXPECT_EQ(metrics["class"], "translating-roller");
  EXPECT_EQ(metrics["pressure_angle_deg_max_rise"], 29.5);
  EXPECT_FALSE(metrics.contains("curvature_radius_min"));  // infinite
  EXPECT_EQ(metrics["defects"], json({"undercut"}));
  EXPECT_DOUBLE_EQ(metrics["time_ratio"].get<double>(), 120.0 / 90);
  EXPECT_EQ(design["error"], json({{"sum_of_squares", 0.0}, {"rms", 0.0}, {"max", 0.0}}));
  EXPECT_EQ(design["crank_deg"], json::array());
}

// tan α = (s′ − e) / (s₀ + s) on a fine grid.
TEST(CamJson, TransmissionAngleIsThatBesideThePressureAngle) {
  const auto problem = planted_problem();
  const auto result = planted_result(problem);
  const json angle = read_back(problem, result)["designs"][0]["metrics"]["transmission_angle_deg"];
  const double start = std::sqrt(42.25 * 42.25 - 3.5 * 3.5);
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (int i = 0; i < 72000; ++i) {
    const auto motion = result.designs[0].cam.programme.at(0.005 * i * kDegree);
    const double alpha = std::atan((motion.velocity + 3.5) / (start + motion.displacement));
    least = std::min(least, 90 - alpha / kDegree);
    greatest = std::max(greatest, 90 - alpha / kDegree);
  }
  EXPECT_NEAR(angle["min"].get<double>(), least, 1e-6);
  EXPECT_NEAR(angle["max"].get<double>(), greatest, 1e-6);
  EXPECT_NEAR(angle["acute_min"].get<double>(), std::min(least, 180 - greatest), 1e-6);
}

TEST(CamJson, HoldsProofSegmentsAndJumps) {
  const auto problem = planted_problem();
  const json document = read_back(problem, planted_result(problem));
  const json proof = {
      {"base_radius_least", 41.0},
      {"positions",
       {{{"crank_deg", 52.0}, {"limit", "pressure_angle_deg_max_rise"}, {"bound", 30.0}}}}};
  EXPECT_EQ(document["designs"][0]["proof"], proof);
  const json factors = {{"velocity", 1.5}, {"acceleration", 4.5}, {"jerk", nullptr}};
  EXPECT_EQ(document["segments"][0]["peak_factors"], factors);
  EXPECT_EQ(document["segments"][0]["handbook"]["jerk"], 15.0);
  EXPECT_FALSE(document["segments"][1].contains("handbook"));
  const json jumps =
      json::array({{{"at_deg", 120.0}, {"of", "acceleration"}, {"before", -9.0}, {"after", 0.0}}});
  EXPECT_EQ(document["jumps"], jumps);
  EXPECT_EQ(document["problem"]["motion"][2]["over_deg"], json({60.0, 100.0}));
}

TEST(CamJson, DesignIsMadeAnewOfItsMechanism) {
  const auto problem = planted_problem();
  const auto result = planted_result(problem);
  const auto document = result_document(problem, result, 7);
  ASSERT_TRUE(document.has_value());
  const auto given = parse_result_design(write_json(*document), 1, "cam.result.json");
  ASSERT_TRUE(given.has_value()) << given.error();
  const auto made = result_cam(*given);
  ASSERT_TRUE(made.has_value()) << made.error();
  const auto& planted = result.designs[0].cam;
  EXPECT_TRUE(made->problem.clockwise);
  EXPECT_EQ(made->design.cam.system.start, planted.system.start);
  EXPECT_EQ(made->design.cam.system.follower.dimensions.roller_radius, 8);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(made->design.cam.programme.at(0.0628 * i).displacement,
              planted.programme.at(0.0628 * i).displacement);
  }
}

TEST(CamJson, RefusesNumbersThatAreNotFinite) {
  const auto problem = planted_problem();
  auto result = planted_result(problem);
  result.designs[0].proof->base_radius_least = std::nan("");
  const auto document = result_document(problem, result, 7);
  ASSERT_FALSE(document.has_value());
  EXPECT_NE(document.error().find("/designs/0/proof/base_radius_least"), std::string::npos);
}

TEST(CamTable, SaysWhatIsFoundAndWhatIsMissed) {
  const auto problem = planted_problem();
  const std::string text = Kind<problems::CamProblem>::table(problem, planted_result(problem), {});
  for (const char* part :
       {"infeasible: no design satisfies every constraint", "42.25", "29.5 at 51", "1 missed",
        "design 1 violates no_undercut, the radius of curvature without undercut: -1.25 length; "
        "allowed: at least 0",
        "lower bound: no prime radius below 41 keeps pressure_angle_deg_max_rise = 30 at 52 deg",
        "note: A note."}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace cognate::app::cam_json_test
