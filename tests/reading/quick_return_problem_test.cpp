/// Quick return from its file to designs: the library, every fault of a file, every way to find
/// nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "analysis/mechanism/output_limits.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/reading/fault_cases.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::quick_return_problem_test {
namespace {

// A file with `lines` in [mechanism]: the first of them is line 5.
std::string file(const std::string& ratio, const std::string& lines) {
  return "kind = \"quick-return\"\n[target]\ntime_ratio = " + ratio + "\n[mechanism]\n" + lines;
}

Result solved(const std::string& text) {
  const auto problem = parse_task(text);
  EXPECT_TRUE(problem) << text;
  return problem ? solve(std::get<QuickReturnProblem>(*problem), {}) : Result{};
}

/// K of a design by following it over a turn of its crank.
double followed_time_ratio(const NamedMechanism& mechanism) {
  const AssemblyRanges assembly_ranges = follow(mechanism.mechanism, 0, 6.283185307179586);
  const auto travel = travels(mechanism.mechanism)[std::size_t(mechanism.output)];
  const auto output = output_range(mechanism.mechanism, assembly_ranges, travel);
  return output ? time_ratio(mechanism.mechanism, assembly_ranges, *output).value_or(0) : 0;
}

TEST(QuickReturnProblem, EveryFileOfTheLibraryIsSolvedAndMovesAsItShould) {
  int files = 0;
  const std::filesystem::path folder(std::string(kLibraryFolder) + "/quick-return");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto problem = std::get<QuickReturnProblem>(*read_task(entry.path()));
    const Result result = solve(problem, {});
    EXPECT_EQ(result.status, Status::solved) << entry.path();
    // What lies on a raster meets the time ratio but nearly.
    const double tolerance = problem.raster ? 1e-3 : 1e-9;
    for (const Design& design : result.designs) {
      EXPECT_TRUE(all_satisfied(design.constraints)) << entry.path();
      EXPECT_TRUE(design.metrics.defects.empty()) << entry.path();
      EXPECT_NEAR(followed_time_ratio(design.mechanism), problem.time_ratio, tolerance)
          << entry.path();
    }
    ++files;
  }
  EXPECT_GE(files, 9);
}

TEST(QuickReturnProblem, AllSolutionsWithTheirMirrorImages) {
  const Result result = solved(file("1.25", "rocker = 290\nswing_deg = 34\ncrank = 77\n"));
  ASSERT_EQ(result.designs.size(), 4U);
  EXPECT_FALSE(result.designs[0].mirror_of);
  EXPECT_EQ(result.designs[1].mirror_of, 0);
  EXPECT_FALSE(result.designs[2].mirror_of);
  EXPECT_EQ(result.designs[3].mirror_of, 2);
  EXPECT_NEAR(lengths(four_bar(result.designs[0])).frame, 276.8037081761766, 1e-10);
  EXPECT_TRUE(result.families.empty());
  EXPECT_TRUE(result.quantities.empty()) << "no pivot was left out";
}

TEST(QuickReturnProblem, TheRockersAngleAtALimit) {
  int tested = 0;
  for (const std::string given :
       {"swing_deg = 34\nouter_limit_deg = 90\n", "swing_deg = 34\ninner_limit_deg = 124\n",
        "frame = 320\nouter_limit_deg = 90\n"}) {
    const Result result = solved(file("1.25", "rocker = 290\n" + given));
    ASSERT_FALSE(result.designs.empty()) << given;
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.families.empty());
    for (const Design& design : result.designs) {
      const auto& check = design.constraints.back();
      EXPECT_TRUE(check.name.ends_with("_limit_deg"));
      EXPECT_TRUE(check.satisfied);
      const auto quantity = [&](const char* name) {
        return find_quantity(design.metrics.quantities, QuantityKey<double>{name}).value_or(-1);
      };
      const double outer = quantity("outer_limit_deg"), inner = quantity("inner_limit_deg");
      EXPECT_NEAR(check.name.find("outer") != std::string::npos ? outer : inner,
                  check.name.find("outer") != std::string::npos ? 90 : 124, 1e-9);
      EXPECT_NEAR(inner - outer, quantity("swing_deg"), 1e-9);
      EXPECT_NEAR(followed_time_ratio(design.mechanism), 1.25, 1e-9);
      ++tested;
    }
  }
  EXPECT_GE(tested, 6);
}

TEST(QuickReturnProblem, AFamilyWhereADimensionIsFree) {
  const Result result = solved(file("1.25", "rocker = 290\nswing_deg = 34\n"));
  ASSERT_EQ(result.families.size(), 2U);
  ASSERT_EQ(result.loci.size(), 2U);
  const auto& angles = result.families[0].columns.back();
  EXPECT_EQ(angles.name, "transmission_angle_min_deg");
  const double best = result.designs[0].metrics.transmission_acute_min * 57.29577951308232;
  EXPECT_GE(best, *std::ranges::max_element(angles.values));
  EXPECT_LE(best, *std::ranges::max_element(angles.values) + 0.05);
}

TEST(QuickReturnProblem, ChecksWhatTheFileDemands) {
  const auto tight = solved(file("1.25",
                                 "rocker = 290\nswing_deg = 34\n[constraints]\n"
                                 "transmission_angle_deg = [60, 120]\n"));
  EXPECT_EQ(tight.status, Status::infeasible);
  EXPECT_NE(tight.notes.back().find("No linkage of the family"), std::string::npos);
  EXPECT_FALSE(tight.designs.empty());
  const auto bar = solved(file("1.3", "type = \"shaper\"\nstroke = 0.1\nframe = 1\nrod = 1\n"));
  EXPECT_EQ(bar.status, Status::infeasible);  // the block would slide off the bar
}

bool all_sound(const Result& result) {
  return std::ranges::all_of(
      result.designs, [](const Design& design) { return all_satisfied(design.constraints); });
}

// The best of each arc breaks the limit; others of the family meet it.
TEST(QuickReturnProblem, LooksForTheBestWithinTheConstraints) {
  const std::string family = "rocker = 290\nswing_deg = 34\n[constraints]\n";
  const auto ratio = solved(file("1.25", family + "link_ratio_max = 3.5\n"));
  EXPECT_EQ(ratio.status, Status::solved);
  EXPECT_TRUE(all_sound(ratio));
  const auto angles = solved(file("1.25", family + "transmission_angle_deg = [43, 88]\n"));
  EXPECT_EQ(angles.status, Status::solved);
  EXPECT_TRUE(all_satisfied(angles.designs.at(0).constraints));
}

// K = 1 leaves a length free in every case.
TEST(QuickReturnProblem, ChoosesWhereEveryLengthWillDo) {
  const std::string rocker = "rocker = 290\nswing_deg = 34\n";
  const std::string slider = "type = \"slider-crank\"\nstroke = 100\n";
  for (const std::string& lines :
       {rocker, rocker + "crank = 84.78779436959367\n",
        rocker + "crank_pivot_line = [0, 1, 277.3283792292803]\n", slider, slider + "crank = 50\n",
        slider + "[constraints]\npressure_angle_deg_max = 10\n"}) {
    const Result result = solved(file("1", lines));
    EXPECT_EQ(result.status, Status::solved) << lines;
    EXPECT_TRUE(all_sound(result)) << lines;
    ASSERT_FALSE(result.notes.empty()) << lines;
    EXPECT_NE(result.notes.back().find("the design has"), std::string::npos) << result.notes.back();
    for (const Design& design : result.designs) {
      EXPECT_NEAR(followed_time_ratio(design.mechanism), 1, 1e-9) << lines;
    }
  }
}

struct Nothing {
  std::string name, text, says;
};

class FindsNothing : public ::testing::TestWithParam<Nothing> {};

TEST_P(FindsNothing, AndSaysWhy) {
  const Result result = solved(GetParam().text);
  EXPECT_EQ(result.status, Status::no_solution);
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes[0].find(GetParam().says), std::string::npos) << result.notes[0];
}

const std::string kRocker = "rocker = 290\nswing_deg = 34\n";
const std::string kSlider = "type = \"slider-crank\"\nstroke = 100\n";

INSTANTIATE_TEST_SUITE_P(
    QuickReturnProblem, FindsNothing,
    ::testing::Values(
        Nothing{"Crank", file("1.25", kRocker + "crank = 200\n"), "A crank of 200 is not possible"},
        Nothing{"Coupler", file("1.25", kRocker + "coupler = 2\n"), "more than 84.7878"},
        Nothing{"Frame", file("1.25", kRocker + "frame = 2000\n"), "beyond them"},
        Nothing{"CrankAtItsLimit", file("1.25", kRocker + "crank = 84.787795\n"),
                "A crank of 84.787795 is not possible: it must be more than 10.49244 and less than "
                "84.78779 "},
        Nothing{"FrameAtItsLimit", file("1.25", kRocker + "frame = 290\n"), "and less than 290 "},
        Nothing{"Line", file("1.25", kRocker + "crank_pivot_line = [0, 1, 5000]\n"),
                "does not meet"},
        Nothing{"Circuits", file("2.2", kRocker + "crank_pivot_line = [1, 0, 0]\n"),
                "different circuits"},
        Nothing{"Swing", file("4", kRocker + "crank = 50\n"), "K is less than 3.93151"},
        Nothing{"OneCrank", file("1", kRocker + "crank = 80\n"), "must be 84.7878."},
        Nothing{"OuterLimit", file("1.25", kRocker + "outer_limit_deg = 150\n"),
                "An angle of the rocker at its outer limit of 150 is not possible: it must be "
                "more than "},
        Nothing{"InnerLimit", file("1.25", kRocker + "inner_limit_deg = 20\n"),
                "An angle of the rocker at its inner limit of 20 is not possible"},
        Nothing{"LimitOfASwing", file("4", kRocker + "inner_limit_deg = 90\n"),
                "K is less than 3.93151"},
        Nothing{"LimitWithFrame", file("3", "rocker = 75\nframe = 10\ninner_limit_deg = 90\n"),
                "has its rocker at 90 degrees at the inner limit"},
        Nothing{"Bounds", file("1.25", kRocker + "[bounds]\ncoupler = [1, 2]\n"), "bounds"},
        Nothing{"SliderCentred", file("1.2", kSlider + "offset = 0\n"), "Without offset"},
        Nothing{"SliderOne", file("1", kSlider + "offset = 3\n"), "allows no offset"},
        Nothing{"SliderThree", file("3.5", kSlider + "offset = 3\n"), "3 or more"},
        Nothing{"SliderOffset", file("1.2", kSlider + "offset = 1000\n"),
                "An offset with a magnitude of 1000 is not"},
        Nothing{"SliderCrank", file("1.2", kSlider + "crank = 90\n"), "A crank of 90"},
        Nothing{"GuideOne", file("1", "type = \"guide-bar\"\nframe = 1\n"), "no length"},
        Nothing{"GuideOffset", file("2", "type = \"guide-bar\"\nframe = 1\noffset = 1\n"), "0.75"},
        Nothing{"ShaperOne", file("1", "type = \"shaper\"\nstroke = 1\nframe = 1\nrod = 1\n"),
                "no length"},
        Nothing{"ShaperRod", file("2", "type = \"shaper\"\nstroke = 1\nframe = 1\nrod = 0.01\n"),
                "does not reach"}),
    [](const auto& info) { return info.param.name; });

TEST(QuickReturnProblem, AtTheEdgesOfWhatAFileMaySay) {
  for (const std::string ratio : {"1", "1.0000000000000002", "1.5", "1000"}) {
    for (const std::string swing : {"0.001", "60", "179.999"}) {
      for (const std::string given :
           {"", "crank = 1e-100\n", "crank = 1e100\n", "coupler = 1e100\n", "frame = 1\n",
            "frame = 1e100\n", "crank_pivot_line = [1e-100, 1e100, 1e100]\n",
            "outer_limit_deg = 1e-9\n", "outer_limit_deg = 90\n",
            "inner_limit_deg = 179.9999999\n"}) {
        const Result result =
            solved(file(ratio, "rocker = 1\nswing_deg = " + swing + "\n" + given));
        EXPECT_TRUE(!result.designs.empty() || !result.notes.empty()) << ratio << swing << given;
        for (const Design& design : result.designs) {
          EXPECT_TRUE(std::isfinite(lengths(four_bar(design)).frame));
          EXPECT_TRUE(std::isfinite(*design.metrics.condition));
        }
      }
    }
  }
}

const std::vector<FaultCase> kCases = {
    {"Empty",
     "kind = \"quick-return\"\n",
     {{1, 1, "target.time_ratio is missing"},
      {1, 1, "mechanism.rocker is missing"},
      {1, 1, "mechanism.swing_deg is missing"}}},
    {"Ratio", file("0.8", kRocker), {{3, 14, "a ratio from 1 to 1000"}}},
    {"Swing", file("1.2", "rocker = 1\nswing_deg = 180\n"), {{6, 13, "179.999"}}},
    {"Type", file("1.2", "type = \"shapr\"\nstroke = 1\n"), {{5, 8, "\"shaper\""}}},
    {"TwoGiven",
     file("1.2", kRocker + "crank = 7\nframe = 7\n"),
     {{8, 9, "is given beside crank"}}},
    {"TwoLimits",
     file("1.2", kRocker + "outer_limit_deg = 90\ninner_limit_deg = 120\n"),
     {{8, 19, "is given beside outer_limit_deg"}}},
    {"LimitAndFrameAndSwing",
     file("1.2", kRocker + "outer_limit_deg = 90\nframe = 300\n"),
     {{7, 19, "is given beside frame"}}},
    {"LimitAndCrankAndFrame",
     file("1.2", "rocker = 290\nframe = 300\ncrank = 7\ninner_limit_deg = 90\n"),
     {{8, 19, "is given beside crank"}}},
    {"LimitWithoutSwing",
     file("1.2", "rocker = 290\ninner_limit_deg = 90\n"),
     {{4, 1,
       "swing_deg is missing; expected an angle in degrees from 0.001 to 179.999, or "
       "mechanism.frame"}}},
    {"LimitOf180",
     file("1.2", kRocker + "inner_limit_deg = 180\n"),
     {{7, 19, "is 180; expected an angle in degrees between 0 and 180"}}},
    {"LimitOfASlider",
     file("1.2", kSlider + "inner_limit_deg = 90\n"),
     {{7, 1, "unknown key \"inner_limit_deg\""}}},
    {"LimitOnARaster",
     file("1.2", kRocker + "inner_limit_deg = 90\n[bounds]\nlength = [1, 900]\n[raster]\n"
                           "length = 1\n"),
     {{10, 1, "is given with the rocker's angle at a limit, which linkages on a raster"}}},
    {"Line", file("1.2", kRocker + "crank_pivot_line = [0, 0, 1]\n"), {{7, 20, "a = b = 0"}}},
    {"LineTooShort", file("1.2", kRocker + "crank_pivot_line = [0, 1]\n"), {{7, 20, "numbers"}}},
    {"WrongType", file("1.2", kSlider + "rocker = 3\n"), {{7, 1, "unknown key \"rocker\""}}},
    {"NoConstraints",
     file("1.2", "type = \"guide-bar\"\nframe = 3\n[constraints]\nclass = \"grashof\"\n"),
     {{8, 1, "unknown key \"class\" in [constraints]; allowed are \"layers_max\""}}},
    {"NoBounds",
     file("1.2", kSlider + "[bounds]\ncrank = [1, 2]\n"),
     {{8, 1, "unknown key \"crank\" in [bounds]; no key is allowed here"}}},
    {"NoFrame", file("1.2", "type = \"guide-bar\"\n"), {{4, 1, "mechanism.frame is missing"}}},
    {"NoRod",
     file("1.2", "type = \"shaper\"\nstroke = 1\nframe = 1\n"),
     {{4, 1, "mechanism.rod is missing"}}},
    {"Pressure",
     file("1.2", kSlider + "[constraints]\npressure_angle_deg_max = 90\n"),
     {{8, 26, "89.999"}}},
    {"SliderTwoGiven",
     file("1.2", kSlider + "crank = 40\ncoupler = 80\n"),
     {{8, 11, "is given beside crank"}}},
};

class QuickReturnFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(QuickReturnFaults, AreFound) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(QuickReturnProblem, QuickReturnFaults, ::testing::ValuesIn(kCases),
                         name_of_case);

}  // namespace
}  // namespace cognate::problems::quick_return_problem_test
