#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/numbers/constants.hpp"
#include "app/documents/catalogue.hpp"
#include "app/documents/result_json.hpp"
#include "app/kinds/kinds.hpp"
#include "tests/support/named_mechanisms.hpp"

namespace cognate::app::analysis_json_test {
namespace {

using nlohmann::json;
using problems::AnalysisProblem;
using problems::AnalysisResult;

AnalysisProblem four_bar_problem() {
  auto problem = problems::analysis_of(
      problems::named(FourBar{{1, 2}, {5, 3}, 1, 4, 3, Assembly::crossed, Vec2d{2, 0.5}}), 2);
  problem.title = "Planted";
  problem.output.points = {4};
  problem.inertias[2] = {.mass = 2, .centre = {1, 0.5}, .moment = 0.25};
  problem.loads = {{.at = {3, {1, 0}},
                    .force = {1, -2},
                    .sense = problems::LoadSense::retreat,
                    .within_stroke = std::pair(0.05, 0.95)}};
  return problem;
}

AnalysisResult planted() {
  AnalysisResult result;
  result.status = problems::Status::solved;
  result.columns = {{"crank_deg", "drive", "crank", "deg", {0, 180, 360}},
                    {"P_x", "position", "P", "length", {0.1, kNaN, 0.3}}};
  result.closed_rows = 2;
  result.landmarks = {{"limit position", "rocker", kPi / 4, kPi / 3},
                      {"dead point", "C", kPi, kNaN}};
  result.quantities = {{"class", std::string("crank-rocker")},
                       {"crank_turns_fully", true},
                       {"transmission_angle_deg.min", 40.0},
                       {"reaction_max_N.B.2_on_coupler", 7.5}};
  result.work.positions = 3;
  result.notes = {"a note"};
  return result;
}

json read_back(const AnalysisProblem& problem, const AnalysisResult& result) {
  const auto document = result_document(problem, result, 5);
  EXPECT_TRUE(document.has_value()) << document.error();
  return json::parse(write_json(*document));
}

TEST(AnalysisJson, HoldsTheMechanismOfTheFileAndItsFacts) {
  const json document = read_back(four_bar_problem(), planted());
  EXPECT_EQ(document["status"], "solved");
  EXPECT_EQ(document["seed"], 5);
  const json& design = document["designs"].at(0);
  const json mechanism = {{"type", "four-bar"},
                          {"fixed_pivots", {{1.0, 2.0}, {5.0, 3.0}}},
                          {"crank", 1.0},
                          {"coupler", 4.0},
                          {"rocker", 3.0},
                          {"assembly", "crossed"},
                          {"coupler_point", {2.0, 0.5}}};
  EXPECT_EQ(design["mechanism"], mechanism);
  EXPECT_EQ(document["problem"]["mechanism"], mechanism);
  EXPECT_EQ(design["origin"], "given");
  EXPECT_EQ(design["crank_deg"], json({0.0, 180.0, 360.0}));
  const json metrics = {{"class", "crank-rocker"},
                        {"crank_turns_fully", true},
                        {"transmission_angle_deg", {{"min", 40.0}}},
                        {"reaction_max_N", {{"B.2_on_coupler", 7.5}}},
                        {"time_ratio", nullptr},
                        {"defects", json::array()}};
  EXPECT_EQ(design["metrics"], metrics);
}

TEST(AnalysisJson, EmptyCellsAreNull) {
  const json analysis = read_back(four_bar_problem(), planted())["analysis"];
  EXPECT_EQ(analysis["columns"].at(1), json({{"name", "P_x"},
                                             {"quantity", "position"},
                                             {"of", "P"},
                                             {"unit", "length"},
                                             {"values", {0.1, nullptr, 0.3}}}));
  const json landmarks = {
      {{"kind", "limit position"}, {"of", "rocker"}, {"crank_deg", 45.0}, {"output_deg", 60.0}},
      {{"kind", "dead point"}, {"of", "C"}, {"crank_deg", 180.0}}};
  EXPECT_EQ(analysis["landmarks"], landmarks);
}

TEST(AnalysisJson, CellsThatAreNotFiniteAreNull) {
  auto result = planted();
  result.columns.at(1).values = {HUGE_VAL, -HUGE_VAL, 0.3};
  const json analysis = read_back(four_bar_problem(), result)["analysis"];
  EXPECT_EQ(analysis["columns"].at(1)["values"], json({nullptr, nullptr, 0.3}));
}

TEST(AnalysisJson, SaysWhatTheFileAsks) {
  const json problem = read_back(four_bar_problem(), planted())["problem"];
  EXPECT_EQ(problem["title"], "Planted");
  EXPECT_EQ(problem["drive"]["end_deg"], 360.0);
  EXPECT_EQ(problem["output"]["points"], json({"P"}));
  EXPECT_EQ(problem["link"],
            json::array(
                {{{"name", "coupler"}, {"mass", 2.0}, {"centre", {1.0, 0.5}}, {"inertia", 0.25}}}));
  EXPECT_EQ(problem["load"], json::array({{{"on", "rocker"},
                                           {"at", {1.0, 0.0}},
                                           {"force", {1.0, -2.0}},
                                           {"torque", 0.0},
                                           {"when", "return"},
                                           {"stroke", {0.05, 0.95}}}}));
}

TEST(AnalysisJson, RefusesFactsThatAreNotFinite) {
  auto result = planted();
  result.quantities.push_back({"closure_residual", std::numeric_limits<double>::infinity()});
  const auto document = result_document(four_bar_problem(), result, 1);
  ASSERT_FALSE(document.has_value());
  EXPECT_NE(document.error().find("closure_residual"), std::string::npos) << document.error();
}

/// Names with what stands for a part of the mechanism taken out.
std::string without_parts(const std::string& name) {
  const auto dot = name.find('.');
  const bool of_joint = name.starts_with("reaction");
  return of_joint ? name.substr(0, dot) : name;
}

TEST(AnalysisJson, EveryFactIsInTheCatalogue) {
  std::set<std::string> listed;
  for (const auto& metric : Kind<problems::AnalysisProblem>::metric_lists().front().metrics)
    listed.insert(without_parts(std::string(metric.key)));
  auto turning = four_bar_problem();
  turning.output.reactions = true;
  turning.output.torque = true;
  auto sliding = problems::analysis_of(problems::named(SliderCrank{.crank = 1, .coupler = 3}), 8);
  for (const auto& problem : {turning, sliding}) {
    for (const auto& quantity : problems::analyse(problem, {}).quantities) {
      const std::string name = without_parts(quantity.name);
      if (name.ends_with("_at_deg") && name.starts_with("torque"))
        continue;  // reported with its value
      EXPECT_TRUE(listed.contains(name)) << name;
    }
  }
}

TEST(AnalysisTable, ShowsFactsLandmarksAndNotes) {
  const std::string text =
      Kind<problems::AnalysisProblem>::table(four_bar_problem(), planted(), {});
  for (const char* part :
       {"Planted: analysis of four-bar, crank 0 deg to 360 deg in 2 steps",
        "solved: the mechanism can be assembled at 2 of 3 positions", "crank_turns_fully", "yes",
        "limit position", "45", "60", "[deg]", "note: a note"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
  }
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace cognate::app::analysis_json_test
