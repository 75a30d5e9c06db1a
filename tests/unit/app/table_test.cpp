#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/kinds/kinds.hpp"
#include "tests/support/planted_result.hpp"

namespace cognate::app::table_test {
namespace {

using problems::planted_path;
using problems::planted_result;
using problems::Status;
using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

[[nodiscard]] AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return AssertionSuccess();
  return AssertionFailure() << '\'' << part << "' is not in:\n" << text;
}

template <class Problem>
std::string design_table(const Problem& problem, const problems::Result& result,
                         const Screen& screen) {
  return Kind<Problem>::table(problem, result, screen);
}

TEST(WrittenValue, NeverPrintsInfOrNan) {
  const WrittenValue written;
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "unbounded");
  EXPECT_EQ(written(-std::numeric_limits<double>::infinity()), "unbounded");
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "not defined");
  EXPECT_EQ(written(0.25), "0.25");
}

TEST(TextTable, AlignsColumnsByWhatIsSeen) {
  const auto lines = set_columns({{"#", Align::right, {"1", "10"}},
                                  {"range", Align::left, {"1…2", "wide one"}},
                                  {"x", Align::right, {"–", "1.5"}},
                                  {"last", Align::left, {"a", ""}}});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], " #  range       x  last");
  EXPECT_EQ(lines[1], " 1  1…2         –  a");
  EXPECT_EQ(lines[2], "10  wide one  1.5");
}

TEST(TextTable, SetsUnitsBelowHeadings) {
  const auto lines = set_columns({{"#", Align::right, {"1", "2"}},
                                  {"rms [deg]", Align::right, {"0.5", "12.25"}},
                                  {"kind [x]y", Align::left, {"a", "b"}}});
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "#    rms  kind [x]y");
  EXPECT_EQ(lines[1], "   [deg]");
  EXPECT_EQ(lines[2], "1    0.5  a");
  EXPECT_EQ(lines[3], "2  12.25  b");
}

TEST(TextTable, BreaksIntoBlocksThatBeginWithTheFirstColumn) {
  const std::vector<Column> columns = {{"#", Align::right, {"1"}},
                                       {"first [mm]", Align::right, {"1.5"}},
                                       {"second", Align::right, {"2.5"}},
                                       {"a very wide one", Align::left, {"x"}}};
  EXPECT_EQ(table_text(columns, {.width = 18}),
            "\n#  first  second\n    [mm]\n1    1.5     2.5\n"
            "\n#  a very wide one\n1  x\n");
  EXPECT_EQ(table_text(columns, {.width = 5}),
            "\n#  first\n    [mm]\n1    1.5\n\n#  second\n1     2.5\n"
            "\n#  a very wide one\n1  x\n");
  const auto whole = table_text(columns, {});
  EXPECT_EQ(std::ranges::count(whole, '\n'), 4);
}

TEST(TextTable, BreaksLongLinesBetweenWords) {
  EXPECT_EQ(fitted("note: one two three\nshort\n", {.width = 13}),
            "note: one two\n      three\nshort\n");
  EXPECT_EQ(fitted("  in by two columns\n", {.width = 12}), "  in by two\n    columns\n");
  EXPECT_EQ(fitted("  key  of two words\n", {.width = 15}), "  key  of two\n       words\n");
  EXPECT_EQ(fitted("  a very long key  and meaning\n", {.width = 24}),
            "  a very long key  and\n    meaning\n");
  EXPECT_EQ(fitted("六个点 六个点\n", {.width = 12}), "六个点\n  六个点\n");
  EXPECT_EQ(fitted("六个点 六个点\n", {.width = 13}), "六个点 六个点\n");
  EXPECT_EQ(fitted("\x1b[31mred and\x1b[0m white\n", {.width = 13}),
            "\x1b[31mred and\x1b[0m white\n");
  EXPECT_EQ(fitted("unbreakable\n", {.width = 5}), "unbreakable\n");
  EXPECT_EQ(fitted("as long as it is\n", {}), "as long as it is\n");
}

TEST(TextTable, CountsColumnsNotBytes) {
  EXPECT_EQ(display_width("六个点，线"), 10u);
  EXPECT_EQ(display_width("e\u0301te\u0301"), 3u);  // accents that combine
  EXPECT_EQ(display_width("\xff\xfe"), 2u);         // no UTF-8
  EXPECT_EQ(display_width("\x1b[31mred\x1b[0m"), 3u);
  EXPECT_EQ(display_width("abc"), 3u);
  EXPECT_EQ(display_width("30.0…45.0"), 9u);
  EXPECT_EQ(display_width(""), 0u);
}

TEST(Table, ShowsEachDesignAndWhatItMisses) {
  const auto text = design_table(planted_path(), planted_result(), {});
  EXPECT_TRUE(contains(text, "Planted path: path generation, 3 points, free timing\n"));
  EXPECT_TRUE(contains(text, "solved: 2 designs; 1 meets every constraint\n"));
  EXPECT_TRUE(std::regex_search(text, std::regex("\n# +rms +max +class")));
  EXPECT_TRUE(contains(text, "  [length]  [length]  "));
  EXPECT_TRUE(contains(text, "0.0625"));
  EXPECT_TRUE(contains(text, "rocker-crank (change point)"));
  EXPECT_TRUE(contains(text, "30.0…135.0"));
  EXPECT_TRUE(contains(text, "branch, order"));
  EXPECT_TRUE(contains(text, "exact:three-pairs + ceres, cognate of 1"));
  EXPECT_TRUE(
      contains(text,
               "design 2 violates link_ratio_max, the longest over shortest link: 7.5; allowed: at "
               "most 5\n"));
  EXPECT_TRUE(contains(text, "design 2 violates class: rocker-crank; allowed: crank-rocker\n"));
  EXPECT_FALSE(contains(text, "violates bounds.rocker"));
  EXPECT_FALSE(contains(text, "design 1 violates"));
  EXPECT_TRUE(contains(text, "note: A note.\n"));
  EXPECT_FALSE(contains(text, "warning"));
  EXPECT_TRUE(contains(text, "0.5 s on 2 threads, 11 candidates screened\n"));
}

TEST(Table, SaysWhatNobodyWouldBuildAndInWhatTwinsDiffer) {
  auto result = planted_result();
  result.warnings = {"Design 2: odd."};
  result.designs[1].cognate_of.reset();
  result.designs[1].twin_of = 0;
  result.designs[1].differs = {"assembly", "direction"};
  const auto text = design_table(planted_path(), result, {});
  EXPECT_TRUE(contains(text, "warning: Design 2: odd.\n"));
  EXPECT_TRUE(contains(text, ", links of 1, other assembly, direction"));
}

TEST(Table, CallsRoundingExact) {
  auto result = planted_result();
  result.designs[0].error = {1e-30, 1e-15, 3e-11};
  const auto text = design_table(planted_path(), result, {});
  EXPECT_TRUE(std::regex_search(text, std::regex("\n1 +exact \\(to rounding\\) +3e-11 "))) << text;
}

TEST(Table, SaysWhatIsProved) {
  auto result = planted_result();
  result.certificate = {0.5, 0.625, 0.2, true, 12345, "all there are"};
  const std::string proved = design_table(planted_path(), result, {});
  EXPECT_TRUE(contains(
      proved, "certified: sum of squares 0.625 is within 20 % of the minimum, at least 0.5,"));
  EXPECT_TRUE(contains(proved, "among all there are (12345 boxes)"));
  result.certificate->complete = false;
  const std::string open = design_table(planted_path(), result, {});
  EXPECT_TRUE(contains(open, "not certified in the time given"));
  EXPECT_TRUE(contains(open, "at least 0.5 (gap 20 %)"));
}

TEST(Table, GivesFunctionErrorsInDegrees) {
  problems::FunctionProblem problem;
  problem.target = problems::AnglePairs{{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.7}};
  auto result = planted_result();
  result.designs[0].error.rms = 3 * kPi / 180;
  const auto text = design_table(problem, result, {});
  EXPECT_TRUE(std::regex_search(text, std::regex("\n +\\[deg\\] +\\[deg\\]"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n1 +3 +"))) << text;
}

TEST(Table, SaysTypeAndDimensionsOfMixedMechanisms) {
  const auto text = design_table(problems::planted_motion(), problems::planted_synthesis(), {});
  EXPECT_TRUE(contains(text, "Planted motion: motion generation, 3 poses\n"));
  EXPECT_TRUE(contains(text, "complex solutions: 1442; real triplets: 21\n"));
  EXPECT_TRUE(contains(text, "slider-crank  crank 0.5, coupler 2.5, offset -0.125 "));
  EXPECT_TRUE(contains(text, "four-bar      crank 1.1, coupler 0.285714, rocker 4e-17, frame "));
  EXPECT_TRUE(contains(text, "crank turns fully"));
  EXPECT_TRUE(contains(text, "exact (to rounding)"));
  EXPECT_FALSE(contains(text, "2e-16"));
  EXPECT_TRUE(contains(text, "exact:three-poses, mirror image of 1"));
  EXPECT_TRUE(contains(text, "0.25 s on 1 thread\n"));
}

TEST(Table, GivesColumnsToTheDimensionsOfOneType) {
  auto result = problems::planted_synthesis();
  result.designs.erase(result.designs.begin());
  const auto text = design_table(problems::planted_motion(), result, {});
  EXPECT_TRUE(std::regex_search(text, std::regex("mechanism +crank +coupler +offset")));
  EXPECT_TRUE(std::regex_search(text, std::regex("slider-crank +0.5 +2.5 +-0.125"))) << text;
  EXPECT_FALSE(contains(text, "time ratio"));
}

TEST(Table, PrintsTheFirstOfVeryManyDesigns) {
  auto result = planted_result();
  result.designs.assign(45, result.designs.back());
  const auto text = design_table(planted_path(), result, {});
  EXPECT_TRUE(contains(text, "45 designs"));
  EXPECT_TRUE(contains(text, "and 25 more, which the result file and the report hold\n"));
  EXPECT_TRUE(contains(text, "designs 1 to 20 violate class: rocker-crank; allowed: crank-rocker"));
}

TEST(Table, GivesQuickReturnsNoErrors) {
  problems::QuickReturnProblem problem;
  EXPECT_FALSE(contains(design_table(problem, planted_result(), {}), "rms"));
}

TEST(Table, NamesEachWayToEnd) {
  auto result = planted_result();
  const auto line = [&](Status status) {
    result.status = status;
    return design_table(planted_path(), result, {});
  };
  EXPECT_TRUE(contains(line(Status::interrupted), "interrupted: 2 designs"));
  EXPECT_TRUE(contains(line(Status::time_limit), "stopped at the time limit: 2 designs"));
  EXPECT_TRUE(contains(line(Status::infeasible), "no design satisfies every constraint"));
  result.designs.clear();
  EXPECT_TRUE(contains(line(Status::no_solution), "no solution: no design found"));
}

TEST(Table, ColoursChangeNothingElse) {
  const auto plain = design_table(planted_path(), planted_result(), {});
  const auto coloured = design_table(planted_path(), planted_result(), {.colour = true});
  EXPECT_EQ(plain.find('\x1b'), std::string::npos);
  EXPECT_NE(coloured, plain);
  EXPECT_EQ(std::regex_replace(coloured, std::regex("\x1b\\[[0-9]+m"), ""), plain);
}

TEST(Table, LetsNoControlCharacterThrough) {
  auto problem = planted_path();
  problem.title = "bell\a and \x1b[31mred";
  auto result = planted_result();
  result.notes = {"two\nlines"};
  const auto text = design_table(problem, result, {});
  EXPECT_TRUE(contains(text, "bell? and ?[31mred"));
  EXPECT_TRUE(contains(text, "two?lines"));
}

}  // namespace
}  // namespace cognate::app::table_test
