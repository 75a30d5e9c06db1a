/// Robust chains judged by samples of the test's own: a slider-crank in complex numbers, which
/// shares nothing with the search.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/read_problems.hpp"

namespace cognate::problems::robust_chain_test {
namespace {

using Complex = std::complex<double>;

Complex complex_of(const Vec2d& at) {
  return {at.x, at.y};
}

/// A slider-crank with its coupler point: crank, coupler, offset of the guide, point along and
/// across the coupler.
struct Bars {
  Complex pivot, along;  ///< of crank and guide
  std::array<double, 5> dimensions{};
  double side = 1;

  Complex point(double crank) const {
    const auto& [radius, length, offset, u, v] = dimensions;
    const Complex pin = radius * std::polar(1.0, crank);
    const double below = (std::conj(along) * pin).imag() - offset;
    const double way =
        (std::conj(along) * pin).real() + side * std::sqrt(length * length - below * below);
    const Complex slider = along * Complex(way, offset);
    return pivot + pin + (slider - pin) / length * Complex(u, v);
  }

  double greatest_error(const std::vector<double>& cranks,
                        const std::vector<Vec2d>& targets) const {
    double most = 0;
    for (std::size_t j = 0; j < targets.size(); ++j) {
      const double error = std::abs(point(cranks[j]) - complex_of(targets[j]));
      if (!(error <= most)) most = error;
    }
    return most;
  }
};

Bars bars_of(const ChainPathProblem& problem, const Design& design) {
  const auto& chain = std::get<ChainDescription>(design.mechanism.description);
  const DyadDescription& dyad = chain.dyads.front();
  const SlideDescription& slide = dyad.slides.front();
  const Vec2d at = design.mechanism.extra_points.front().at;
  Bars bars{complex_of(chain.pivots.front().at),
            std::polar(1.0, slide.direction),
            {std::get<CrankDescription>(chain.drive).length, dyad.lengths.front(), slide.offset,
             at.x, at.y}};
  Bars other = bars;
  other.side = -1;
  const double one = bars.greatest_error(design.crank_angles, problem.points);
  return one <= other.greatest_error(design.crank_angles, problem.points) ? bars : other;
}

/// 90 % of the samples have no target farther than this from the point at its crank angle.
double quantile(const ChainPathProblem& problem, const Design& design) {
  constexpr int kSamples = 20'000;
  constexpr std::array kTolerances{0.1, 0.1, 0.3, 0.1, 0.1};
  const Bars nominal = bars_of(problem, design);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> errors;
  for (int k = 0; k < kSamples; ++k) {
    Bars made = nominal;
    for (std::size_t i = 0; i < kTolerances.size(); ++i) {
      made.dimensions[i] += kTolerances[i] / 3 * normal(random);
    }
    errors.push_back(made.greatest_error(design.crank_angles, problem.points));
  }
  std::ranges::sort(errors);
  return errors[static_cast<std::size_t>(0.9 * kSamples)];
}

using test::number;

ChainPathProblem problem_of(const std::string& text) {
  return test::problem_of<ChainPathProblem>(text);
}

std::string file(const std::string& mechanism, const std::string& solve) {
  return "kind = \"path-generation\"\n[target]\npoints = [[20, 30], [35, 42], [52, 46], [68, 42], "
         "[78, 31], [70, 22], [50, 18], [30, 20]]\ntiming = \"prescribed\"\ncrank_deg = [0, 40, "
         "80, 120, 170, 220, 270, 320]\n[mechanism]\n" +
         mechanism + "[tolerance]\nlength = 0.1\nslider-C = 0.3\nsamples = 0\n[solve]\n" + solve;
}

TEST(RobustChains, ASliderCrankErrsLessThanTheNominalOptimum) {
  const auto problem = problem_of(file("type = \"slider-crank\"\n", "robust = 0.9\nstarts = 64\n"));
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = number(result, "robust_quantile"),
               nominal = number(result, "nominal_quantile");
  EXPECT_LT(robust, 0.8 * nominal);
  const Design &first = result.designs.front(), &last = result.designs.back();
  EXPECT_NEAR(bars_of(problem, last).greatest_error(last.crank_angles, problem.points),
              last.error.max, 1e-9);
  EXPECT_NEAR(quantile(problem, first), robust, 0.03 * robust);
  EXPECT_NEAR(quantile(problem, last), nominal, 0.03 * nominal);
  EXPECT_LT(last.error.rms, first.error.rms);
  EXPECT_EQ(first.origin, "robust");
}

/// A length that the file gives stays, and its tolerance counts.
TEST(RobustChains, WhatIsGivenStaysAsItIs) {
  const auto problem = problem_of(
      file("type = \"slider-crank\"\n[crank]\nlength = 30\n", "robust = 0.9\nstarts = 64\n"));
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  for (const Design& design : result.designs) {
    const auto& chain = std::get<ChainDescription>(design.mechanism.description);
    EXPECT_DOUBLE_EQ(std::get<CrankDescription>(chain.drive).length, 30);
  }
  const Design& first = result.designs.front();
  const double robust = number(result, "robust_quantile");
  EXPECT_NEAR(quantile(problem, first), robust, 0.03 * robust);
}

/// Where the crank follows, the quantile is that of the evaluator of tolerances, which goes body by
/// body where the search goes by points.
TEST(RobustChains, PointsThatAreNotTimedAreMetWhereTheCrankFollows) {
  const auto problem = problem_of(
      "kind = \"path-generation\"\n[target]\npoints = [[20, 30], [35, 42], [52, 46], [68, 42], "
      "[78, "
      "31], [70, 22], [50, 18], [30, 20]]\n[mechanism]\ntype = "
      "\"slider-crank\"\n[tolerance]\nlength "
      "= 0.1\npivots = 0.05\nsamples = 200000\n[solve]\nrobust = 0.99\nstarts = 32\n");
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& first = result.designs.front();
  const auto q99 = find_quantity(first.metrics.quantities, QuantityKey<double>{"tolerance_q99"});
  ASSERT_TRUE(q99);
  EXPECT_NEAR(*q99, number(result, "robust_quantile"), 0.02 * *q99);
}

TEST(RobustChains, RefusesWhatItCannotDo) {
  const auto fault = [](const std::string& text) {
    const auto read = parse_task<ChainPathProblem>(text);
    return read ? std::string() : read.error().front().message;
  };
  const std::string type = "type = \"slider-crank\"\n";
  EXPECT_NE(fault(file(type, "robust = 2\n")).find("0.5 to 0.9999"), std::string::npos);
  EXPECT_NE(fault(file(type, "robust = 0.9\n[raster]\nlength = 1\n")).find("with a raster; remove"),
            std::string::npos);
  std::string without = file(type, "robust = 0.9\n");
  without.erase(without.find("[tolerance]"), without.find("[solve]") - without.find("[tolerance]"));
  EXPECT_NE(fault(without).find("without tolerances"), std::string::npos);
}

}  // namespace
}  // namespace cognate::problems::robust_chain_test
