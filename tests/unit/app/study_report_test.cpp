// What the report of a study embeds: every value of its rows, safely.
#include "app/report/study_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/browser/sample_studies.hpp"

namespace cognate::app::study_report_test {
namespace {

using nlohmann::ordered_json;
using problems::Cell;

const SampleStudy& sample(const std::string& name) {
  static const std::vector<SampleStudy> all = sample_studies();
  return *std::ranges::find(all, name, &SampleStudy::name);
}

/// The value of a column in a drawn row, from either form that columns are written in.
ordered_json value(const ordered_json& column, std::size_t row) {
  if (column.contains("values")) return column["values"][row];
  const int index = column["index"][row];
  return index < 0 ? ordered_json() : column["levels"][static_cast<std::size_t>(index)];
}

void expect_cell(const ordered_json& written, const Cell& cell, bool exact) {
  if (const auto* number = std::get_if<double>(&cell)) {
    ASSERT_TRUE(written.is_number());
    const double error = std::abs(written.get<double>() - *number);
    EXPECT_LE(error, exact ? 0 : 5e-9 * std::abs(*number));
  } else if (const auto* word = std::get_if<std::string>(&cell)) {
    EXPECT_EQ(written, *word);
  } else {
    EXPECT_TRUE(written.is_null());
  }
}

class EachSample : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Studies, EachSample,
                         ::testing::Values("grid", "sobol", "atlas", "hostile", "empty"));

TEST_P(EachSample, ColumnsHoldTheCellsOfTheRows) {
  const auto& [name, study, rows, document] = sample(GetParam());
  const ordered_json data = study_report_data(study, rows);
  const std::size_t width = rows.columns.size();
  ASSERT_EQ(data["columns"].size(), width);
  ASSERT_EQ(data["ids"].size(), rows.ids.size());
  for (std::size_t row = 0; row < rows.ids.size(); ++row) {
    EXPECT_EQ(data["ids"][row], rows.ids[row]);
    for (std::size_t i = 0; i < width; ++i) {
      const bool varied = data["columns"][i]["role"] == "variable";
      expect_cell(value(data["columns"][i], row), rows.cells[row * width + i], varied);
    }
  }
}

TEST_P(EachSample, ThePageCanNeitherBeBrokenOutOfNorTooLarge) {
  const auto& [name, study, rows, document] = sample(GetParam());
  const std::string page = study_report_html(document, study, rows);
  EXPECT_LT(page.size(), 1'600'000U);
  EXPECT_EQ(page.find("<script>document.title"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("@DATA@"), std::string::npos);
}

StudyRows wide_rows(std::size_t count, std::size_t columns) {
  StudyRows rows;
  for (std::size_t i = 0; i < columns; ++i) rows.columns.push_back("c" + std::to_string(i));
  for (std::size_t i = 0; i < count; ++i) {
    rows.ids.push_back(static_cast<std::int64_t>(i));
    rows.statuses.push_back(problems::RunStatus::solved);
    rows.best.push_back(i % 100 == 99);
    for (std::size_t k = 0; k < columns; ++k) rows.cells.emplace_back(std::sqrt(double(i + k)));
  }
  rows.total = static_cast<std::int64_t>(count);
  return rows;
}

TEST(DrawnStudyRows, OfManyTheBestAndAnEvenSelectionRemain) {
  const StudyRows rows = wide_rows(20'000, 40);
  const auto drawn = drawn_study_rows(rows);
  EXPECT_EQ(drawn.size(), 2000U);
  EXPECT_TRUE(std::ranges::is_sorted(drawn));
  EXPECT_EQ(std::ranges::adjacent_find(drawn), drawn.end());
  EXPECT_EQ(std::ranges::count_if(drawn, [&](std::size_t i) { return rows.best[i]; }), 200);
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i) EXPECT_LE(drawn[i + 1] - drawn[i], 15U);
}

TEST(DrawnStudyRows, FewAreAllDrawn) {
  EXPECT_EQ(drawn_study_rows(wide_rows(1234, 3)).size(), 1234U);
  EXPECT_EQ(drawn_study_rows(wide_rows(9000, 1)).size(), 5000U);
}

TEST(StudyReportData, WhatIsNotFiniteIsNull) {
  StudyRows rows = wide_rows(3, 2);
  rows.cells[0] = std::numeric_limits<double>::quiet_NaN();
  rows.cells[1] = std::numeric_limits<double>::infinity();
  rows.cells[2] = std::monostate();
  rows.cells[4] = std::string("double-crank");
  const ordered_json columns = study_report_data({}, rows)["columns"];
  EXPECT_TRUE(value(columns[0], 0).is_null());
  EXPECT_TRUE(value(columns[1], 0).is_null());
  EXPECT_TRUE(value(columns[0], 1).is_null());
  EXPECT_EQ(value(columns[0], 2), "double-crank");
}

TEST(StudyReportData, LargeTextsAreLeftOut) {
  problems::Study study;
  study.base_text = "# " + std::string(300'000, 'x');
  EXPECT_FALSE(study_report_data(study, wide_rows(3, 2)).contains("base"));
  ordered_json document = {{"best", std::vector<std::string>(1000, std::string(1000, 'y'))}};
  EXPECT_EQ(study_report_html(document, study, wide_rows(3, 2)).find("yyy"), std::string::npos);
}

TEST(StudyLinkage, VariedDimensionsAreNamedOthersKept) {
  const auto linkage = study_linkage(sample("sobol").study);
  ASSERT_TRUE(linkage);
  const ordered_json expected = {{"fixed_pivots", {{0.0, 0.0}, {100.0, 0.0}}},
                                 {"crank", {{"variable", 0}}},
                                 {"coupler", {{"variable", 1}}},
                                 {"rocker", {{"variable", 2}}},
                                 {"assembly", "open"},
                                 {"coupler_point", {{{"variable", 3}}, {{"variable", 4}}}},
                                 {"start", 0.0}};
  EXPECT_EQ(*linkage, expected);
  EXPECT_FALSE(study_linkage(sample("hostile").study));
}

}  // namespace
}  // namespace cognate::app::study_report_test
