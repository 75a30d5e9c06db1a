/// Straight-line problems from file to designs: the classical linkages, degenerate cases by name,
/// and what the reader refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::straight_line_problem_test {
namespace {

const std::filesystem::path kLibrary = std::filesystem::path(kLibraryFolder) / "straight-line";

Result solve_file(const std::string& name) {
  const auto problem = read_task(kLibrary / (name + ".toml"));
  EXPECT_TRUE(problem.has_value()) << name;
  return problem ? solve(std::get<StraightLineProblem>(*problem), {}) : Result{};
}

Result solve_text(const std::string& mechanism, int contact) {
  const auto problem =
      parse_task("kind = \"straight-line\"\n[target]\nmethod = \"exact\"\ncontact = " +
                 std::to_string(contact) + "\n[mechanism]\n" + mechanism);
  EXPECT_TRUE(problem.has_value()) << (problem ? "" : problem.error()[0].message);
  return problem ? solve(std::get<StraightLineProblem>(*problem), {}) : Result{};
}

double quantity(const Design& design, const std::string& name) {
  for (const Quantity& f : design.metrics.quantities) {
    if (f.name == name) return std::get<double>(f.value);
  }
  ADD_FAILURE() << "no fact " << name;
  return NAN;
}

Vec2d coupler_point(const Design& design) {
  return design.mechanism.points.back().at.at;
}

void expect_point(const Design& design, const Vec2d& expected, double tolerance = 1e-12) {
  EXPECT_LT(norm(coupler_point(design) - expected), tolerance)
      << coupler_point(design).x << ", " << coupler_point(design).y;
}

TEST(StraightLineLibrary, WattIsTheMiddleOfTheCoupler) {
  const Result result = solve_file("watt");
  ASSERT_EQ(result.designs.size(), 1U);
  EXPECT_EQ(result.status, Status::solved);
  expect_point(result.designs[0], {0.5, 0});
  EXPECT_EQ(quantity(result.designs[0], "contact_points"), 5);
  EXPECT_GT(quantity(result.designs[0], "straight_length_at_0_001"), 1);
  ASSERT_EQ(result.loci.size(), 1U);
  EXPECT_EQ(result.loci[0].name, "inflection line");
}

TEST(StraightLineLibrary, ChebyshevHasArmsOfFourThirdsOfTheFrame) {
  const Result result = solve_file("chebyshev");
  ASSERT_EQ(result.designs.size(), 1U);
  EXPECT_NEAR(four_bar(result.designs[0]).crank, 8, 1e-11);
  expect_point(result.designs[0], {1, 0}, 1e-11);
  EXPECT_EQ(quantity(result.designs[0], "contact_points"), 6);
}

/// The half deviation of the classical coupler point, whose strip goes from −2 to 2 across.
TEST(StraightLineLibrary, ChebyshevsClassicalPointIsNearBallsPoint) {
  const Result result = solve_file("chebyshev-classical");
  ASSERT_EQ(result.designs.size(), 1U);
  // Of the pole at 8/3 and the inflection circle's diameter 25/18 above it, against 4.
  expect_point(result.designs[0], {1, -(8.0 / 3 + 25.0 / 18 - 4)});
  EXPECT_EQ(quantity(result.designs[0], "contact_points"), 4);
  // Chebyshev's middle of the coupler: 0.2438 % of the stroke of 4 (both sides of the line).
  FourBar classical = four_bar(result.designs[0]);
  classical.coupler_point = Vec2d{1, 0};
  const Path path = path_of(as_mechanism(classical), {2, *classical.coupler_point});
  const double at = result.designs[0].crank_angles[0];
  // The middle is over A or D where the coupler stands upright: B at (4, 3) or (0, 5) from A. The
  // first is a dead point of the crank.
  const auto ends = forward_interval(path, at, {std::atan2(3, 4), std::atan2(5, 0)});
  ASSERT_TRUE(ends);
  const StraightSegment segment = measure(path, ends->from, ends->to);
  EXPECT_NEAR(segment.length, 4, 1e-6);
  EXPECT_NEAR(2 * segment.deviation, 0.00975373308633909, 1e-8);
}

/// At the frame's middle P is on the axis at −1/(2 h), h the height of the coupler (Euler-Savary).
TEST(StraightLineLibrary, RobertsIsNearTheMiddleOfTheFrame) {
  const Result result = solve_file("roberts");
  ASSERT_EQ(result.designs.size(), 1U);
  const double height = std::sqrt(9 - 0.25);
  expect_point(result.designs[0], {0.5, -height - 1 / (2 * height)});
  // The classical point, as far from B and C as the arms are long: ±1 from the middle.
  FourBar classical = four_bar(result.designs[0]);
  classical.coupler_point = Vec2d{0.5, -height};
  const Path path = path_of(as_mechanism(classical), {2, *classical.coupler_point});
  // P is on A or D where the other pivot's arm and P–C make one triangle turned about it.
  double from = result.designs[0].crank_angles[0], to = from;
  while (path(from).at.x < 2) from -= 1e-5;
  while (path(to).at.x > 0) to += 1e-5;
  EXPECT_NEAR(2 * measure(path, from, to).deviation, 0.0006105982736306359, 1e-7);
}

TEST(StraightLineLibrary, EvansKeepsTheMeanProportion) {
  const Result result = solve_file("evans");
  ASSERT_EQ(result.designs.size(), 2U);
  bool found = false;
  for (const Design& design : result.designs) {
    found = found || norm(coupler_point(design) - Vec2d{-4.5, 0}) < 1e-12;
    EXPECT_GE(quantity(design, "contact_points"), 4);
  }
  EXPECT_TRUE(found);
}

TEST(StraightLineLibrary, HoekenIsTheLimitOfNortonsTable) {
  const Result result = solve_file("hoeken");
  ASSERT_EQ(result.designs.size(), 1U);
  const Design& design = result.designs[0];
  EXPECT_NEAR(lengths(four_bar(design)).frame, 3, 1e-8);
  expect_point(design, {8, 0}, 1e-7);
  EXPECT_EQ(quantity(design, "contact_points"), 6);
  EXPECT_EQ(result.status, Status::solved);
}

TEST(StraightLineLibrary, ParallelCranksReachThePublishedLengths) {
  const Result same = solve_file("parallel-cranks-same-side");
  ASSERT_EQ(same.designs.size(), 2U);
  expect_point(same.designs[0], {320, 1040}, 1e-9);
  EXPECT_NEAR(quantity(same.designs[0], "straight_length_at_0_001"), 152.2, 0.3);
  EXPECT_NEAR(quantity(same.designs[1], "straight_length_at_0_01"), 123.7, 0.25);
  const Result aslant = solve_file("parallel-cranks-aslant");
  ASSERT_EQ(aslant.designs.size(), 1U);
  expect_point(aslant.designs[0], {72, 0}, 1e-11);
}

TEST(StraightLineLibrary, SliderCrankHasTheSamePoint) {
  const Result result = solve_file("slider-crank");
  ASSERT_FALSE(result.designs.empty());
  int limits = 0, across = 0;
  for (const Design& design : result.designs) {
    EXPECT_EQ(design.mechanism.type(), MechanismType::slider_crank);
    if (design.origin == "exact:inflection-line") {
      // As far over the slider's pin as the crank is long, level with the crank's pin.
      EXPECT_NEAR(norm(coupler_point(design) - Vec2d{3, 0}), 2, 1e-12);
      ++across;
    } else {
      EXPECT_NEAR(std::abs(coupler_point(design).x), 4.5, 1e-12);
      ++limits;
    }
    EXPECT_EQ(quantity(design, "contact_points"), 4);
  }
  EXPECT_GE(limits, 1);
  EXPECT_EQ(across, 4);  // two positions of two assemblies
}

TEST(StraightLine, ASliderCrankWithItsPoleAtInfinity) {
  const std::string slider = "type = \"slider-crank\"\ncrank = 2\ncoupler = 3\noffset = 0.5\n";
  for (const int contact : {3, 4}) {
    const Result result = solve_text(slider + "assembly = \"open\"\ncrank_deg = 90", contact);
    ASSERT_EQ(result.designs.size(), 1U);
    EXPECT_EQ(result.designs[0].origin, "exact:inflection-line");
    EXPECT_EQ(quantity(result.designs[0], "contact_points"), 4);
    EXPECT_GT(quantity(result.designs[0], "straight_length_at_0_001"), 0.5);
    EXPECT_GT(quantity(result.designs[0], "straight_length_at_0_01"), 1);
  }
  EXPECT_EQ(solve_text(slider + "crank_deg = 90", 5).status, Status::no_solution);
  EXPECT_EQ(solve_text(slider, 4).designs.size(), 4U);
}

TEST(StraightLine, AllPositionsOfACrankRockerComeBack) {
  int tested = 0;
  const Result result = solve_file("crank-rocker");
  ASSERT_EQ(result.designs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GE(quantity(result.designs[i], "contact_points"), 5);
    if (i == 0) continue;
    ++tested;
    EXPECT_LE(quantity(result.designs[i], "straight_length_at_0_001"),
              quantity(result.designs[i - 1], "straight_length_at_0_001"));
  }
  EXPECT_GE(tested, 3);
}

void expect_none(const std::string& mechanism, int contact, const std::string& reason) {
  const Result result = solve_text(mechanism, contact);
  EXPECT_EQ(result.status, Status::no_solution) << mechanism;
  EXPECT_TRUE(result.designs.empty()) << mechanism;
  ASSERT_FALSE(result.notes.empty()) << mechanism;
  EXPECT_NE(result.notes[0].find(reason), std::string::npos) << result.notes[0];
}

TEST(StraightLine, WhatHasNoneIsReportedWithTheReason) {
  const std::string parallelogram =
      "cranks = \"parallel\"\nsides = \"same\"\ncrank = 2\nrocker = 2\ncoupler = 3\n";
  expect_none(parallelogram, 3, "parallelogram");
  expect_none("frame = 3\ncrank = 1\ncoupler = 3\nrocker = 1\nassembly = \"open\"\ncrank_deg = 50",
              4, "parallelogram");
  expect_none(
      "cranks = \"parallel\"\nsides = \"opposite\"\ncrank = 2\nrocker = 3\ncoupler = 3\n"
      "coupler_angle_deg = 20",
      4, "at infinity");
  expect_none(
      "cranks = \"parallel\"\nsides = \"same\"\ncrank = 2\nrocker = 3\ncoupler = 3\n"
      "coupler_angle_deg = 90",
      3, "in line");
  expect_none("frame = 9\ncrank = 1\ncoupler = 3\nrocker = 1\ncrank_deg = 50", 4, "assembled");
  expect_none("frame = 4\ncrank = 1\ncoupler = 3\nrocker = 2.5\ncrank_deg = 50", 5, "four points");
  expect_none("type = \"slider-crank\"\ncrank = 1\ncoupler = 3\ncrank_deg = 50", 4, "slider");
  expect_none("type = \"slider-crank\"\ncrank = 1\ncoupler = 3\noffset = 0.5", 5, "limit position");
  expect_none("frame = 9\ncrank = 1\ncoupler = 3\nrocker = 1", 5, "cannot be assembled at any");
  expect_none("frame = 2\ncrank = 2\ncoupler = 1\nrocker = 1", 5, "No position");
}

TEST(StraightLine, StretchesEndAtChangePoints) {
  // B reaches D at 0°, where an assembly kept would turn the coupler over.
  for (const std::string start : {"crank_deg = 1", "crank_deg = 359\nassembly = \"crossed\""}) {
    const Result kite = solve_text("frame = 2\ncrank = 2\ncoupler = 1\nrocker = 1\n" + start, 4);
    ASSERT_FALSE(kite.designs.empty());
    for (const Design& design : kite.designs) {
      EXPECT_GE(quantity(design, "crank_from_deg_at_0_001"), -1e-9) << start;
      EXPECT_LE(quantity(design, "crank_to_deg_at_0_001"), 360 + 1e-9) << start;
    }
  }
  // Scott Russell: the end of the doubled coupler moves on the normal of the slide line, as
  // 4·sin θ; with the crank across the slide the assemblies meet.
  const Result russell = solve_text(
      "type = \"slider-crank\"\ncrank = 2\ncoupler = 2\ndirection_deg = 30\nassembly = \"open\"",
      5);
  ASSERT_FALSE(russell.designs.empty());
  expect_point(russell.designs[0], {-2, 0});
  EXPECT_EQ(quantity(russell.designs[0], "contact_points"), 9);
  EXPECT_NEAR(quantity(russell.designs[0], "straight_length_at_0_001"), 8, 1e-9);
}

TEST(StraightLine, ConstraintsDecide) {
  const std::string hoeken =
      "crank = 1\ncoupler = 4\nrocker = 4\nframe = 3\nassembly = \"open\"\ncrank_deg = 180\n";
  EXPECT_EQ(solve_text(hoeken + "[constraints]\nclass = \"crank-rocker\"\n", 4).status,
            Status::solved);
  EXPECT_EQ(solve_text(hoeken + "[constraints]\nlink_ratio_max = 4\n", 4).status, Status::solved);
  EXPECT_EQ(solve_text(hoeken + "[constraints]\ntransmission_angle_deg = [40, 140]\n", 4).status,
            Status::infeasible);
}

void expect_fault(const std::string& text, const std::string& message) {
  const auto problem = parse_task("kind = \"straight-line\"\n" + text);
  ASSERT_FALSE(problem.has_value()) << text;
  bool found = false;
  for (const auto& fault : problem.error()) {
    found = found || fault.message.find(message) != std::string::npos;
  }
  EXPECT_TRUE(found) << problem.error()[0].message;
}

TEST(StraightLine, ReaderRefusesWhatCannotBe) {
  const std::string exact = "[target]\nmethod = \"exact\"\ncontact = 4\n[mechanism]\n";
  const std::string links = "crank = 1\ncoupler = 3\nrocker = 2.5\n";
  expect_fault(exact + links + "frame = 4\ncrank_deg = 3\n[bounds]\nlength = [1, 2]", "bounds");
  expect_fault("[target]\nmethod = \"exact\"\nlength = 3\n[mechanism]\n" + links +
                   "frame = 4\ncrank_deg = 3",
               "knows curvature alone");
  expect_fault(exact + links + "frame = 4", "crank_deg is missing");
  expect_fault(exact + links + "crank_deg = 4", "only for contact = 5");
  expect_fault(exact + links + "frame = 4\ncrank_deg = 3\ncoupler_point = [1, 2]", "sought");
  expect_fault(exact + "cranks = \"parallel\"\n" + links, "sides is missing");
  expect_fault(exact + "cranks = \"parallel\"\nsides = \"same\"\n" + links + "frame = 4", "frame");
  expect_fault(exact + "cranks = \"symmetric\"\ncrank = 4\nrocker = 4\ncoupler = 1\nframe = 3",
               "symmetric");
  expect_fault(exact + "type = \"slider-crank\"\ncrank = 2", "coupler is missing");
  expect_fault("[target]\nmethod = \"exact\"\ncontact = 6\n[mechanism]\n" + links, "contact");
  expect_fault("[target]\nmethod = \"exact\"\ncontact = 5\n[mechanism]\ncrank = 1\nframe = 3",
               "all but one");
}

TEST(StraightLine, ReaderOfSearchesSaysWhereAFaultIs) {
  const auto problem = parse_task(
      "kind = \"straight-line\"\n[target]\ndeviation = 0.1\ndeviation_relative = 0.5\n"
      "[constraints]\n  crank_range_deg = [0, 400]\nsize_over_length_max = -1\n"
      "speed_variation_max = 0\n[mechanism]\ncrank_deg = 5\n");
  ASSERT_FALSE(problem.has_value());
  std::vector<std::pair<int, int>> places;
  for (const auto& fault : problem.error()) {
    places.emplace_back(static_cast<int>(fault.line), static_cast<int>(fault.column));
  }
  for (const std::pair<int, int>& place :
       {std::pair{3, 13}, {4, 22}, {6, 22}, {7, 24}, {8, 23}, {10, 1}}) {
    EXPECT_NE(std::ranges::find(places, place), places.end()) << place.first << ':' << place.second;
  }
}

TEST(StraightLine, ReaderOfSearchesRefusesWhatCannotBe) {
  expect_fault("[target]\ndeviation = 0.01\n", "nothing in the file fixes the linkage's size");
  expect_fault("[target]\nlength = 1\ndeviation = 0.5\n", "such a segment is no line");
  expect_fault("[target]\ndeviation = 0.01\ndeviation_relative = 0.01\nlength = 1\n",
               "given beside deviation");
  expect_fault("[target]\nlength = 1\ncontact = 4\n", "method = \"exact\"");
  expect_fault("[target]\nlength = 1\nmethod = \"best\"\n", "target.method");
  expect_fault(
      "[target]\nlength = 1\n[mechanism]\ntype = \"slider-crank\"\n[bounds]\nrocker = "
      "[1, 2]\n",
      "does not have");
  expect_fault("[target]\nlength = 1\n[mechanism]\ncrank = 9\n[bounds]\nlength = [1, 2]\n",
               "outside its bounds");
}

}  // namespace
}  // namespace cognate::problems::straight_line_problem_test
