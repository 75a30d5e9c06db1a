// Study files: what they say, and every way in which they can be wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "problems/study/key_path.hpp"
#include "problems/study/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::study_file_test {
namespace {

const std::filesystem::path kLibrary = kLibraryFolder;

/// Metrics made up for the test: two numbers, a word, and lists of what only a design has.
MetricNames names(const Task&) {
  return {{{"time_ratio"}, {"angle_deg.min"}, {"class", true}}, {"mechanism.dyad"}};
}

tl::expected<Study, std::vector<Fault>> parse(const std::string& text) {
  return parse_study(text, kLibrary, names);
}

const std::string kHead = "base = \"analysis/crank-rocker.toml\"\n";
const std::string kVary = "[[vary]]\nkey = \"mechanism.coupler\"\nrange = [2, 3]\nsteps = 5\n";
const std::string kOutput = "[output]\nmetrics = [\"time_ratio\"]\n";

Study study(const std::string& text) {
  const auto read = parse(text);
  EXPECT_TRUE(read) << (read ? "" : read.error()[0].message);
  return read.value_or(Study{});
}

TEST(StudyFile, SaysWhatVariesAndWhatIsWanted) {
  const Study read = study(R"(kind = "study"
title = "T"
base = "analysis/crank-rocker.toml"
[[vary]]
key = "mechanism.coupler"
range = [2, 3]
steps = 5
[[vary]]
key = "mechanism.fixed_pivots[1][0]"
values = [1, 2.5]
[[vary]]
key = "mechanism.rocker"
range = [1, 100]
scale = "log"
sampling = "halton"
count = 12
[[vary]]
key = "mechanism.crank"
range = [0.5, 1]
sampling = "halton"
count = 12
[output]
metrics = ["time_ratio", "mechanism.dyad[0].lengths[1]"]
rows = "all"
[filter]
"angle_deg.min" = [30, inf]
time_ratio = { max = 2 }
class = ["crank-rocker", "double-crank"]
mechanism.coupler = { min = 2.25, max = 2.75 }
[objective]
minimize = ["time_ratio", "mechanism.rocker"]
maximize = "angle_deg.min"
)");
  EXPECT_EQ(read.title, "T");
  ASSERT_EQ(read.variables.size(), 4U);
  EXPECT_EQ(read.variables[0].values, (std::vector<double>{2, 2.25, 2.5, 2.75, 3}));
  EXPECT_EQ(read.variables[1].values, (std::vector<double>{1, 2.5}));
  const KeyPath pivot = {"mechanism", "fixed_pivots", std::size_t{1}, std::size_t{0}};
  EXPECT_EQ(read.variables[1].path, pivot);
  EXPECT_TRUE(read.variables[2].logarithmic);
  EXPECT_EQ(read.variables[2].range->max, 100);
  EXPECT_EQ(read.sampling, Sampling::halton);
  EXPECT_EQ(design_count(read), 5 * 2 * 12);
  EXPECT_TRUE(read.keep_all);
  EXPECT_EQ(study_columns(read),
            (std::vector<std::string>{"mechanism.coupler", "mechanism.fixed_pivots[1][0]",
                                      "mechanism.rocker", "mechanism.crank", "time_ratio",
                                      "mechanism.dyad[0].lengths[1]", "angle_deg.min"}));
  ASSERT_EQ(read.filters.size(), 4U);
  EXPECT_EQ(read.filters[0].min, 30);
  EXPECT_TRUE(std::isinf(read.filters[0].max));
  EXPECT_EQ(read.filters[1].max, 2);
  EXPECT_EQ(read.filters[2].words, (std::vector<std::string>{"crank-rocker", "double-crank"}));
  EXPECT_EQ(read.filters[3].name, "mechanism.coupler");
  ASSERT_EQ(read.objectives.size(), 3U);
  EXPECT_FALSE(read.objectives[0].greatest);
  EXPECT_TRUE(read.objectives[2].greatest);
}

TEST(StudyFile, ADottedKeyFiltersAsOneInQuotationMarks) {
  const Study read = study(kHead + kVary + kOutput + "[filter]\nangle_deg.min = { min = 3 }\n");
  ASSERT_EQ(read.filters.size(), 1U);
  EXPECT_EQ(read.filters[0].name, "angle_deg.min");
  EXPECT_EQ(read.filters[0].min, 3);
}

TEST(StudyFile, LimitsOfAFilterAreExpressionsToo) {
  const Study read = study(kHead + kVary + kOutput +
                           "[filter]\nangle_deg.min = [\"180/4\", \"sqrt(4)*45\"]\n"
                           "time_ratio = { max = \"1 + 1/4\" }\n");
  ASSERT_EQ(read.filters.size(), 2U);
  EXPECT_EQ(read.filters[0].min, 45);
  EXPECT_EQ(read.filters[0].max, 90);
  EXPECT_EQ(read.filters[1].max, 1.25);
}

TEST(StudyFile, TheStepsOfALogarithmicRangeHaveOneRatio) {
  const Study read = study(kHead + "[[vary]]\nkey = \"mechanism.crank\"\nrange = [0.01, 100]\n" +
                           "steps = 5\nscale = \"log\"\n" + kOutput);
  const auto& values = read.variables[0].values;
  ASSERT_EQ(values.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(values[i] / std::pow(10, static_cast<double>(i) - 2), 1, 1e-14);
  }
}

struct Wrong {
  std::string name;
  std::string text;
  std::size_t line, column;
  std::string says;
};

std::ostream& operator<<(std::ostream& out, const Wrong& wrong) {
  return out << wrong.text;
}

class StudyFaults : public ::testing::TestWithParam<Wrong> {};

TEST_P(StudyFaults, IsTheOnlyOneAndWhereItStands) {
  const auto read = parse(GetParam().text);
  ASSERT_FALSE(read);
  std::string all;
  for (const auto& fault : read.error()) {
    all += std::to_string(fault.line) + ":" + std::to_string(fault.column) + ": " + fault.message +
           '\n';
  }
  ASSERT_EQ(read.error().size(), 1U) << all;
  EXPECT_EQ(read.error()[0].line, GetParam().line) << all;
  EXPECT_EQ(read.error()[0].column, GetParam().column) << all;
  EXPECT_NE(all.find(GetParam().says), std::string::npos) << all;
  EXPECT_NE(all.find("; "), std::string::npos) << all;
}

/// A study in which `vary` is all of its one [[vary]] but the key of the crank, from line 4 on.
std::string varying(const std::string& vary) {
  return kHead + "[[vary]]\nkey = \"mechanism.crank\"\n" + vary + kOutput;
}

std::string keyed(const std::string& key) {
  return kHead + "[[vary]]\nkey = \"" + key + "\"\nvalues = [1]\n" + kOutput;
}

// Two variables sampled in ways that differ by the second's `rest`.
std::string sampled_twice(const std::string& rest) {
  return kHead +
         "[[vary]]\nkey = \"mechanism.crank\"\nrange = [1, 2]\nsampling = \"sobol\"\ncount = 8\n" +
         "[[vary]]\nkey = \"mechanism.rocker\"\nrange = [1, 2]\n" + rest + kOutput;
}

std::string with(const std::string& rest) {
  return kHead + kVary + kOutput + rest;
}

const std::vector<Wrong> kWrong = {
    {"UnknownKey", "titel = \"x\"\n" + with(""), 1, 1, "did you mean \"title\"?"},
    {"OtherKind", "kind = \"cam\"\n" + with(""), 1, 8, "kind is \"cam\""},
    {"AProblem", "kind = \"cam\"\n[follower]\ntype = \"x\"\n", 1, 8, "whose base may be"},
    {"NoBase", kVary + kOutput, 1, 1, "base is missing"},
    {"BaseNotThere", "base = \"none.toml\"\n" + kVary + kOutput, 1, 8, "does not exist"},
    {"BaseEmpty", "base = \"\"\n" + kVary + kOutput, 1, 8, "the name is empty"},
    {"BaseFolder", "base = \"analysis\"\n" + kVary + kOutput, 1, 8, "is a directory"},
    {"BaseNoToml", "base = \"path/bean.svg\"\n" + kVary + kOutput, 1, 8,
     "has a fault of its own, at 1:"},
    {"BaseIsAStudy", "base = \"study/cam-size.toml\"\n" + kVary + kOutput, 1, 8,
     "is itself a study"},
    {"NothingVaries", kHead + kOutput, 1, 1, "vary is missing"},
    {"KeyMissing", kHead + "[[vary]]\nvalues = [1]\n" + kOutput, 2, 1, "key is missing"},
    {"KeyMisspelt", keyed("mechanism.copler"), 3, 7, "did you mean \"mechanism.coupler\"?"},
    {"KeyOfATable", keyed("mechanism"), 3, 7, "mechanism is a table there"},
    {"KeyOfAWord", keyed("mechanism.type"), 3, 7, "mechanism.type is a string there"},
    {"KeyBelowANumber", keyed("mechanism.crank.x"), 3, 7, "mechanism.crank is a"},
    {"IndexOutOfRange", keyed("mechanism.fixed_pivots[2][0]"), 3, 7,
     "has 2 entries there, counted from 0"},
    {"IndexOfANumber", keyed("mechanism.crank[0]"), 3, 7, "mechanism.crank is a"},
    {"KeyIsNoPlace", keyed("mechanism..crank"), 3, 7, "no place in a file"},
    {"KeyWithIndexInWords", keyed("mechanism.fixed_pivots[01][0]"), 3, 7, "no place in a file"},
    {"TwoWays", varying("range = [1, 2]\nsteps = 3\nsampling = \"sobol\"\ncount = 4\n"), 2, 1,
     "in more than one way"},
    {"NoWay", varying(""), 2, 1, "does not say how it varies"},
    {"RangeAlone", varying("range = [1, 2]\n"), 2, 1, "neither steps nor sampling"},
    {"StepsAlone", varying("steps = 2\n"), 2, 1, "has no range"},
    {"ValuesAndRange", varying("values = [1]\nrange = [1, 2]\n"), 2, 1, "has a range beside"},
    {"RangeInverted", varying("range = [2, 1]\nsteps = 3\n"), 4, 9, "is empty, 2 > 1"},
    {"RangeEmpty", varying("range = [2, 2]\nsteps = 3\n"), 4, 9, "both ends are 2"},
    {"RangeInfinite", varying("range = [2, inf]\nsteps = 3\n"), 4, 13, "is inf"},
    {"OneStep", varying("range = [1, 2]\nsteps = 1\n"), 5, 9, "an integer from 2"},
    {"NoValues", varying("values = []\n"), 4, 10, "has 0 values"},
    {"ValueNotFinite", varying("values = [1, nan]\n"), 4, 14, "is nan"},
    {"LogarithmOfNothing", varying("range = [0, 2]\nsteps = 3\nscale = \"log\"\n"), 4, 9,
     "not all above 0"},
    {"LogarithmOfValues", varying("values = [1]\nscale = \"log\"\n"), 5, 9, "beside values"},
    {"ScaleUnknown", varying("range = [1, 2]\nsteps = 3\nscale = \"lin\"\n"), 6, 9,
     "allowed are \"linear\""},
    {"SamplingUnknown", varying("range = [1, 2]\nsampling = \"sobl\"\ncount = 4\n"), 5, 12,
     "perhaps for \"sobol\""},
    {"CountMissing", varying("range = [1, 2]\nsampling = \"sobol\"\n"), 2, 1, "count is missing"},
    {"CountOfNothing", varying("range = [1, 2]\nsampling = \"sobol\"\ncount = 0\n"), 6, 9,
     "count is 0"},
    {"SamplingMissing", varying("range = [1, 2]\ncount = 4\n"), 2, 1, "sampling is missing"},
    {"SamplingsDiffer", sampled_twice("sampling = \"latin\"\ncount = 8\n"), 10, 12,
     "\"sobol\" of a variable before"},
    {"CountsDiffer", sampled_twice("sampling = \"sobol\"\ncount = 9\n"), 11, 9,
     "8 of a variable before"},
    {"KeyTwice", kHead + kVary + kVary + kOutput, 7, 7, "a second time"},
    {"TooManyDesigns",
     kHead + "[[vary]]\nkey = \"mechanism.crank\"\nrange = [1, 2]\nsteps = 1000000\n" +
         "[[vary]]\nkey = \"mechanism.rocker\"\nrange = [1, 2]\nsteps = 1000000\n" +
         "[[vary]]\nkey = \"mechanism.coupler\"\nrange = [1, 2]\nsteps = 2\n" + kOutput,
     2, 1, "makes 2e+12 designs"},
    {"MetricUnknown", kHead + kVary + "[output]\nmetrics = [\"time_rato\"]\n", 7, 12,
     "did you mean \"time_ratio\"?"},
    {"MetricTwice", kHead + kVary + "[output]\nmetrics = [\"class\", \"class\"]\n", 7, 21,
     "a second time"},
    {"MetricVaries", kHead + kVary + "[output]\nmetrics = [\"class\", \"mechanism.coupler\"]\n", 7,
     21, "which varies"},
    {"MetricIsNoPlace", kHead + kVary + "[output]\nmetrics = [\"mechanism.dyad[0\\\"; --\"]\n", 7,
     12, "no metric of the base"},
    {"MetricWithNul", kHead + kVary + "[output]\nmetrics = [\"mechanism.dyad.\\u0000\"]\n", 7, 12,
     "this string holds the character U+0000"},
    {"MetricsOfOneColumn",
     kHead + kVary + "[output]\nmetrics = [\"mechanism.dyad.a\", \"mechanism.dyad.A\"]\n", 7, 32,
     "beside \"mechanism.dyad.a\""},
    {"ObjectivesOfOneColumn",
     with("[objective]\nminimize = [\"mechanism.dyad.a\", \"mechanism.dyad.A\"]\n"), 9, 33,
     "beside \"mechanism.dyad.a\""},
    {"NoMetric", kHead + kVary, 1, 1, "names no metrics"},
    {"RowsUnknown", with("rows = \"some\"\n"), 8, 8, "allowed are \"passed\", \"all\""},
    {"FilterUnknown", with("[filter]\nangle_deg.mim = [1, 2]\n"), 9, 11,
     "did you mean \"angle_deg.min\"?"},
    {"FilterInverted", with("[filter]\ntime_ratio = [2, 1]\n"), 9, 14, "lets nothing pass"},
    {"FilterOfInfinity", with("[filter]\ntime_ratio = [inf, inf]\n"), 9, 14, "lets nothing pass"},
    {"FilterNotANumber", with("[filter]\ntime_ratio = [nan, 1]\n"), 9, 15, "no limits"},
    {"FilterOfNoExpression", with("[filter]\ntime_ratio = [\"1 +\", 2]\n"), 9, 15, "no limits"},
    {"FilterOfThree", with("[filter]\ntime_ratio = [1, 2, 3]\n"), 9, 14, "no limits"},
    {"FilterOfNothing", with("[filter]\ntime_ratio = {}\n"), 9, 14, "no limits"},
    {"FilterUnknownOfNothing", with("[filter]\nnone = {}\n"), 9, 1, "neither a metric"},
    {"FilterOfANumber", with("[filter]\ntime_ratio = 2\n"), 9, 14, "no limits"},
    {"FilterByAWord", with("[filter]\ntime_ratio = \"x\"\n"), 9, 14, "\"time_ratio\" is a number"},
    {"FilterOfAWord", with("[filter]\nclass = [1, 2]\n"), 9, 9, "\"class\" is a word"},
    {"FilterOfNoWord", with("[filter]\nclass = [\"a\", 2]\n"), 9, 15, "among its words"},
    {"FilterNoTable", "filter = 3\n" + with(""), 1, 10, "filter is an integer"},
    {"ObjectiveUnknown", with("[objective]\nminimize = [\"x\"]\n"), 9, 13, "neither a metric"},
    {"ObjectiveIsAWord", with("[objective]\nminimize = \"class\"\n"), 9, 12, "which is a word"},
    {"ObjectiveTwice", with("[objective]\nminimize = \"time_ratio\"\nmaximize = \"time_ratio\"\n"),
     10, 12, "a second time"}};

INSTANTIATE_TEST_SUITE_P(All, StudyFaults, ::testing::ValuesIn(kWrong),
                         [](const auto& info) { return info.param.name; });

TEST(StudyFile, AllFaultsAreFoundInOneRun) {
  const auto read = parse("titel = 1\nbase = \"analysis/crank-rocker.toml\"\n[[vary]]\n" +
                          std::string("key = \"mechanism.x\"\nrange = [2, 1]\nsteps = 1\n") +
                          "[output]\nmetrics = [\"x\", \"y\"]\n[filter]\nz = 1\n");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().size(), 7U);
}

TEST(StudyFile, ABaseWithAFaultSaysWhich) {
  const auto folder = std::filesystem::temp_directory_path() / "cognate-study-file-test";
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "base.toml") << "kind = \"cam\"\nfolower = 1\n";
  const auto read = parse_study("base = \"base.toml\"\n" + kVary + kOutput, folder, names);
  std::filesystem::remove_all(folder);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error()[0].line, 1U);
  EXPECT_NE(read.error()[0].message.find("has a fault of its own, at 1:1: "), std::string::npos)
      << read.error()[0].message;
}

// What else in a study is wrong is found although its base is not there.
TEST(StudyFile, WithoutABaseTheRestIsReadAllTheSame) {
  const auto read =
      parse("base = \"none.toml\"\n[[vary]]\nkey = \"a.b\"\nrange = [2, 1]\nsteps = 4\n");
  ASSERT_FALSE(read);
  ASSERT_EQ(read.error().size(), 2U);
  EXPECT_EQ(read.error()[1].line, 4U);
}

TEST(KeyPath, HasOneSpelling) {
  using reading::parse_key_path;
  const KeyPath expected = {"dyad", std::size_t{1}, "lengths", std::size_t{0}};
  EXPECT_EQ(parse_key_path("dyad[1].lengths[0]"), expected);
  for (const char* wrong :
       {"", ".", "a.", ".a", "a..b", "[0]", "a[", "a[]", "a[-1]", "a[+1]", "a[1", "a[1]b", "a b",
        "a[00]", "a[99999999999999999999]", "\xc3\xa4"}) {
    EXPECT_FALSE(parse_key_path(wrong)) << wrong;
  }
}

// A mutated file gives a study, or faults within it.
TEST(StudyFile, EveryMutationGivesAStudyOrFaults) {
  const std::string whole =
      with("rows = \"all\"\n[filter]\ntime_ratio = [1, 2]\n") +
      "\"mechanism.coupler\" = { max = 3 }\n[objective]\nminimize = " + "\"time_ratio\"\n";
  ASSERT_TRUE(parse(whole));
  const std::vector<std::string> tokens = {"nan", "[", "]",          "{", "}",  "1e300", "\"", "=",
                                           "\n",  ".", "[[vary]]\n", "0", "-1", ",",     "inf"};
  std::mt19937 random(7);
  for (int trial = 0; trial < 4000; ++trial) {
    std::string text = whole;
    for (int edits = 0; edits < 3; ++edits) {
      const std::size_t at = random() % text.size();
      text.replace(at, random() % 6, tokens[random() % tokens.size()]);
    }
    const auto read = parse(text);
    if (read) {
      ASSERT_GE(design_count(*read), 1) << text;
      ASSERT_FALSE(study_columns(*read).empty());
      continue;
    }
    ASSERT_FALSE(read.error().empty());
    for (const Fault& fault : read.error()) {
      ASSERT_NE(fault.message.find("; "), std::string::npos) << fault.message << "\n" << text;
    }
  }
}

}  // namespace
}  // namespace cognate::problems::study_file_test
