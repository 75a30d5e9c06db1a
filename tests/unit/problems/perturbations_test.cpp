/// How variables move with their dimensions: moments of the tolerances, slopes by differences.
#include "problems/search/perturbations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cognate::problems::perturbations_test {
namespace {

/// A length whose variable is its logarithm, off by −0.1 to +0.3, and a coordinate in units of 4.
RobustStart start() {
  RobustStart made;
  made.x = {std::log(2.0), 0.5};
  made.dimensions = {{"crank", 2, {.plus = 0.3, .minus = 0.1}},
                     {"coupler_point.u", 2, {.plus = 0.2, .minus = 0.2}}};
  made.variables = {{.variable = 0, .is_logarithm = true}, {.variable = 1, .scale = 4}};
  return made;
}

/// The dimensions in each sample.
std::vector<std::vector<double>> dimensions(const synthesis::Perturbation& perturbation) {
  const RobustStart from = start();
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < perturbation.count(); ++k) {
    std::vector<double> moved(2), slope(2);
    perturbation.move(from.x, k, moved, slope);
    all.push_back({std::exp(moved[0]), 4 * moved[1]});
  }
  return all;
}

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments(const std::vector<std::vector<double>>& all, std::size_t of) {
  Moments made;
  for (const auto& one : all) made.mean += one[of] / double(all.size());
  for (const auto& one : all) {
    made.deviation += std::pow(one[of] - made.mean, 2) / double(all.size());
  }
  made.deviation = std::sqrt(made.deviation);
  return made;
}

TEST(Perturbations, SpreadHasTheMomentsOfTheTolerances) {
  const RobustStart from = start();
  for (const double share : {1.0, 0.5}) {
    const SpreadPerturbation normal(from, ToleranceDistribution::normal, share);
    EXPECT_NEAR(moments(dimensions(normal), 0).mean, 2 + share * 0.1, 1e-14);
    EXPECT_NEAR(moments(dimensions(normal), 0).deviation, share * 0.2 / 3, 1e-14);
    EXPECT_NEAR(moments(dimensions(normal), 1).mean, 2, 1e-14);
    EXPECT_NEAR(moments(dimensions(normal), 1).deviation, share * 0.2 / 3, 1e-14);
    const SpreadPerturbation uniform(from, ToleranceDistribution::uniform, share);
    EXPECT_NEAR(moments(dimensions(uniform), 0).deviation, share * 0.2 / std::sqrt(3.0), 1e-14);
  }
}

TEST(Perturbations, DrawnSamplesHaveThemWithinFourStandardErrors) {
  constexpr std::size_t kCount = 100'000;
  const RobustStart from = start();
  const DrawnPerturbation drawn(from, ToleranceDistribution::normal, 3, kCount);
  const auto all = dimensions(drawn);
  const double sigma = 0.2 / 3;
  for (const std::size_t of : {0U, 1U}) {
    const Moments made = moments(all, of);
    EXPECT_NEAR(made.mean, of == 0 ? 2.1 : 2.0, 4 * sigma / std::sqrt(double(kCount)));
    EXPECT_NEAR(made.deviation, sigma, 4 * sigma / std::sqrt(2.0 * kCount));
  }
}

TEST(Perturbations, SlopesAreThoseOfDifferences) {
  const RobustStart from = start();
  const SpreadPerturbation spread(from, ToleranceDistribution::normal, 1);
  const DrawnPerturbation drawn(from, ToleranceDistribution::normal, 3, 4);
  for (const synthesis::Perturbation* one : {static_cast<const synthesis::Perturbation*>(&spread),
                                             static_cast<const synthesis::Perturbation*>(&drawn)}) {
    for (std::size_t k = 0; k < one->count(); ++k) {
      constexpr double kStep = 1e-5;
      std::vector<double> moved(2), slope(2), more(2), less(2), none(2);
      one->move(from.x, k, moved, slope);
      one->move(std::vector{from.x[0] + kStep, from.x[1] + kStep}, k, more, none);
      one->move(std::vector{from.x[0] - kStep, from.x[1] - kStep}, k, less, none);
      for (const std::size_t i : {0U, 1U}) {
        EXPECT_NEAR(slope[i], (more[i] - less[i]) / (2 * kStep), 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace cognate::problems::perturbations_test
