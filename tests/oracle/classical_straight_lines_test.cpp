/// The search for straight lines against the classical linkages and the best figures known, each on
/// its own measure, all measured anew from the finished linkage.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems::classical_straight_lines_test {
namespace {

Result solve_text(const std::string& text, int threads = 0) {
  const auto problem = parse_task("kind = \"straight-line\"\n" + text);
  EXPECT_TRUE(problem.has_value()) << (problem ? "" : problem.error()[0].message);
  Run run;
  run.threads = threads;
  return problem ? solve(std::get<StraightLineProblem>(*problem), run) : Result{};
}

double quantity(const Design& design, const std::string& name) {
  for (const Quantity& f : design.metrics.quantities) {
    if (f.name == name) return std::get<double>(f.value);
  }
  ADD_FAILURE() << "no fact " << name;
  return NAN;
}

/// Half the width of the narrowest strip over the distance between the feet of the ends, from the
/// triangles of the textbook and 20000 samples: no code of the library enters.
double plain_straightness(const FourBar& linkage, double from, double to) {
  const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
  const double side = linkage.assembly == Assembly::open ? 1 : -1;
  std::vector<Vec2d> points;
  constexpr int kSamples = 20000;
  for (int k = 0; k <= kSamples; ++k) {
    const double angle = from + (to - from) * k / kSamples;
    const Vec2d b{linkage.crank * std::cos(angle), linkage.crank * std::sin(angle)};
    const Vec2d diagonal = frame - b;
    const double d = std::hypot(diagonal.x, diagonal.y);
    const double l2 = linkage.coupler, l3 = linkage.rocker;
    const double cosine = (d * d + l2 * l2 - l3 * l3) / (2 * d * l2);
    const double angle_of_coupler =
        std::atan2(diagonal.y, diagonal.x) + side * std::acos(std::clamp(cosine, -1.0, 1.0));
    const double c = std::cos(angle_of_coupler), s = std::sin(angle_of_coupler);
    const auto [u, v] = *linkage.coupler_point;
    points.push_back({b.x + u * c - v * s, b.y + u * s + v * c});
  }
  const Vec2d chord = points.back() - points.front();
  double best = 1e300;
  const double along = std::atan2(chord.y, chord.x);
  // The best line turns from the chord by no more than a few times δ/L.
  for (int k = -4000; k <= 4000; ++k) {
    const double turn = along + 1e-2 * std::pow(k / 4000.0, 3);
    const double c = std::cos(turn), s = std::sin(turn);
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < points.size(); i += 20) {
      const double height = c * points[i].y - s * points[i].x;
      low = std::min(low, height);
      high = std::max(high, height);
    }
    best = std::min(best, 0.5 * (high - low) / std::abs(c * chord.x + s * chord.y));
  }
  return best;
}

void expect_sound(const Result& result) {
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_FALSE(result.designs.empty());
  for (const Design& design : result.designs) {
    EXPECT_TRUE(all_satisfied(design.constraints));
    EXPECT_TRUE(design.metrics.defects.empty());
    const double from = quantity(design, "crank_from_deg") * kPi / 180;
    const double to = quantity(design, "crank_to_deg") * kPi / 180;
    const double reported = quantity(design, "deviation_relative");
    EXPECT_NEAR(plain_straightness(four_bar(design), from, to), reported, 3e-3 * reported + 1e-8);
  }
}

/// 2 δ/L in per cent, as the tables give it.
double best_width(const Result& result) {
  return 200 * quantity(result.designs.at(0), "deviation_relative");
}

std::string hoeken(int range) {
  return "[target]\nlength = 1\n[constraints]\nclass = \"crank-rocker\"\nlink_ratio_max = 10\n"
         "size_over_length_max = 5\ncrank_range_deg = [" +
         std::to_string(range) + ", " + std::to_string(range) + "]\n";
}

struct HoekenRow {
  int range;
  double published;  ///< Norton, Design of Machinery: (max − min)/stroke in per cent
  double best_known;
};

/// Norton's table for Hoeken's linkage, and the best of symmetric four-bars found by Nelder and
/// Mead's method from 40 starts each, all links within ten cranks.
class HoekenRange : public ::testing::TestWithParam<HoekenRow> {};

TEST_P(HoekenRange, IsReachedAtLeast) {
  const auto [range, published, best_known] = GetParam();
  const Result result = solve_text(hoeken(range));
  expect_sound(result);
  EXPECT_LT(best_width(result), published);
  EXPECT_LE(best_width(result), best_known);
  EXPECT_NEAR(
      quantity(result.designs[0], "crank_to_deg") - quantity(result.designs[0], "crank_from_deg"),
      range, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(StraightLineSearch, HoekenRange,
                         ::testing::Values(HoekenRow{120, 0.01, 0.0053507758},
                                           HoekenRow{180, 0.096, 0.027562524}));

/// Frame 4, cranks 5, coupler 2, its middle between x = ±2: 0.24384 % of the stroke from side to
/// side.
TEST(StraightLineSearch, BeatsChebyshevs) {
  const Result result = solve_text(
      "[target]\nlength = 4\n[mechanism]\nframe = 4\n[bounds]\nlength = [0, 5]\n"
      "[constraints]\nclass = \"double-rocker\"\nsize_over_length_max = 1.25\n");
  expect_sound(result);
  EXPECT_LT(best_width(result), 0.24384332715847723);
  EXPECT_NEAR(lengths(four_bar(result.designs[0])).frame, 4, 1e-12);
}

/// Hoeken's linkage in Norton's proportions has a size of 1.3394 strokes.
TEST(StraightLineSearch, BeatsHoekensInHisSize) {
  const Result result = solve_text(
      "[target]\nlength = 1\n[constraints]\nclass = \"crank-rocker\"\n"
      "crank_range_deg = [180, 180]\nsize_over_length_max = 1.3394\n");
  expect_sound(result);
  EXPECT_LT(best_width(result), 0.096);
}

/// Frame 2, coupler 1, arms 1.2, none of which turns fully: 0.013642 over the stroke of 2.
TEST(StraightLineSearch, BeatsRoberts) {
  const Result result = solve_text(
      "[target]\nlength = 2\n[mechanism]\nframe = 2\n[bounds]\nlength = [0, 2]\n"
      "[constraints]\nclass = \"triple-rocker\"\nsize_over_length_max = 1\n");
  expect_sound(result);
  EXPECT_LT(best_width(result), 100 * 0.013642022867877412 / 2);
}

/// Watt's cranks of 2 and coupler of 1 at the length over which his linkage is straight to 0.1 %.
TEST(StraightLineSearch, BeatsWatts) {
  const Result result = solve_text(
      "[target]\nlength = 1.2872834\n[mechanism]\ncrank = 2\ncoupler = 1\nrocker = 2\n"
      "[constraints]\nsize_over_length_max = 3.2029\n");
  expect_sound(result);
  EXPECT_LT(best_width(result), 0.2);
}

/// Evans' linkage 2, 3, 6 with pivots (5, 6) apart, straight to 0.1 % over 6.06406.
TEST(StraightLineSearch, BeatsEvans) {
  const Result result = solve_text(
      "[target]\nlength = 6.0640603\n[bounds]\nlength = [0, 7.81025]\n[constraints]\n"
      "class = \"triple-rocker\"\nsize_over_length_max = 1.28796\n");
  expect_sound(result);
  EXPECT_LT(best_width(result), 0.2);
}

/// Scott Russell's slider-crank is exact: crank, coupler and B–P equal, the slide line through A.
TEST(StraightLineSearch, FindsTheExactSliderCrank) {
  const Result result = solve_text(
      "[target]\nlength = 1\n[mechanism]\ntype = \"slider-crank\"\n[solve]\nstarts = 40\n");
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(quantity(result.designs[0], "deviation_relative"), 1e-9);
  const auto& slider = std::get<SliderCrank>(result.designs[0].mechanism.description);
  EXPECT_NEAR(slider.crank, slider.coupler, 1e-6);
  EXPECT_NEAR(slider.offset, 0, 1e-6);
}

std::string written(double value) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// The three goals are one front: the smallest linkage for the deviation that a size allows has
/// that size.
TEST(StraightLineSearch, GoalsAgree) {
  const std::string common = "[constraints]\nclass = \"crank-rocker\"\n";
  const Result straightest =
      solve_text("[target]\nlength = 1\n" + common +
                 "size_over_length_max = 1.3\n[solve]\nstarts = 60\ndesigns = 1\n");
  expect_sound(straightest);
  const double deviation = quantity(straightest.designs[0], "deviation_relative");
  const Result smallest = solve_text("[target]\ndeviation_relative = " + written(deviation) + "\n" +
                                     common + "[solve]\nstarts = 60\ndesigns = 1\n");
  expect_sound(smallest);
  EXPECT_LT(quantity(smallest.designs[0], "size_over_length"), 1.3 * 1.002);
  const Result longest =
      solve_text("[target]\ndeviation_relative = " + written(deviation) +
                 "\n[bounds]\nlength = [0, 13]\ncoupler_point = [[-13, -13], [13, 13]]\n" + common +
                 "size_over_length_max = 1.3\n[solve]\nstarts = 60\ndesigns = 1\n");
  expect_sound(longest);
  EXPECT_GT(quantity(longest.designs[0], "straight_length"), 10 * 0.998);
}

/// Two tasks with flat valleys and several minima: the search ends at the bottom of the best, which
/// an interior-point method reached, too, and lists no place on the way there as a design.
TEST(StraightLineSearch, EndsAtTheBottomsOfFlatValleys) {
  struct Task {
    const char* text;
    double deviation, next;  ///< of the best two minima, over the length, refined by Ipopt
  };
  constexpr std::array kTasks{
      Task{"[target]\nlength = 2\n[constraints]\nclass = \"triple-rocker\"\n"
           "size_over_length_max = 1\n[mechanism]\nframe = 2\n[bounds]\nlength = [0, 2]\n",
           4.96684e-4, 5.68841e-4},
      Task{"[target]\nlength = 1\n[constraints]\nclass = \"crank-rocker\"\n"
           "crank_range_deg = [180, 180]\nlink_ratio_max = 10\nsize_over_length_max = 5\n",
           1.08393e-4, 0}};
  for (const auto& [text, deviation, next] : kTasks) {
    const Result result = solve_text(text);
    ASSERT_FALSE(result.designs.empty());
    const double best = quantity(result.designs[0], "deviation_relative");
    EXPECT_NEAR(best, deviation, 1e-5 * deviation);
    if (next > 0) {
      ASSERT_GT(result.designs.size(), 1u);
      EXPECT_NEAR(quantity(result.designs[1], "deviation_relative"), next, 1e-5 * next);
    }
    for (std::size_t i = 1; i < result.designs.size(); ++i) {
      EXPECT_GT(quantity(result.designs[i], "deviation_relative"), 1.02 * best);
    }
  }
}

}  // namespace
}  // namespace cognate::problems::classical_straight_lines_test
