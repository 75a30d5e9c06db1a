// Every mechanism of the library, drawn as it stands where its drive begins and read again by its
// joints alone, moves as before and needs the same torque.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "problems/evaluation/as_drawn.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "problems/toml/table_reader.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::drawn_mechanism_test {
namespace {

const std::filesystem::path kLibrary = std::filesystem::path(kLibraryFolder) / "analysis";

/// Those that no link of the frame drives, or that begin at a dead point.
const std::map<std::string, std::string> kUndrawn = {{"elliptic-trammel", "is driven by no link"},
                                                     {"dump-body", "is driven by no link"},
                                                     {"excavator-bucket", "is driven by no link"}};

AnalysisProblem read_again(const reading::Table& document) {
  reading::FaultList faults;
  reading::TableReader reader(document, faults);
  reader.know({"kind", "title", "length_unit"});
  AnalysisProblem problem = KindTraits<AnalysisProblem>::read(reader, {});
  reader.finish();
  for (const Fault& fault : std::move(faults).sorted()) ADD_FAILURE() << fault.message;
  return problem;
}

constexpr std::string_view kTorque = "torque";

/// The columns that both have, but for those in the axes of a body, which may be others.
void expect_same_motion(const AnalysisProblem& given, const AnalysisProblem& drawn) {
  AnalysisProblem plain = given;
  plain.output = drawn.output;
  const AnalysisResult first = analyse(plain, Run{.threads = 1});
  const AnalysisResult second = analyse(drawn, Run{.threads = 1});
  ASSERT_EQ(first.closed_rows, second.closed_rows);
  int compared = 0;
  for (const Column& column : first.columns) {
    const bool global = column.name.ends_with("_x") || column.name.ends_with("_y") ||
                        column.name.ends_with("_vx") || column.name.ends_with("_ay") ||
                        column.name.starts_with(kTorque);
    const auto same = std::ranges::find(second.columns, column.name, &Column::name);
    if (!global || same == second.columns.end()) continue;
    ++compared;
    double size = 0;
    for (const double value : column.values) size = std::fmax(size, std::abs(value));
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      const double value = column.values[row];
      if (!std::isfinite(value) || std::abs(value) > 1e3 * size) continue;
      EXPECT_NEAR(value, same->values[row], 1e-7 * size + 1e-9) << column.name << ", " << row;
    }
  }
  EXPECT_GE(compared, 2);
  const bool has_torque = std::ranges::any_of(
      first.columns, [](const Column& column) { return column.name.starts_with(kTorque); });
  EXPECT_EQ(has_torque, has_forces(given));
}

TEST(DrawnMechanismTest, OfTheLibraryMoveAsThoseOfDimensions) {
  int drawn_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kLibrary)) {
    const auto problem = read_task<AnalysisProblem>(entry.path());
    ASSERT_TRUE(problem) << entry.path();
    const auto document = written_as_drawn(*problem);
    SCOPED_TRACE(entry.path().stem());
    if (const auto undrawn = kUndrawn.find(entry.path().stem().string());
        undrawn != kUndrawn.end()) {
      ASSERT_FALSE(document);
      EXPECT_NE(document.error().find(undrawn->second), std::string::npos) << document.error();
      continue;
    }
    ASSERT_TRUE(document) << document.error();
    expect_same_motion(*problem, read_again(*document));
    ++drawn_files;
  }
  EXPECT_GE(drawn_files, 20);
}

}  // namespace
}  // namespace cognate::problems::drawn_mechanism_test
