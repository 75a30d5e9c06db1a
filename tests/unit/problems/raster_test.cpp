/// Designs on a raster against all combinations, evaluated by code of the test's own: the
/// textbook's triangles for closure, samples of the crank refined by golden sections.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/pivot_model.hpp"
#include "problems/path/scale.hpp"
#include "problems/read.hpp"
#include "synthesis/optimise/check_derivatives.hpp"
#include "tests/support/read_problems.hpp"

namespace cognate::problems::raster_test {
namespace {

using test::flag;
using test::number;
using test::problem_of;

struct Bar {
  double crank, coupler, rocker;
  Vec2d a, d, uv;
};

/// B and C by the law of cosines, `side` +1 where C is to the left of B→D.
std::optional<std::array<Vec2d, 2>> joints(const Bar& bar, double angle, int side) {
  const Vec2d b = bar.a + bar.crank * Vec2d{std::cos(angle), std::sin(angle)};
  const double way = std::hypot(bar.d.x - b.x, bar.d.y - b.y);
  const double cosine =
      (bar.coupler * bar.coupler + way * way - bar.rocker * bar.rocker) / (2 * bar.coupler * way);
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  const double to = std::atan2(bar.d.y - b.y, bar.d.x - b.x) + side * std::acos(cosine);
  return std::array{b, b + bar.coupler * Vec2d{std::cos(to), std::sin(to)}};
}

std::optional<Vec2d> coupler_point(const Bar& bar, double angle, int side) {
  const auto at = joints(bar, angle, side);
  if (!at) return std::nullopt;
  const Vec2d along = (1 / bar.coupler) * ((*at)[1] - (*at)[0]);
  return (*at)[0] + along * bar.uv;
}

/// Σ squared distances of timed points, the first crank angle free: scanned, then by golden
/// sections.
double timed_error(const Bar& bar, const std::vector<Vec2d>& points,
                   const std::vector<double>& steps) {
  const auto sum = [&](double first, int side, double sense) {
    double all = 0;
    for (std::size_t j = 0; j < points.size(); ++j) {
      const auto p = coupler_point(bar, first + sense * steps[j], side);
      if (!p) return std::numeric_limits<double>::infinity();
      const Vec2d off = *p - points[j];
      all += off.x * off.x + off.y * off.y;
    }
    return all;
  };
  double best = std::numeric_limits<double>::infinity();
  constexpr int kScan = 720;
  for (const int side : {-1, 1}) {
    for (const double sense : {-1.0, 1.0}) {
      int least = 0;
      double value = std::numeric_limits<double>::infinity();
      for (int k = 0; k < kScan; ++k) {
        const double at = sum(kTurn * k / kScan, side, sense);
        if (at < value) value = at, least = k;
      }
      double low = kTurn * (least - 1) / kScan, high = kTurn * (least + 1) / kScan;
      for (int i = 0; i < 80; ++i) {
        const double one = low + 0.381966 * (high - low), two = high - 0.381966 * (high - low);
        (sum(one, side, sense) < sum(two, side, sense) ? high : low) =
            sum(one, side, sense) < sum(two, side, sense) ? two : one;
      }
      best = std::min({best, value, sum(0.5 * (low + high), side, sense)});
    }
  }
  return best;
}

/// Near-crank-rocker dimensions on a coarse raster, four or five values each of which the file
/// allows two.
struct TinyProblem {
  std::vector<double> crank, coupler, rocker, u, v;
  Vec2d d;
  std::vector<Vec2d> points;
  std::vector<double> steps;

  std::string text() const {
    std::string rows, angles;
    for (std::size_t j = 0; j < points.size(); ++j) {
      rows += fmt::format("[{}, {}],", points[j].x, points[j].y);
      angles += fmt::format("{},", steps[j] * 180 / kPi);
    }
    return fmt::format(
        "kind = \"path-generation\"\n[target]\npoints = [{}]\ntiming = \"prescribed\"\n"
        "crank_deg = [{}]\n[mechanism]\npivot_a = [0, 0]\npivot_d = [{}, {}]\n"
        "[bounds]\ncoupler_point = [[{}, {}], [{}, {}]]\n"
        "[constraints]\nno_branch_defect = false\nno_circuit_defect = false\n"
        "no_order_defect = false\n[raster]\ncrank = [{}]\ncoupler = [{}]\nrocker = [{}]\n"
        "coupler_point = 0.5\n[solve]\ndesigns = 1\nstarts = 60\n",
        rows, angles, d.x, d.y, u.front(), v.front(), u.back(), v.back(), fmt::join(crank, ", "),
        fmt::join(coupler, ", "), fmt::join(rocker, ", "));
  }
};

TinyProblem tiny(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> share(0, 1);
  TinyProblem made;
  const double crank = 1 + share(random), coupler = 3 + 2 * share(random);
  const double rocker = 2.5 + 2 * share(random);
  for (int k = 0; k < 3; ++k) {
    made.crank.push_back(std::round(20 * (crank * (0.9 + 0.1 * k))) / 20);
    made.coupler.push_back(std::round(20 * (coupler * (0.9 + 0.1 * k))) / 20);
    made.rocker.push_back(std::round(20 * (rocker * (0.9 + 0.1 * k))) / 20);
  }
  const double u = std::round(4 * share(random)) / 2, v = std::round(4 * share(random)) / 2 - 1;
  for (int k = 0; k < 3; ++k) {
    made.u.push_back(u + 0.5 * k);
    made.v.push_back(v + 0.5 * k);
  }
  made.d = {4 + share(random), share(random)};
  const Bar bar{crank, coupler, rocker, {0, 0}, made.d, {u + 0.3, v + 0.7}};
  const double first = kTurn * share(random);
  const int side = share(random) < 0.5 ? -1 : 1;
  for (int j = 0; j < 6; ++j) {
    made.steps.push_back(0.35 * j);
    const auto p = coupler_point(bar, first + 0.35 * j, side);
    if (!p) return tiny(seed + 1000);
    made.points.push_back(*p + Vec2d{0.1 * share(random), 0.1 * share(random)});
  }
  return made;
}

double least_of_all(const TinyProblem& problem) {
  double best = std::numeric_limits<double>::infinity();
  for (const double crank : problem.crank) {
    for (const double coupler : problem.coupler) {
      for (const double rocker : problem.rocker) {
        for (const double u : problem.u) {
          for (const double v : problem.v) {
            const Bar bar{crank, coupler, rocker, {0, 0}, problem.d, {u, v}};
            best = std::min(best, timed_error(bar, problem.points, problem.steps));
          }
        }
      }
    }
  }
  return best;
}

TEST(PathRaster, TimedPathsAreTheBestOfAllCombinations) {
  for (int seed = 0; seed < 12; ++seed) {
    const TinyProblem tiny_problem = tiny(seed);
    const auto problem = problem_of<PathProblem>(tiny_problem.text());
    const Result result = solve(problem, {.threads = 1});
    ASSERT_EQ(result.status, Status::solved) << "seed " << seed;
    const double best = least_of_all(tiny_problem);
    const Design& design = result.designs.front();
    EXPECT_NEAR(design.error.sum_of_squares, best, 1e-7 * best) << "seed " << seed;
    EXPECT_TRUE(flag(result, "raster_proven"));
    EXPECT_EQ(number(result, "raster_combinations"), 243);
  }
}

/// Branch and bound instead of enumeration finds the same design.
TEST(PathRaster, PlantedDesignsAreFoundExactly) {
  const Bar planted{2, 5.5, 4.5, {1, -0.5}, {6.5, 0.5}, {3, 1.5}};
  std::string rows;
  for (int j = 0; j < 12; ++j) {
    const Vec2d p = *coupler_point(planted, kTurn * j / 12 + 0.3, 1);
    rows += fmt::format("[{}, {}],", p.x, p.y);
  }
  const auto problem = problem_of<PathProblem>(
      "kind = \"path-generation\"\n[target]\npoints = [" + rows +
      "]\n[raster]\nlength = 0.5\n[bounds]\nlength = [1, 20]\n[solve]\ndesigns = 1\n");
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const FourBar& found = four_bar(result.designs.front());
  EXPECT_LT(result.designs.front().error.max, 1e-9);
  for (const double value :
       {found.crank, found.coupler, found.rocker, found.pivot_a.x, found.pivot_a.y, found.pivot_d.x,
        found.pivot_d.y, found.coupler_point->x, found.coupler_point->y}) {
    EXPECT_EQ(value, std::round(2 * value) / 2);  // exactly, not to rounding
  }
  EXPECT_EQ(found.crank, 2);
}

TEST(PathRaster, PivotModelHasExactDerivatives) {
  const auto problem = problem_of<PathProblem>(
      "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0.4], [1.5, 1], [0.5, 1.2]]\n"
      "[bounds]\nframe = [0.5, 9]\nframe_angle_deg = [-60, 80]\npivot_d = [[-9, -9], [9, 9]]\n"
      "[constraints]\nclass = \"crank-rocker\"\ntransmission_angle_deg = [30, 150]\n");
  const PathProblem scaled = PathScale(problem).into(problem);
  const PivotPathModel model(scaled, Assembly::open, false);
  const FourBar linkage{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};
  const PathModel inner(scaled, Assembly::open, false);
  const auto x = inner.variables_of(linkage, std::vector<double>{0.1, 0.8, 1.7, 3});
  const auto worst = synthesis::check_derivatives(model, model.outwards(x));
  EXPECT_TRUE(worst.has_value);
  EXPECT_LT(worst.relative, 1e-6) << worst.describe(model);
  const auto back = model.inwards(model.outwards(x));
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(std::remainder(back[i] - x[i], kTurn), 0, 1e-12);
}

/// Four lengths on the raster, place and coupler point free: as good as the library's long search
/// for the same lengths, which is no proof.
TEST(PathRaster, WhatStaysFreeBesideItIsSearchedByItself) {
  const std::string target =
      "kind = \"path-generation\"\n[target]\npoints = [[10, 18], [18, 22], [24, 15], [19, 8], [27, "
      "4], [20, -3]]\n[bounds]\nlength = [5, 50]\n";
  const Result on_raster = solve(
      problem_of<PathProblem>(target + "[solve]\nstarts = 8\n[raster]\ncrank = [10]\ncoupler = "
                                       "[20]\nrocker = [25]\nframe = [30]\n"),
      {.threads = 1});
  const Result given =
      solve(problem_of<PathProblem>(target + "[mechanism]\ncrank = 10\ncoupler = 20\nrocker = "
                                             "25\nframe = 30\n[solve]\nstarts = 600\n"),
            {.threads = 1});
  ASSERT_EQ(on_raster.status, Status::solved);
  ASSERT_EQ(given.status, Status::solved);
  EXPECT_LE(number(on_raster, "raster_error"), 1.001 * given.designs.front().error.rms);
  EXPECT_FALSE(flag(on_raster, "raster_proven"));
  EXPECT_TRUE(flag(on_raster, "raster_complete"));
  const bool says_so = std::ranges::any_of(on_raster.notes, [](const std::string& note) {
    return note.find("which is no proof") != std::string::npos;
  });
  EXPECT_TRUE(says_so);
}

std::string fault_of(const std::string& text) {
  const auto problem = parse_task(text);
  return problem ? "" : problem.error().front().message;
}

TEST(RasterReading, RefusesWhatMakesNoSense) {
  const std::string head =
      "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0.4], [1.5, 1]]\n";
  EXPECT_NE(fault_of(head + "[raster]\nlength = 0\n").find("length"), std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\ncrank = []\n").find("crank"), std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\ncrank = [1, 1]\n").find("twice"), std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\nboxes = 5\n").find("no dimension"), std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\nlength = 1\nframe = 2\n").find("frame"), std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\nlength = 1\n[mechanism]\nframe = 2\n").find("frame"),
            std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\nlength = 7\n[bounds]\nlength = [1, 6]\n").find("no value"),
            std::string::npos);
  EXPECT_NE(fault_of(head + "[raster]\nlength = 1\n[solve]\nloss = \"huber\"\nloss_scale = 1\n")
                .find("loss"),
            std::string::npos);
  EXPECT_EQ(fault_of(head + "[raster]\nlength = 1\npivots = \"free\"\nframe = [2, 3]\n"), "");
}

}  // namespace
}  // namespace cognate::problems::raster_test
