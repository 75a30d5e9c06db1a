/// Designs of least worst case, judged by every corner of their tolerances and by points of its
/// edges and faces, with triangles of the test's own; and held against designs near them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/support/changed_four_bar.hpp"

namespace cognate::problems::worst_case_design_test {
namespace {

using Numbers = std::vector<double>;
/// The error of a design whose dimensions are changed.
using ErrorOf = std::function<double(const Numbers& changes)>;

/// A share from −1 to 1.
double share(std::mt19937_64& random) {
  return 2 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1;
}

/// The greatest error over the corners of the box of ±`tolerance`.
double at_corners(std::size_t dimensions, double tolerance, const ErrorOf& error) {
  double worst = 0;
  for (std::size_t corner = 0; corner < std::size_t{1} << dimensions; ++corner) {
    Numbers changes(dimensions);
    for (std::size_t i = 0; i < dimensions; ++i) {
      changes[i] = (corner >> i & 1U) != 0 ? tolerance : -tolerance;
    }
    worst = std::max(worst, error(changes));
  }
  return worst;
}

/// The same over points of its edges, faces and inside: each change at an end in two of three
/// cases.
double elsewhere(std::size_t dimensions, double tolerance, const ErrorOf& error) {
  std::mt19937_64 random(5);
  double worst = 0;
  for (int k = 0; k < 5000; ++k) {
    Numbers changes(dimensions);
    for (double& change : changes) {
      change = share(random);
      if (random() % 3 != 0) change = change < 0 ? -1 : 1;
      change *= tolerance;
    }
    worst = std::max(worst, error(changes));
  }
  return worst;
}

double fact(const Result& result, std::string_view name) {
  return find_quantity(result.quantities, QuantityKey<double>{name}).value_or(-1);
}

double size(const Vec2d& v) {
  return std::hypot(v.x, v.y);
}

/// Every dimension of a design and the directions of its crank moved by up to `by` of its size.
FourBar moved(FourBar bar, double by, std::mt19937_64& random) {
  const double step = by * size(bar.pivot_d - bar.pivot_a);
  for (double* length : {&bar.crank, &bar.coupler, &bar.rocker}) *length += step * share(random);
  for (Vec2d* place : {&bar.pivot_a, &bar.pivot_d, &*bar.coupler_point}) {
    *place = *place + step * Vec2d{share(random), share(random)};
  }
  return bar;
}

constexpr std::string_view kTimedPath =
    "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1.9, 0.4], [3.1, 1.4], [3.4, 2.6], "
    "[2.8, 3.6], [1.5, 3.9]]\ntiming = \"prescribed\"\ncrank_deg = [0, 30, 60, 90, 120, 150]\n"
    "[bounds]\nlength = [0.5, 12]\n[tolerance]\nlength = 0.1\n[solve]\nrobust = \"worst\"\n"
    "starts = 100\n";

TEST(WorstCaseDesign, TimedPathErrsLeastAtItsWorstCorner) {
  const auto problem = parse_task<PathProblem>(kTimedPath);
  ASSERT_TRUE(problem);
  const Result result = solve(*problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_worst_case");
  const double nominal = fact(result, "nominal_worst_case");
  EXPECT_LT(robust, 0.95 * nominal);
  const auto worst = [&](const FourBar& bar, const Numbers& angles) {
    return at_corners(6, 0.1, [&](const Numbers& changes) {
      return test::changed_path_error(bar, changes, angles, problem->points, 0);
    });
  };
  const Design &first = result.designs.front(), &last = result.designs.back();
  EXPECT_NEAR(worst(four_bar(first), first.crank_angles), robust, 1e-6 * robust);
  EXPECT_NEAR(worst(four_bar(last), last.crank_angles), nominal, 1e-6 * nominal);
  EXPECT_LE(elsewhere(6, 0.1,
                      [&](const Numbers& changes) {
                        return test::changed_path_error(four_bar(first), changes,
                                                        first.crank_angles, problem->points, 0);
                      }),
            robust * (1 + 1e-6));
  std::mt19937_64 random(11);
  for (int k = 0; k < 3000; ++k) {
    const FourBar near = moved(four_bar(first), 0.01 * std::pow(10, -double(k % 3)), random);
    if (std::max({near.crank, near.coupler, near.rocker, size(near.pivot_d - near.pivot_a)}) > 12) {
      continue;
    }
    EXPECT_GE(worst(near, first.crank_angles), robust * (1 - 1e-3));
  }
}

TEST(WorstCaseDesign, UntimedPathHasItsCrankFollow) {
  const auto problem = parse_task<PathProblem>(
      "kind = \"path-generation\"\n[target]\npoints = [[20, 10], [17.66, 15.142], "
      "[11.736, 17.878], [5, 16.928], [0.60307, 12.736], [0.60307, 7.2638], [5, 3.0718], "
      "[11.736, 2.1215], [17.66, 4.8577], [20, 10]]\n[bounds]\nlength = [5, 30]\n"
      "[tolerance]\nlength = 0.05\n[solve]\nrobust = \"worst\"\nstarts = 200\n");
  ASSERT_TRUE(problem);
  const Result result = solve(*problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_worst_case");
  const double nominal = fact(result, "nominal_worst_case");
  EXPECT_LT(robust, nominal);
  const Design& first = result.designs.front();
  EXPECT_NEAR(at_corners(6, 0.05,
                         [&](const Numbers& changes) {
                           return test::changed_path_error(
                               four_bar(first), changes, first.crank_angles, problem->points, 0.1);
                         }),
              robust, 1e-3 * robust);
  ASSERT_EQ(result.families.size(), 1U);
  const auto& columns = result.families.front().columns;
  EXPECT_EQ(columns[1].name, "worst_case");
  EXPECT_TRUE(std::ranges::is_sorted(columns[0].values));
  EXPECT_TRUE(std::ranges::is_sorted(columns[1].values, std::ranges::greater{}));
}

/// The greatest error of a sine generator over its samples: links crank, coupler, rocker, frame,
/// start angles of crank and rocker.
double sine_error(const Numbers& links, Assembly assembly, double input, double output) {
  double greatest = 0;
  for (int i = 0; i <= 60; ++i) {
    const double x = kPi / 2 * i / 60;
    const double bx = links[0] * std::cos(input + x) - links[3];
    const double by = links[0] * std::sin(input + x), diagonal = std::hypot(bx, by);
    const double at_d =
        std::acos((links[2] * links[2] + diagonal * diagonal - links[1] * links[1]) /
                  (2 * links[2] * diagonal));
    const double found = std::atan2(by, bx) + (assembly == Assembly::open ? -at_d : at_d);
    const double error =
        std::abs(std::remainder(found - output - kPi / 2 * std::sin(x), kTurn)) / kDegree;
    if (!(error <= greatest)) greatest = error;
  }
  return std::isnan(greatest) ? std::numeric_limits<double>::infinity() : greatest;
}

TEST(WorstCaseDesign, SineErrsLeastAtItsWorstCorner) {
  const auto problem = parse_task<FunctionProblem>(
      "kind = \"function-generation\"\n[target]\nfunction = \"sin(x)\"\ndomain = [0, \"pi/2\"]\n"
      "input_range_deg = 90\noutput_range_deg = 90\nsamples = 61\n[mechanism]\nframe = 1\n"
      "[bounds]\ncrank = [0.02, 50]\ncoupler = [0.02, 50]\nrocker = [0.02, 50]\n[tolerance]\n"
      "length = 0.01\n[solve]\nrobust = \"worst\"\n");
  ASSERT_TRUE(problem);
  const Result result = solve(*problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_worst_case_deg");
  EXPECT_LT(robust, 0.6 * fact(result, "nominal_worst_case_deg"));
  const Design& design = result.designs.front();
  const FourBar& bar = four_bar(design);
  const Numbers links{bar.crank, bar.coupler, bar.rocker, 1};
  const double input = *design.metrics.input_start, output = *design.metrics.output_start;
  const auto worst = [&](const Numbers& all, double from, double to) {
    return at_corners(4, 0.01, [&](Numbers changes) {
      for (std::size_t i = 0; i < all.size(); ++i) changes[i] += all[i];
      return sine_error(changes, bar.assembly, from, to);
    });
  };
  EXPECT_NEAR(worst(links, input, output), robust, 1e-6 * robust);
  std::mt19937_64 random(13);
  for (int k = 0; k < 3000; ++k) {
    Numbers near = links;
    const double by = 0.01 * std::pow(10, -double(k % 3));
    for (std::size_t i = 0; i < 3; ++i)
      near[i] = std::min(50.0, near[i] * (1 + by * share(random)));
    EXPECT_GE(worst(near, input + by * share(random), output + by * share(random)),
              robust * (1 - 1e-3));
  }
}

TEST(WorstCaseDesign, ReadsAndWritesItsWord) {
  const auto problem = parse_task<PathProblem>(kTimedPath);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->solve.robust, 1.0);
  const auto fault = [](std::string text) {
    const auto wrong = parse_task<PathProblem>(text.replace(text.find("\"worst\""), 7, "\"best\""));
    return wrong ? std::string() : wrong.error().front().message;
  };
  EXPECT_NE(fault(std::string(kTimedPath)).find("\"worst\""), std::string::npos)
      << fault(std::string(kTimedPath));
  EXPECT_TRUE(KindTraits<PathProblem>::checked(*problem));
}

}  // namespace
}  // namespace cognate::problems::worst_case_design_test
