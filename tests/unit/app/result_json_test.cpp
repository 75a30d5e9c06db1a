#include "app/documents/result_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/documents/catalogue.hpp"
#include "app/documents/json_values.hpp"
#include "app/kinds/kinds.hpp"
#include "tests/support/planted_result.hpp"

namespace cognate::app::result_json_test {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using problems::planted_path;
using problems::planted_result;
using problems::Range;

/// The document of `result` as a stranger reads it: from its text.
template <class Problem>
json read_back(const Problem& problem, const problems::Result& result) {
  const auto document = result_document(problem, result, 7);
  EXPECT_TRUE(document.has_value()) << (document ? "" : document.error());
  return document ? json::parse(write_json(*document)) : json();
}

TEST(ResultJson, HoldsTheDesignThatWasPlanted) {
  const auto planted = planted_result();
  const json document = read_back(planted_path(), planted);
  EXPECT_EQ(document["format"], "cognate-result/1");
  EXPECT_EQ(document["status"], "solved");
  EXPECT_EQ(document["seed"], 7);
  ASSERT_EQ(document["designs"].size(), 2u);

  const json mechanism = {{"type", "four-bar"},
                          {"fixed_pivots", {{-1.0 / 3, 0.1}, {4.0, 3 + 0.1}}},
                          {"crank", 1.1},
                          {"coupler", 2.0 / 7},
                          {"rocker", 4e-17},
                          {"assembly", "crossed"},
                          {"coupler_point", {0.3, -0.7}}};
  EXPECT_EQ(document["designs"][0]["mechanism"], mechanism);
  const json error = {{"sum_of_squares", 1e-300}, {"rms", 0.0625}, {"max", 0.125}};
  EXPECT_EQ(document["designs"][0]["error"], error);
  EXPECT_EQ(document["designs"][0]["crank_deg"][1], 45.0);
  EXPECT_FALSE(document["designs"][0].contains("cognate_of"));
  EXPECT_EQ(document["designs"][1]["cognate_of"], 0);
  EXPECT_EQ(document["designs"][1]["origin"], "exact:three-pairs + ceres");
  EXPECT_EQ(document["notes"], json({"A note."}));
}

TEST(ResultJson, HoldsTheMetricsInDegrees) {
  const json metrics = read_back(planted_path(), planted_result())["designs"][1]["metrics"];
  const json expected = {
      {"class", "rocker-crank"},
      {"change_point", true},
      {"transmission_angle_deg", {{"min", 30.0}, {"max", 135.0}, {"acute_min", 20.0}}},
      {"time_ratio", 1.25},
      {"defects", {"branch", "order"}},
      {"input_start_deg", 60.0},
      {"output_start_deg", -90.0},
      {"precision_residual", 1e-15},
      {"condition", 12.5}};
  EXPECT_EQ(metrics, expected);
}

TEST(ResultJson, HoldsWhatWasCheckedAndTheWorkDone) {
  const json document = read_back(planted_path(), planted_result());
  const json checks = {{{"name", "link_ratio_max"},
                        {"label", "longest over shortest link"},
                        {"relation", "<="},
                        {"unit", ""},
                        {"value", 7.5},
                        {"bound", 5.0},
                        {"satisfied", false}},
                       {{"name", "class"},
                        {"label", "class"},
                        {"relation", "="},
                        {"unit", ""},
                        {"value", "rocker-crank"},
                        {"bound", "crank-rocker"},
                        {"satisfied", false}},
                       {{"name", "bounds.rocker"},
                        {"label", "rocker"},
                        {"relation", ">="},
                        {"unit", "length"},
                        {"value", 4e-17},
                        {"bound", {{"min", 2.0}}},
                        {"satisfied", true}}};
  EXPECT_EQ(document["designs"][1]["constraints"], checks);
  const json work = {{"seconds", 0.5},           {"threads", 2},     {"candidates", 11},
                     {"positions", 22},          {"velocities", 33}, {"accelerations", 44},
                     {"reactions", 0},           {"gradients", 55},  {"solver_iterations", 66},
                     {"skipped", {"velocities"}}};
  EXPECT_EQ(document["work"], work);
}

TEST(ResultJson, HoldsWarningsAndInWhatTwinsDiffer) {
  auto result = planted_result();
  result.warnings = {"Design 2: odd."};
  result.designs[1].warnings = {"Odd."};
  result.designs[1].twin_of = 0;
  result.designs[1].differs = {"assembly"};
  const json document = read_back(planted_path(), result);
  EXPECT_EQ(document["warnings"], json({"Design 2: odd."}));
  EXPECT_EQ(document["designs"][0]["warnings"], json::array());
  EXPECT_EQ(document["designs"][1]["warnings"], json({"Odd."}));
  EXPECT_EQ(document["designs"][1]["twin_of"], 0);
  EXPECT_EQ(document["designs"][1]["differs"], json({"assembly"}));
  EXPECT_FALSE(document["designs"][0].contains("differs"));
}

TEST(ResultJson, SaysWhatIsAlwaysThereEvenWithoutAValue) {
  const json metrics = read_back(planted_path(), planted_result())["designs"][0]["metrics"];
  EXPECT_TRUE(metrics.at("time_ratio").is_null());
  EXPECT_TRUE(metrics.at("defects").is_array());
  EXPECT_TRUE(metrics.at("defects").empty());
}

TEST(ResultJson, GivesFunctionErrorsInDegreesBesides) {
  problems::FunctionProblem problem;
  problem.target = problems::AnglePairs{{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.7}};
  auto result = planted_result();
  result.designs[0].error = {.sum_of_squares = 0.5, .rms = kPi / 180, .max = kPi / 90};
  const json error = read_back(problem, result)["designs"][0]["error"];
  EXPECT_EQ(error["rms"], kPi / 180);
  EXPECT_EQ(error["rms_deg"], 1.0);
  EXPECT_EQ(error["max_deg"], 2.0);
}

TEST(ResultJson, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    auto result = planted_result();
    result.designs[1].error.rms = bad;
    const auto document = result_document(planted_path(), result, 1);
    ASSERT_FALSE(document.has_value());
    EXPECT_NE(document.error().find("/designs/1/error/rms"), std::string::npos) << document.error();
  }
}

TEST(ResultJson, LeavesOutAnInfiniteCondition) {
  auto result = planted_result();
  result.designs[0].metrics.condition = kInfinity;
  const json metrics = read_back(planted_path(), result)["designs"][0]["metrics"];
  EXPECT_FALSE(metrics.contains("condition"));
}

TEST(ResultJson, HoldsMechanismsOfEveryType) {
  const json document = read_back(problems::planted_motion(), problems::planted_synthesis());
  const json mechanism = {{"type", "slider-crank"}, {"pivot", {1.0, 2.0}}, {"crank", 0.5},
                          {"coupler", 2.5},         {"offset", -0.125},    {"direction_deg", 0.0},
                          {"assembly", "open"}};
  EXPECT_EQ(document["designs"][1]["mechanism"], mechanism);
  EXPECT_EQ(document["designs"][1]["mirror_of"], 0);
  EXPECT_FALSE(document["designs"][0].contains("mirror_of"));
}

TEST(ResultJson, NestsFactsAndLeavesOutThoseWithoutANumber) {
  const json document = read_back(problems::planted_motion(), problems::planted_synthesis());
  const json expected = {
      {"class", "crank turns fully"},
      {"swing", {{"least_deg", 12.5}}},
      {"certified", true},
      {"change_point", false},
      {"transmission_angle_deg", {{"min", 45.0}, {"max", 135.0}, {"acute_min", 45.0}}},
      {"time_ratio", nullptr},
      {"defects", json::array()},
      {"precision_residual", 2e-16}};
  EXPECT_EQ(document["designs"][1]["metrics"], expected);
  const json quantities = {{"complex_solutions", 1442.0}, {"real", {{"triplets", 21.0}}}};
  EXPECT_EQ(document["facts"], quantities);
}

TEST(ResultJson, BreaksCurvesAndEmptiesCellsWhereThereIsNoNumber) {
  const json document = read_back(problems::planted_motion(), problems::planted_synthesis());
  const json loci = {{{"name", "centre-point curve"},
                      {"branches", {{{0.0, 1.0}, {2.0, 3.0}}, json::array({{4.0, 5.0}})}}},
                     {{"name", "poles"}, {"branches", json::array({json::array({{6.0, 7.0}})})}}};
  EXPECT_EQ(document["loci"], loci);
  const json family = {{"name", "fixed pivot"},
                       {"columns",
                        {{{"name", "at"}, {"values", {1.0, 2.0, 3.0}}},
                         {{"name", "swing_deg"}, {"values", {30.0, nullptr, 50.0}}}}}};
  EXPECT_EQ(document["families"], json::array({family}));
  const json none = read_back(planted_path(), planted_result());
  for (const char* table : {"loci", "families", "facts"}) EXPECT_FALSE(none.contains(table));
}

TEST(ResultJson, GivesTheWayOfADrivingSliderAsALength) {
  auto result = problems::planted_synthesis();
  auto& design = result.designs[1];
  design.mechanism.mechanism.drive = DrivingSlider<double>{};
  design.crank_angles = {-3.5, 400};
  const json read = read_back(problems::planted_motion(), result)["designs"][1];
  EXPECT_EQ(read["slide"], json({-3.5, 400.0}));
  EXPECT_FALSE(read.contains("crank_deg"));
}

TEST(ResultJson, ReplacesBytesThatAreNotUtf8) {
  auto result = planted_result();
  result.notes = {"stray \xff byte"};
  EXPECT_EQ(read_back(planted_path(), result)["notes"][0], "stray \xEF\xBF\xBD byte");
}

TEST(ResultJson, KeepsAListOfNumbersOnOneLine) {
  const auto document = nlohmann::ordered_json::parse(
      R"({"a": [], "b": {}, "c": [1, null, 2.5], "d": [{"e\n": [[0.1, 2], [3]]}, "f"]})");
  const std::string text = write_json(document);
  EXPECT_EQ(text, R"({
  "a": [],
  "b": {},
  "c": [1,null,2.5],
  "d": [
    {
      "e\n": [
        [0.1,2],
        [3]
      ]
    },
    "f"
  ]
}
)");
  EXPECT_EQ(nlohmann::ordered_json::parse(text), document);
}

TEST(ResultJson, WritesRangesWithoutTheirInfiniteSides) {
  EXPECT_EQ(to_json(Range{1, 2}).dump(), "[1.0,2.0]");
  EXPECT_EQ(to_json(Range{1, kInfinity}).dump(), R"({"min":1.0})");
  EXPECT_EQ(to_json(Range{-kInfinity, 2}).dump(), R"({"max":2.0})");
  EXPECT_EQ(to_json(problems::Box{{0, 1}, {2, kInfinity}}).dump(),
            R"({"x":[0.0,2.0],"y":{"min":1.0}})");
}

// What a problem file gives in degrees comes back as it was written, and for any angle, the
// double that a reader makes of the degrees differs by no more than rounding.
TEST(ResultJson, DegreesReadBack) {
  for (int tenths = -7200; tenths <= 7200; ++tenths) {
    const double written = tenths / 10.0;
    ASSERT_EQ(degrees(written * (kPi / 180.0)), written);
  }
  for (double angle = 1e-9; angle < 1e3; angle *= 1.37) {
    const double again = degrees(angle) * (kPi / 180.0);
    ASSERT_LE(std::abs(again - angle), 2 * std::numeric_limits<double>::epsilon() * angle) << angle;
  }
}

void collect_keys(const json& table, const std::string& above, std::set<std::string>& keys) {
  for (const auto& [key, value] : table.items()) {
    if (value.is_object()) {
      collect_keys(value, above + key + ".", keys);
    } else {
      keys.insert(above + key);
    }
  }
}

TEST(ResultJson, EveryMetricIsInTheCatalogue) {
  std::set<std::string> written;
  collect_keys(read_back(planted_path(), planted_result())["designs"][1]["metrics"], "", written);
  std::set<std::string> listed;
  for (const auto& metric : metrics()) listed.emplace(metric.key);
  for (const auto& key : written) EXPECT_TRUE(listed.contains(key)) << key;
}

}  // namespace
}  // namespace cognate::app::result_json_test
