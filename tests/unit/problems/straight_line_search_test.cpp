/// Parts and promises of the search for straight lines: derivatives, invariance, constraints kept,
/// planted linkages, the same for any number of threads.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/placing.hpp"
#include "problems/straight_line/starts.hpp"

namespace cognate::problems::straight_line_search_test {
namespace {

StraightLineProblem problem_of(const std::string& text) {
  const auto problem = parse_task("kind = \"straight-line\"\n" + text);
  EXPECT_TRUE(problem.has_value()) << (problem ? "" : problem.error()[0].message);
  return problem ? std::get<StraightLineProblem>(*problem) : StraightLineProblem{};
}

Result solve_text(const std::string& text, int threads = 0) {
  Run run;
  run.threads = threads;
  return solve(problem_of(text), run);
}

double quantity(const Design& design, const std::string& name) {
  for (const Quantity& f : design.metrics.quantities) {
    if (f.name == name) return std::get<double>(f.value);
  }
  ADD_FAILURE() << "no fact " << name;
  return NAN;
}

LinkageSegment a_segment(MechanismType type) {
  LinkageSegment segment;
  segment.type = type;
  segment.dimensions = {{0.7, 1.9, type == MechanismType::four_bar ? 1.7 : 0.2, 1.6}, {2.2, 0.6}};
  segment.centre = 2.7;
  segment.reach = 0.8;
  segment.line = 3.0;
  segment.height = 0.4;
  segment.length = 1.1;
  segment.pivot_a = {0.2, -0.1};
  segment.frame_angle = 0.3;
  return segment;
}

/// Central differences of residuals and constraints.
void expect_exact_derivatives(const StraightLineProblem& problem) {
  const SegmentModel model(problem, a_segment(problem.type), segment_nodes(8));
  const std::vector<double> x = model.variables_of(a_segment(problem.type));
  const auto rows = [&](const std::vector<double>& at) {
    std::vector<double> all(model.residual_count()), limits(model.constraint_count());
    EXPECT_TRUE(model.residuals(at, all, {}, {}));
    model.constraints(at, limits, {});
    all.insert(all.end(), limits.begin(), limits.end());
    return all;
  };
  const std::size_t n = x.size(), m = rows(x).size();
  std::vector<double> residuals(model.residual_count()), limits(model.constraint_count());
  std::vector<double> slopes(residuals.size() * n), limit_slopes(limits.size() * n);
  ASSERT_TRUE(model.residuals(x, residuals, slopes, {}));
  model.constraints(x, limits, limit_slopes);
  slopes.insert(slopes.end(), limit_slopes.begin(), limit_slopes.end());
  for (std::size_t j = 0; j < n; ++j) {
    constexpr double kStep = 1e-6;
    std::vector<double> above = x, below = x;
    above[j] += kStep;
    below[j] -= kStep;
    const auto high = rows(above), low = rows(below);
    for (std::size_t i = 0; i < m; ++i) {
      const double difference = (high[i] - low[i]) / (2 * kStep);
      EXPECT_NEAR(slopes[i * n + j], difference, 2e-7 * (1 + std::abs(difference)))
          << "row " << i << " by " << model.variables()[j].name;
    }
  }
}

TEST(SegmentModel, HasExactDerivatives) {
  expect_exact_derivatives(problem_of("[target]\nlength = 1\n"));
  expect_exact_derivatives(problem_of("[target]\ndeviation_relative = 0.01\ndirection_deg = 20\n"));
  expect_exact_derivatives(
      problem_of("[target]\ndeviation = 0.01\n[bounds]\nlength = [0.1, 5]\n"
                 "pivot_d = [[-9, -9], [9, 9]]\n[constraints]\nclass = \"crank-rocker\"\n"
                 "transmission_angle_deg = [30, 140]\nspeed_variation_max = 0.5\n"));
  expect_exact_derivatives(problem_of(
      "[target]\nlength = 1\nconstant_velocity = true\n"
      "[mechanism]\ntype = \"slider-crank\"\n[constraints]\nclass = \"crank-rocker\"\n"));
}

TEST(SegmentModel, HasExactDerivativesByItsPlace) {
  const std::string region = "[constraints]\npivot_region = [[-3, -2], [4, 5]]\n";
  expect_exact_derivatives(problem_of("[target]\nends = [[1, 2], [1.6, 2.8]]\n" + region));
  expect_exact_derivatives(
      problem_of("[target]\nends = [[1, 2], [1.6, 2.8]]\ndeviation = 0.01\n"
                 "[mechanism]\nfixed_pivots = [[0, 1], [2, 0]]\n" +
                 region));
  expect_exact_derivatives(
      problem_of("[target]\nends = [[0, 0], [-1, 0]]\n[mechanism]\nframe_angle_deg = 20\n"
                 "[bounds]\npivot_a = [[-9, -9], [9, 9]]\npivot_d = [[-9, -9], [9, 9]]\n"));
  expect_exact_derivatives(problem_of(
      "[target]\nends = [[0, 0], [0, 1]]\n[mechanism]\ntype = \"slider-crank\"\n" + region));
}

/// Half way from (1, 2) to (1.6, 2.8), and the direction from there.
constexpr Vec2d kMiddle{1.3, 2.4}, kAlong{0.6, 0.8};

void expect_on_line(const LinkageSegment& put) {
  const CouplerMotion<double> motion(put.type, put.dimensions, sign(put.assembly));
  const auto at = [&](double angle) {
    return put.pivot_a + unit_vector(put.frame_angle) * motion.at(angle).at;
  };
  const Vec2d along = kAlong, middle = kMiddle, first = at(put.from()), last = at(put.to());
  EXPECT_NEAR(dot(along, 0.5 * (first + last) - middle), 0, 1e-12);
  // The line is the middle of the strip: the curve is as far to one side of it as to the other.
  double least = 0, most = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double height = cross(along, at(put.from() + 2 * put.reach * i / 4000) - middle);
    least = std::min(least, height);
    most = std::max(most, height);
  }
  EXPECT_NEAR(least, -most, 1e-6);
}

/// A linkage has four places on a line: those that reflections in the line and in the perpendicular
/// through its middle make of one. A region about the pivots of any of them has it there.
TEST(SegmentModel, HasFourPlacesOnALine) {
  StraightLineProblem problem = problem_of(
      "[target]\nends = [[1, 2], [1.6, 2.8]]\n[constraints]\npivot_region = [[0, 0], [9, 9]]\n");
  for (const MechanismType type : {MechanismType::four_bar, MechanismType::slider_crank}) {
    problem.type = type;
    LinkageSegment segment = a_segment(type);
    ASSERT_TRUE(fit_line(segment));
    const LinkageSegment any = placed(problem, segment);
    for (const double across : {1.0, -1.0}) {
      for (const double back : {1.0, -1.0}) {
        const auto image = [&](const Vec2d& point) {
          const Vec2d own = conj(kAlong) * (point - kMiddle);
          return kMiddle + kAlong * Vec2d{back * own.x, across * own.y};
        };
        const Vec2d frame = any.dimensions.links[3] * unit_vector(any.frame_angle);
        const Vec2d a = image(any.pivot_a), d = image(any.pivot_a + frame);
        problem.constraints.pivot_region = type == MechanismType::slider_crank
                                               ? Box{a, a}
                                               : Box{{std::min(a.x, d.x), std::min(a.y, d.y)},
                                                     {std::max(a.x, d.x), std::max(a.y, d.y)}};
        const LinkageSegment put = placed(problem, segment);
        EXPECT_NEAR(place_violation(problem, put), 0, 1e-12);
        EXPECT_NEAR(norm(put.pivot_a - a), 0, 1e-12);
        expect_on_line(put);
      }
    }
  }
}

TEST(SegmentStarts, AreStretchesOfTheirOwnCurves) {
  const StraightLineProblem problem = problem_of("[target]\nlength = 1\n");
  SegmentStarts starts(problem);
  int found = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    const auto start = starts.draw(3, i);
    if (!start) continue;
    ++found;
    LinkageSegment fitted = start->segment;
    EXPECT_LT(largest_dimension(fitted), 2 + 1e-9) << i;
    EXPECT_NEAR(fitted.length, 1, 1e-12);
    const auto deviation = fit_line(fitted);
    ASSERT_TRUE(deviation) << i;
    EXPECT_NEAR(fitted.length, 1, 1e-3) << i;
    // Between the samples the curve strays a little farther.
    EXPECT_GE(*deviation, start->score * (1 - 1e-9)) << i;
    EXPECT_LE(*deviation, start->score * 3 + 2e-3) << i;
  }
  EXPECT_GT(found, 20);
}

constexpr const char* kSmall = "[solve]\nstarts = 24\ndesigns = 1\n";

TEST(StraightLineSearch, IsTheSameForAnyNumberOfThreads) {
  const std::string text =
      "[target]\nlength = 1\n[constraints]\nclass = \"double-rocker\"\n" + std::string(kSmall);
  const Result one = solve_text(text, 1), three = solve_text(text, 3);
  ASSERT_EQ(one.designs.size(), three.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(four_bar(one.designs[i]).crank, four_bar(three.designs[i]).crank);
    EXPECT_EQ(quantity(one.designs[i], "deviation"), quantity(three.designs[i], "deviation"));
  }
}

/// A problem a thousand times as large, its line turned, has the same linkage as large and turned.
TEST(StraightLineSearch, KnowsNeitherScaleNorDirection) {
  const std::string rest = "[constraints]\nclass = \"crank-rocker\"\nsize_over_length_max = 1.5\n" +
                           std::string("[solve]\nstarts = 60\ndesigns = 1\n");
  const Result own = solve_text("[target]\nlength = 1\n" + rest);
  const Result large = solve_text("[target]\nlength = 1000\ndirection_deg = 35\n" + rest);
  ASSERT_EQ(own.status, Status::solved);
  ASSERT_EQ(large.status, Status::solved);
  EXPECT_NEAR(quantity(large.designs[0], "deviation_relative") /
                  quantity(own.designs[0], "deviation_relative"),
              1, 1e-4);
  const double off = quantity(large.designs[0], "direction_deg") - 35;
  EXPECT_NEAR(std::remainder(off, 180), 0, 1e-5);
  EXPECT_NEAR(quantity(large.designs[0], "straight_length"), 1000, 1e-3);
}

/// Of Hoeken's point, the deviation over a length of 1 in the middle of his stretch.
double hoekens_deviation(const FourBar& linkage) {
  const Path path = path_of(as_mechanism(linkage), {2, *linkage.coupler_point});
  double low = 0.1, high = 1;
  for (int step = 0; step < 50; ++step) {
    const double reach = 0.5 * (low + high);
    (measure(path, kPi - reach, kPi + reach).length < 1 ? low : high) = reach;
  }
  return measure(path, kPi - low, kPi + low).deviation;
}

/// Links of Hoeken's kind are given; his point, or a better one, and the place of the stretch are
/// found.
TEST(StraightLineSearch, FindsAPlantedPoint) {
  const Result result = solve_text(
      "[target]\nlength = 1\n[mechanism]\ncrank = 1\ncoupler = 2.5\nrocker = 2.5\nframe = 2\n"
      "[constraints]\nsize_over_length_max = 6\n" +
      std::string(kSmall));
  ASSERT_EQ(result.status, Status::solved);
  const FourBar& found = four_bar(result.designs[0]);
  EXPECT_EQ(found.crank, 1);
  EXPECT_EQ(found.coupler, 2.5);
  EXPECT_EQ(found.rocker, 2.5);
  EXPECT_NEAR(norm(found.pivot_d - found.pivot_a), 2, 1e-12);
  const double classical =
      hoekens_deviation({{0, 0}, {2, 0}, 1, 2.5, 2.5, Assembly::open, Vec2d{5, 0}});
  EXPECT_LE(quantity(result.designs[0], "deviation_relative"), classical);
}

TEST(StraightLineSearch, KeepsToItsConstraints) {
  const Result result = solve_text(
      "[target]\nlength = 20\ndirection_deg = 90\nconstant_velocity = true\n"
      "[mechanism]\npivot_a = [3, 4]\n[bounds]\nlength = [2, 40]\n"
      "coupler_point = [[-40, -40], [40, 40]]\n"
      "[constraints]\nclass = \"crank-rocker\"\ntransmission_angle_deg = [35, 145]\n"
      "crank_range_deg = [80, 180]\npivot_region = [[-50, -50], [60, 60]]\nlink_ratio_max = 6\n"
      "size_over_length_max = 2\n[solve]\ndesigns = 1\n");
  ASSERT_EQ(result.status, Status::solved);
  const Design& best = result.designs[0];
  EXPECT_GE(best.constraints.size(), 12U);
  EXPECT_TRUE(all_satisfied(best.constraints));
  EXPECT_EQ(four_bar(best).pivot_a, (Vec2d{3, 4}));
  EXPECT_EQ(best.metrics.mobility, MobilityClass::crank_rocker);
  EXPECT_GT(best.metrics.transmission_acute_min, 35 * kPi / 180 - 1e-6);
  EXPECT_LE(quantity(best, "speed_variation"), 0.1 * (1 + 1e-6));
  EXPECT_LE(quantity(best, "size_over_length"), 2 * (1 + 1e-6));
  const double range = quantity(best, "crank_to_deg") - quantity(best, "crank_from_deg");
  EXPECT_GT(range, 80 - 1e-4);
  EXPECT_LT(range, 180 + 1e-4);
}

/// No linkage of that size is that straight: the nearest is reported, with what it violates.
TEST(StraightLineSearch, ReportsWhatCannotBe) {
  const Result result = solve_text(
      "[target]\nlength = 1\ndeviation_relative = 1e-6\n[constraints]\nclass = \"crank-rocker\"\n"
      "size_over_length_max = 0.7\n[solve]\nstarts = 10\ndesigns = 1\n");
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_FALSE(result.designs.empty());
  EXPECT_FALSE(all_satisfied(result.designs[0].constraints));
}

TEST(StraightLineSearch, StopsInTime) {
  std::atomic<bool> stop{true};
  problems::Run run;
  run.interrupted = &stop;
  const Result result = solve(problem_of("[target]\nlength = 1\n"), run);
  EXPECT_EQ(result.status, Status::interrupted);
  run.interrupted = nullptr;
  run.time_limit = 1e-9;
  EXPECT_EQ(solve(problem_of(""), run).status, Status::time_limit);
}

/// A change of speed is limited between the nodes of the refinement too; the search that looked at
/// nodes alone missed this limit by a thousandth.
TEST(StraightLineSearch, KeepsTheSpeedBetweenNodes) {
  const Result result = solve_text(
      "[target]\nlength = 1\n[constraints]\nclass = \"crank-rocker\"\n"
      "crank_range_deg = [90, 180]\nsize_over_length_max = 1.5\nspeed_variation_max = 0.1\n");
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LE(quantity(result.designs[0], "speed_variation"), 0.1 * (1 + 1e-6));
}

/// What a narrower range of the crank allows, a wider one allows too.
TEST(StraightLineSearch, FindsInAWiderRangeWhatANarrowerOneHolds) {
  const auto deviation = [](const std::string& range) {
    const Result result = solve_text(
        "target.length = 1\nconstraints = {class = \"crank-rocker\", size_over_length_max = 1.5, "
        "crank_range_deg = " +
        range + "}");
    return result.designs.empty() ? NAN : quantity(result.designs[0], "deviation_relative");
  };
  EXPECT_LE(deviation("[90, 180]"), 1.001 * deviation("[90, 110]"));
}

/// The deviation of a linkage that is given is greatest between the nodes of the fit, by little.
TEST(StraightLineSearch, MeetsALimitOnTheDeviationBetweenItsNodesToo) {
  const Result result = solve_text(
      "[target]\ndeviation = 0.05\n[mechanism]\ncoupler_point = [4.96, 0]\ncrank = 2.65\n"
      "coupler = 4.18\nrocker = 5.1\nframe = 3.92\n[constraints]\nclass = \"crank-rocker\"\n"
      "size_over_length_max = 3\n[solve]\nstarts = 60\n");
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LE(quantity(result.designs[0], "deviation"), 0.05 * (1 + 1e-6));
  // The longest by a scan of all segments.
  EXPECT_GT(quantity(result.designs[0], "straight_length"), 3.82);
}

TEST(StraightLineSearch, HasAFrontThatFalls) {
  const Result result = solve_text(
      "[constraints]\nclass = \"crank-rocker\"\nsize_over_length_max = 1.5\n[solve]\nstarts = "
      "24\n");
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.families.size(), 1U);
  const auto& columns = result.families[0].columns;
  ASSERT_GE(columns[0].values.size(), 3U);
  for (std::size_t i = 1; i < columns[0].values.size(); ++i) {
    EXPECT_LT(columns[0].values[i], columns[0].values[i - 1]);
    EXPECT_GT(columns[1].values[i], columns[1].values[i - 1]);
  }
}

}  // namespace
}  // namespace cognate::problems::straight_line_search_test
