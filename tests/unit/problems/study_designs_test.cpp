// The numbers of a study's designs, and the base file with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "problems/study/base.hpp"
#include "problems/study/design_points.hpp"
#include "problems/study/design_text.hpp"
#include "problems/study/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::study_designs_test {
namespace {

StudyVariable grid(std::string key, std::vector<double> values) {
  StudyVariable variable;
  variable.path = {key};
  variable.key = std::move(key);
  variable.values = std::move(values);
  return variable;
}

StudyVariable sampled(std::string key, Range range, bool logarithmic = false) {
  StudyVariable variable;
  variable.path = {key};
  variable.key = std::move(key);
  variable.range = range;
  variable.logarithmic = logarithmic;
  return variable;
}

std::vector<double> designs(const Study& study, std::int64_t first, std::int64_t count) {
  std::vector<double> values(static_cast<std::size_t>(count) * study.variables.size());
  DesignPoints(study, 1).fill(first, values);
  return values;
}

TEST(DesignPoints, TheLastVariableOfTheGridIsFastest) {
  Study study;
  study.variables = {grid("a", {1, 2, 3}), grid("b", {10, 20}), grid("c", {7, 8, 9})};
  std::vector<double> expected;
  for (const double a : {1, 2, 3}) {
    for (const double b : {10, 20}) {
      for (const double c : {7, 8, 9}) expected.insert(expected.end(), {a, b, c});
    }
  }
  EXPECT_EQ(design_count(study), 18);
  EXPECT_EQ(designs(study, 0, 18), expected);
}

TEST(DesignPoints, EveryPointOfTheGridHasAllSamples) {
  Study study;
  study.sampling = Sampling::latin;
  study.samples = 5;
  study.variables = {sampled("x", {2, 4}), grid("a", {1, 2, 3}), sampled("y", {-1, 1})};
  const auto all = designs(study, 0, design_count(study));
  std::vector<double> unit(10);
  latin_points(2, 5, 1)(0, unit);
  for (std::size_t i = 0; i < 15; ++i) {
    const std::size_t point = i / 5;
    EXPECT_EQ(all[3 * i + 1], static_cast<double>(point + 1));
    EXPECT_DOUBLE_EQ(all[3 * i], 2 + 2 * unit[2 * (i % 5)]);
    EXPECT_DOUBLE_EQ(all[3 * i + 2], -1 + 2 * unit[2 * (i % 5) + 1]);
  }
}

TEST(DesignPoints, ABlockIsAPartOfTheWhole) {
  Study study;
  study.samples = 7;
  study.variables = {grid("a", {1, 2, 3}), sampled("x", {2, 4}), sampled("y", {1e-3, 1e3}, true)};
  const auto all = designs(study, 0, 21);
  int tested = 0;
  for (std::int64_t first = 0; first < 21; ++first) {
    for (const std::int64_t count : {std::int64_t{1}, std::int64_t{9}, 21 - first}) {
      if (first + count > 21) continue;
      const auto some = designs(study, first, count);
      EXPECT_TRUE(std::equal(some.begin(), some.end(),
                             all.begin() + static_cast<std::ptrdiff_t>(3 * first)));
      ++tested;
    }
  }
  EXPECT_EQ(tested, 21 + 13 + 21);
}

TEST(DesignPoints, ALogarithmicRangeHasStepsOfEqualRatio) {
  const Range range{0.5, 32};
  for (int i = 0; i <= 6; ++i) {
    EXPECT_NEAR(place_in(range, i / 6.0, true), 0.5 * std::pow(2, i), 1e-13 * std::pow(2, i));
  }
  EXPECT_EQ(place_in(range, 0, true), 0.5);
  EXPECT_EQ(place_in(range, 1, true), 32);
  EXPECT_EQ(place_in({0.1, 0.7}, 1, false), 0.7);
}

// Half of the samples of a logarithmic range lie below its geometric mean.
TEST(DesignPoints, SamplesOfALogarithmicRangeAreEvenInTheLogarithm) {
  Study study;
  study.samples = 1024;
  study.variables = {sampled("x", {1e-4, 1}, true)};
  const auto all = designs(study, 0, 1024);
  EXPECT_EQ(std::ranges::count_if(all, [](double x) { return x < 1e-2; }), 512);
}

// Numbers in every way that TOML has, behind letters of several bytes, in every kind of table.
const std::string kText =
    "\xef\xbb\xbf"
    "# Kommentar mit \xc3\xa4 und \xe2\x86\x92\r\n"
    "kind = \"analysis\"   # 1.0\r\n"
    "title = '\xc3\xbc 2.5 = \\'\r\n"
    "[mechanism]\r\n"
    "type = \"four-bar\"\r\n"
    "fixed_pivots = [[0, +0.0e0], [ 0x2_0 ,1_0.25 ]]\r\n"
    "crank = 1_0\r\n"
    "coupler = 3.5e1 # [4]\r\n"
    "rocker = 25.0\r\n"
    "coupler_point = [\r\n  1, # \xc3\xa4\r\n\t-2.5\r\n]\r\n"
    "[drive]\r\n"
    "speed = 2\r\n"
    "steps = 12\r\n";

/// A study of `text` in which `keys` vary.
Study study_of(const std::string& text, const std::vector<std::pair<std::string, KeyPath>>& keys) {
  Study study;
  study.base_text = text;
  for (const auto& [key, path] : keys) {
    StudyVariable variable;
    variable.key = key;
    variable.path = path;
    study.variables.push_back(variable);
  }
  return study;
}

Study every_number() {
  return study_of(kText, {{"drive.steps", {"drive", "steps"}},
                          {"x", {"mechanism", "fixed_pivots", std::size_t{1}, std::size_t{0}}},
                          {"y", {"mechanism", "fixed_pivots", std::size_t{1}, std::size_t{1}}},
                          {"y0", {"mechanism", "fixed_pivots", std::size_t{0}, std::size_t{1}}},
                          {"crank", {"mechanism", "crank"}},
                          {"coupler", {"mechanism", "coupler"}},
                          {"v", {"mechanism", "coupler_point", std::size_t{1}}},
                          {"rocker", {"mechanism", "rocker"}}});
}

TEST(DesignText, LeavesEverythingElseAsItWas) {
  const auto gaps = gapped_base(every_number());
  ASSERT_EQ(gaps.pieces.size(), 9U);
  const std::vector<std::string> taken = {"+0.0e0", "0x2_0", "1_0.25", "1_0",
                                          "3.5e1",  "25.0",  "-2.5",   "12"};
  std::string text = gaps.pieces[0];
  for (std::size_t i = 0; i < taken.size(); ++i) text += taken[i] + gaps.pieces[i + 1];
  EXPECT_EQ(text, kText);
  EXPECT_EQ(gaps.variable, (std::vector<std::size_t>{3, 1, 2, 4, 5, 7, 6, 0}));
}

TEST(DesignText, AByteOrderMarkHasNoColumn) {
  const Study study = study_of(
      "\xef\xbb\xbf"
      "gravity = [1.5, -9.8]\n",
      {{"g", {"gravity", std::size_t{1}}}});
  EXPECT_EQ(design_text(study, std::vector{2.0}),
            "\xef\xbb\xbf"
            "gravity = [1.5, 2.0]\n");
}

TEST(DesignText, AnExpressionIsReplacedWithItsQuotationMarks) {
  for (const char* written : {"\"7/8\"", "'7/8'", "\"\"\"7/8\"\"\"", "\"7\\u002F8\""}) {
    const std::string before = "gravity = [1, ", behind = "]  # \"down\"\n";
    const Study study = study_of(before + written + behind, {{"g", {"gravity", std::size_t{1}}}});
    EXPECT_EQ(design_text(study, std::vector{2.5}), before + "2.5" + behind);
  }
}

TEST(DesignText, ReadsBackAsTheSameDoubles) {
  const Study study = every_number();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> around(20, 30);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> values = {7};
    while (values.size() < 8) values.push_back(around(random));
    if (i % 3 == 0) values[4] = 21;
    const auto read = parse_task<AnalysisProblem>(design_text(study, values));
    ASSERT_TRUE(read) << design_text(study, values) << read.error()[0].message;
    const FourBar& linkage = *read->mechanism.four_bar();
    EXPECT_EQ(read->drive.steps, 7);
    EXPECT_EQ(linkage.pivot_d.x, values[1]);
    EXPECT_EQ(linkage.pivot_d.y, values[2]);
    EXPECT_EQ(linkage.pivot_a.y, values[3]);
    EXPECT_EQ(linkage.crank, values[4]);
    EXPECT_EQ(linkage.coupler, values[5]);
    EXPECT_EQ(linkage.coupler_point->y, values[6]);
    EXPECT_EQ(linkage.rocker, values[7]);
  }
}

TEST(StudyBase, IsTheTextWithTheNumbersRead) {
  const Study study = every_number();
  StudyBase base(study);
  int accepted = 0;
  for (const double length : {22.0, 25.125, 1e22, 0.1}) {
    const std::vector<double> values = {12, 20, 1, 0, length, 30, -4.5, 26};
    const auto direct = base.with(values);
    const auto read = parse_task(design_text(study, values));
    ASSERT_EQ(direct.has_value(), read.has_value());
    if (!read) continue;
    ++accepted;
    EXPECT_EQ(std::get<AnalysisProblem>(*direct).mechanism.four_bar()->crank, length);
    EXPECT_EQ(std::get<AnalysisProblem>(*read).mechanism.four_bar()->crank, length);
  }
  EXPECT_GE(accepted, 2);
}

TEST(StudyBase, RefusesWhatTheFileWouldBeRefusedFor) {
  const Study study = study_of(kText, {{"steps", {"drive", "steps"}}});
  StudyBase base(study);
  for (const double steps : {12.5, 0.0, -3.0}) {
    const auto task = base.with(std::vector{steps});
    ASSERT_FALSE(task);
    EXPECT_NE(task.error()[0].message.find("drive.steps"), std::string::npos);
    EXPECT_FALSE(parse_task(design_text(study, std::vector{steps})));
  }
  EXPECT_TRUE(base.with(std::vector{13.0}));
}

// The study is read where the drawing is, and its designs where there is none.
TEST(StudyBase, HoldsTheDrawingThatItsBaseNames) {
  const auto library = std::filesystem::path(kLibraryFolder) / "path";
  auto study = parse_study(
      "base = \"bean.toml\"\n[[vary]]\nkey = \"target.samples\"\nvalues = [40, 80]\n"
      "[output]\nmetrics = [\"error.rms\"]\n",
      library, [](const Task&) {
        return MetricNames{{{"error.rms"}}, {}};
      });
  ASSERT_TRUE(study) << study.error()[0].message;
  EXPECT_TRUE(study->drawing.starts_with("M")) << study->drawing;
  study->folder = "/nowhere";
  const auto task = StudyBase(*study).with(std::vector{40.0});
  ASSERT_TRUE(task) << task.error()[0].message;
  const auto& held = std::get<PathProblem>(*task);
  const auto direct = read_task(library / "bean.toml");
  ASSERT_TRUE(direct);
  const auto& drawn = std::get<PathProblem>(*direct);
  EXPECT_EQ(held.curve->curve.length(), drawn.curve->curve.length());
  EXPECT_EQ(held.points.size(), 40U);
}

}  // namespace
}  // namespace cognate::problems::study_designs_test
