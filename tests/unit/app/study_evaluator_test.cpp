// Designs of studies against closed forms, and against the same problem solved from its text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "app/study/design_values.hpp"
#include "app/study/evaluator.hpp"
#include "app/study/metrics.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/study/design_points.hpp"
#include "problems/study/design_text.hpp"
#include "tests/support/folders.hpp"

namespace cognate::app::study_evaluator_test {
namespace {

using problems::Cell;
using problems::RunStatus;
using problems::Study;
using problems::StudyBlock;

const std::filesystem::path kLibrary = kLibraryFolder;

Study study_of(const std::string& text) {
  const auto read = problems::parse_study(text, kLibrary, study_metrics);
  EXPECT_TRUE(read) << (read ? "" : read.error()[0].message);
  return read.value_or(Study{});
}

StudyBlock all_of(const Study& study, std::uint64_t seed = 1) {
  const auto block = general_evaluator(study, seed, nullptr)(0, design_count(study));
  EXPECT_TRUE(block);
  return block.value_or(StudyBlock{});
}

/// The rows as maps from column to value.
std::vector<std::map<std::string, Cell>> rows_of(const Study& study, const StudyBlock& block) {
  const auto columns = study_columns(study);
  std::vector<std::map<std::string, Cell>> rows(block.ids.size());
  EXPECT_EQ(block.cells.size(), rows.size() * columns.size());
  EXPECT_EQ(block.statuses.size(), rows.size());
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    rows[i / columns.size()][columns[i % columns.size()]] = block.cells[i];
  }
  return rows;
}

double number(const Cell& cell) {
  const auto* value = std::get_if<double>(&cell);
  EXPECT_TRUE(value);
  return value ? *value : 0;
}

std::string word(const Cell& cell) {
  const auto* value = std::get_if<std::string>(&cell);
  EXPECT_TRUE(value);
  return value ? *value : "";
}

const std::string kFourBars = R"(base = "analysis/crank-rocker.toml"
[[vary]]
key = "mechanism.coupler"
range = [1.3, 3.9]
steps = 6
[[vary]]
key = "mechanism.rocker"
range = [1.25, 4.1]
steps = 6
)";

// Hoeken's frame and crank: frame 2, crank 1.
TEST(StudyEvaluator, ClassesAreGrashofs) {
  const Study study = study_of(kFourBars + "[output]\nmetrics = [\"class\"]\n");
  const StudyBlock block = all_of(study);
  ASSERT_EQ(block.ids.size(), 36U);
  for (const auto& row : rows_of(study, block)) {
    const double coupler = number(row.at("mechanism.coupler"));
    const double rocker = number(row.at("mechanism.rocker"));
    const double longest = std::max({2.0, coupler, rocker});
    const bool grashof = 1 + longest < 3 + coupler + rocker - 1 - longest;
    EXPECT_EQ(row.at("class") == Cell("crank-rocker"), grashof) << coupler << " " << rocker;
  }
}

// cos mu = (b^2 + c^2 - (d -+ a)^2) / 2bc at the crank's two positions in line with the frame.
TEST(StudyEvaluator, TransmissionAnglesFollowTheLawOfCosines) {
  const Study study =
      study_of(kFourBars + "[output]\nmetrics = [\"transmission_angle_deg.min\", " +
               "\"transmission_angle_deg.max\"]\n[filter]\nclass = " + "\"crank-rocker\"\n");
  const StudyBlock block = all_of(study);
  EXPECT_GT(block.ids.size(), 8U);
  EXPECT_EQ(block.filtered, 36 - static_cast<std::int64_t>(block.ids.size()));
  for (const auto& row : rows_of(study, block)) {
    const double b = number(row.at("mechanism.coupler")), c = number(row.at("mechanism.rocker"));
    const auto angle = [&](double diagonal) {
      return std::acos((b * b + c * c - diagonal * diagonal) / (2 * b * c)) * 180 / kPi;
    };
    EXPECT_NEAR(number(row.at("transmission_angle_deg.min")), angle(1), 1e-9);
    EXPECT_NEAR(number(row.at("transmission_angle_deg.max")), angle(3), 1e-9);
  }
}

// What a filter on varied keys lets pass is what the numbers say; the rest is not evaluated, but
// kept where all rows are requested.
TEST(StudyEvaluator, FiltersOnVariedKeysDecideFirst) {
  const std::string rest = "[filter]\n\"mechanism.coupler\" = [2, 3]\ntime_ratio = { max = 1.5 }\n";
  const Study some = study_of(kFourBars + "[output]\nmetrics = [\"time_ratio\"]\n" + rest);
  const Study all =
      study_of(kFourBars + "[output]\nmetrics = [\"time_ratio\"]\nrows = \"all\"\n" + rest);
  const StudyBlock passed = all_of(some), every = all_of(all);
  EXPECT_EQ(every.ids.size(), 36U);
  EXPECT_EQ(every.filtered, passed.filtered);
  EXPECT_EQ(every.filtered + std::ssize(passed.ids), 36);
  EXPECT_GT(passed.ids.size(), 0U);
  const auto rows = rows_of(all, every);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double coupler = number(rows[i].at("mechanism.coupler"));
    const bool in = coupler >= 2 && coupler <= 3;
    const Cell& ratio = rows[i].at("time_ratio");
    EXPECT_TRUE(in || ratio == Cell{});
    const bool passes = in && ratio != Cell{} && number(ratio) <= 1.5;
    EXPECT_EQ(every.statuses[i] == RunStatus::filtered, !passes);
    EXPECT_EQ(std::ranges::count(passed.ids, every.ids[i]), passes ? 1 : 0);
  }
}

// Rows of any two blocks are those of one.
TEST(StudyEvaluator, ADesignHangsOnItsNumberAlone) {
  const Study study = study_of(kFourBars + "[output]\nmetrics = [\"time_ratio\", \"class\"]\n");
  const StudyBlock whole = all_of(study);
  const auto evaluate = general_evaluator(study, 1, nullptr);
  const auto second = evaluate(20, 16), first = evaluate(0, 20);
  ASSERT_TRUE(first && second);
  auto cells = first->cells;
  cells.insert(cells.end(), second->cells.begin(), second->cells.end());
  EXPECT_EQ(cells, whole.cells);
  EXPECT_EQ(second->ids.front(), 20);
}

TEST(StudyEvaluator, AnInterruptGivesNothing) {
  const Study study = study_of(kFourBars + "[output]\nmetrics = [\"time_ratio\"]\n");
  const std::atomic<bool> interrupted = true;
  EXPECT_FALSE(general_evaluator(study, 1, &interrupted)(0, 4));
}

// A crank of length 0 is refused by the reader; of a linkage too short to close nothing is known.
TEST(StudyEvaluator, WhatIsNoMechanismHasAStatusAndNoMetrics) {
  const Study study = study_of(
      "base = \"analysis/crank-rocker.toml\"\n[[vary]]\nkey = \"mechanism.crank\"\nvalues = "
      "[1, 0, 100, -1]\n[output]\nmetrics = [\"time_ratio\", \"mechanism.rocker\"]\n");
  const StudyBlock block = all_of(study);
  EXPECT_EQ(block.statuses, (std::vector{RunStatus::solved, RunStatus::invalid,
                                         RunStatus::no_solution, RunStatus::invalid}));
  EXPECT_EQ(block.cells[2], Cell(2.5));
  for (const std::size_t row : {1U, 2U, 3U}) EXPECT_EQ(block.cells[3 * row + 1], Cell{});
}

// The stroke s, offset e and K of a slider-crank: the two dead centres see the stroke under
// pi (K - 1)/(K + 1) from the pivot, crank and coupler are half the difference and half the sum of
// their distances.
TEST(StudyEvaluator, QuickReturnsHaveTheirStrokeAndTimeRatio) {
  const Study study = study_of(R"(base = "quick-return/slider-crank.toml"
[[vary]]
key = "target.time_ratio"
range = [1.05, 1.4]
sampling = "sobol"
count = 12
[[vary]]
key = "mechanism.offset"
range = [10, 50]
sampling = "sobol"
count = 12
[output]
metrics = ["mechanism.crank", "mechanism.coupler", "stroke", "time_ratio", "defects"]
)");
  const StudyBlock block = all_of(study);
  ASSERT_EQ(block.ids.size(), 12U);
  for (const auto& row : rows_of(study, block)) {
    const double a = number(row.at("mechanism.crank")), b = number(row.at("mechanism.coupler"));
    const double e = number(row.at("mechanism.offset"));
    const double far = std::sqrt((b + a) * (b + a) - e * e);
    const double near = std::sqrt((b - a) * (b - a) - e * e);
    EXPECT_NEAR(far - near, 100, 1e-9);
    const double seen = std::acos(e / (a + b)) - std::acos(e / (b - a));
    const double ratio = (kPi + std::abs(seen)) / (kPi - std::abs(seen));
    EXPECT_NEAR(ratio, number(row.at("target.time_ratio")), 1e-9);
    EXPECT_NEAR(number(row.at("time_ratio")), ratio, 1e-9);
    EXPECT_EQ(word(row.at("defects")), "none");
  }
}

// A radial knife edge: tan of the pressure angle is s' / (r + s), its greatest by search.
TEST(StudyEvaluator, CamsHaveThePressureAngleOfTheirSize) {
  const Study study = study_of(R"(base = "cam/pressure-angle.toml"
[[vary]]
key = "mechanism.base_radius"
values = [25, 40, 80]
[output]
metrics = ["pressure_angle_deg_max_rise"]
)");
  for (const auto& row : rows_of(study, all_of(study))) {
    double greatest = 0;
    for (int i = 0; i <= 200'000; ++i) {
      const double u = i / 200'000.0;
      const double s = 10 * (1 - std::cos(kPi * u));
      const double ds = 20 * std::sin(kPi * u);  // per radian, over 90 degrees
      greatest = std::max(greatest, std::atan2(ds, number(row.at("mechanism.base_radius")) + s));
    }
    EXPECT_NEAR(number(row.at("pressure_angle_deg_max_rise")), greatest * 180 / kPi, 1e-6);
  }
}

// The row of a design is what solving its text gives.
TEST(StudyEvaluator, ARowIsWhatItsFileGives) {
  const Study study = study_of(R"(base = "function/three-angle-pairs.toml"
[[vary]]
key = "target.pairs_deg[1][1]"
range = [58, 62]
steps = 3
[output]
metrics = ["error.max_deg", "mechanism.coupler", "mechanism.fixed_pivots[1][0]", "class"]
)");
  const auto rows = rows_of(study, all_of(study));
  problems::DesignPoints points(study, 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<double> values(1);
    points.fill(static_cast<std::int64_t>(i), values);
    const auto problem = problems::parse_task(design_text(study, values));
    ASSERT_TRUE(problem);
    const auto result = solve(std::get<problems::FunctionProblem>(*problem), {.threads = 2});
    ASSERT_FALSE(result.designs.empty());
    const auto& linkage = *result.designs[0].mechanism.four_bar();
    EXPECT_EQ(rows[i].at("mechanism.coupler"), Cell(linkage.coupler));
    EXPECT_EQ(rows[i].at("mechanism.fixed_pivots[1][0]"), Cell(linkage.pivot_d.x));
    EXPECT_NEAR(number(rows[i].at("error.max_deg")), result.designs[0].error.max * 180 / kPi,
                1e-12);
  }
}

// Of forces only what is requested is computed: the reactions of a study are those of the analysis.
TEST(StudyEvaluator, ForcesAreComputedWhereTheyAreAskedFor) {
  const Study study = study_of(R"(base = "analysis/slider-crank-forces.toml"
[[vary]]
key = "drive.speed"
values = [1, 2]
[output]
metrics = ["torque_N_m.max", "torque_N_m.max_at_deg"]
)");
  const auto rows = rows_of(study, all_of(study));
  const auto base =
      problems::parse_task<problems::AnalysisProblem>(design_text(study, std::vector{2.0}));
  ASSERT_TRUE(base);
  const auto result = problems::analyse(*base, {.threads = 1});
  const auto quantity =
      std::ranges::find(result.quantities, "torque_N_m.max", &problems::Quantity::name);
  ASSERT_NE(quantity, result.quantities.end());
  // With the reactions the torque follows from these, without them from virtual work.
  const double torque = std::get<double>(quantity->value);
  EXPECT_NEAR(number(rows[1].at("torque_N_m.max")) / torque, 1, 1e-12);
}

TEST(StudyEvaluator, EveryStudyOfTheLibraryCanBeRun) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kLibrary / "study")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    const auto study = read_study(entry.path());
    ASSERT_TRUE(study) << study.error()[0].message;
    EXPECT_FALSE(study->title.empty());
    const auto block = study_evaluator(*study, 1, nullptr)(0, 2);
    ASSERT_TRUE(block);
    EXPECT_GE(block_size(*study), 1);
    ++count;
  }
  EXPECT_GE(count, 4);
}

// The names that a study may use are names that results have.
TEST(StudyMetrics, ReactionsAreNamedByTheirJoints) {
  const auto task = problems::read_task(kLibrary / "analysis" / "slider-crank-forces.toml");
  ASSERT_TRUE(task);
  const auto& problem = std::get<problems::AnalysisProblem>(*task);
  const auto names = study_metrics(*task).names;
  int reactions = 0;
  for (const auto& quantity : problems::analyse(problem, {.threads = 1}).quantities) {
    const auto found = std::ranges::find(names, quantity.name, &problems::MetricName::name);
    EXPECT_NE(found, names.end()) << quantity.name;
    if (found == names.end()) continue;
    EXPECT_EQ(found->word, !std::holds_alternative<double>(quantity.value)) << quantity.name;
    reactions += quantity.name.starts_with("reaction_max_N.") ? 1 : 0;
  }
  EXPECT_GE(reactions, 4);
}

TEST(StudyMetrics, EntriesOfSeveralKeysAreSpelledOut) {
  EXPECT_EQ(single_keys("a"), std::vector<std::string>{"a"});
  EXPECT_EQ(single_keys("x_a, x_b"), (std::vector<std::string>{"x_a", "x_b"}));
  EXPECT_EQ(single_keys("d_at_0_001, _at_0_01"),
            (std::vector<std::string>{"d_at_0_001", "d_at_0_01"}));
  EXPECT_EQ(single_keys("slide_1, slide_2, ...").back(), "slide_20");
}

TEST(DesignValues, AreFoundByTheirPlace) {
  const auto table = nlohmann::ordered_json::parse(
      R"({"a": {"b": [1, {"c": 2}], "t": true}, "l": ["x", "y"], "e": [], "n": null})");
  EXPECT_EQ(value_at(table, "a.b[0]"), Cell(1.0));
  EXPECT_EQ(value_at(table, "a.b[1].c"), Cell(2.0));
  EXPECT_EQ(value_at(table, "a.t"), Cell("true"));
  EXPECT_EQ(value_at(table, "l"), Cell("x,y"));
  EXPECT_EQ(value_at(table, "e"), Cell("none"));
  for (const char* nothing : {"n", "a", "a.b", "a.b[2]", "a.b[x]", "a.b[", "b", "a.bb", ""}) {
    EXPECT_EQ(value_at(table, nothing), Cell{}) << nothing;
  }
}

}  // namespace
}  // namespace cognate::app::study_evaluator_test
