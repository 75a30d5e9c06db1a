/// The three nine-point problems of Wampler, Morgan & Sommese (J. Mech. Des. 114, 1992): 1442
/// triplets of cognates each, of which 21, 45 and 64 are real; and the numbers of solutions of the
/// Alt–Burmester problems (Brake et al., J. Mech. Rob. 8, 2016).
#include "synthesis/exact/nine_point/nine_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cognate::synthesis::nine_point_test {
namespace {

struct Published {
  const char* name;
  std::vector<Vec2d> points;
  int real;
};

const std::vector<Published> kPublished{{"problem 1",
                                         {{0.8961867, -0.09802917},
                                          {1.2156535, -1.187491},
                                          {1.5151435, -0.85449808},
                                          {1.6754775, -0.48768058},
                                          {1.713869, -0.30099232},
                                          {1.7215236, 0.03269953},
                                          {1.6642029, 0.33241088},
                                          {1.4984171, 0.74435576},
                                          {1.3011834, 0.92153806}},
                                         21},
                                        {"problem 2",
                                         {{0.0, 0.0},
                                          {0.3, -0.1},
                                          {0.7, 0.0},
                                          {0.82, 0.2},
                                          {0.9, 0.4},
                                          {0.9, 0.7},
                                          {0.6, 0.7},
                                          {0.1, 0.5},
                                          {0.0, 0.3}},
                                         45},
                                        {"problem 3",
                                         {{0.25, 0.0},
                                          {0.52, 0.1},
                                          {0.8, 0.7},
                                          {1.2, 1.0},
                                          {1.4, 1.3},
                                          {1.1, 1.48},
                                          {0.7, 1.4},
                                          {0.2, 1.0},
                                          {0.02, 0.4}},
                                         64}};

/// How far the coupler point of a real solution can stay from a point of the plane, by the loop of
/// the two dyads: the coupler turns by the rotation that the first dyad needs to reach the point,
/// and the second dyad's length is compared. No formula is shared with the solver's equations.
double miss(const PathSystem& system, const PathRoot& root, std::size_t k) {
  const std::complex<double> turn = root.rotations[k];
  const auto length_error = [&](const Dyad<std::complex<double>>& dyad) {
    const double length = std::abs(dyad.moving - dyad.fixed);
    return std::abs(std::abs(system.d[k] + turn * dyad.moving - dyad.fixed) - length);
  };
  return std::max(
      {length_error(root.first), length_error(root.second), std::abs(std::abs(turn) - 1)});
}

class NinePointOracle : public ::testing::TestWithParam<Published> {};

TEST_P(NinePointOracle, HasThePublishedNumberOfSolutions) {
  std::vector<PathPose> positions;
  for (const Vec2d& point : GetParam().points) positions.push_back({point, {}});
  const ExactPathSolutions found = solve_exact_path(positions);
  ASSERT_EQ(found.status, ExactPathStatus::solved);
  EXPECT_EQ(found.finite, 1442);
  EXPECT_EQ(found.at_infinity + found.singular + found.lost + found.duplicates, 0);
  int real = 0;
  for (const PathRoot& root : found.roots) {
    EXPECT_LT(root.residual, 1e-9);
    if (!root.real) continue;
    ++real;
    EXPECT_LT(root.residual, 1e-13);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_LT(miss(found.system, root, k), 1e-12);
  }
  EXPECT_EQ(real, GetParam().real);
}

INSTANTIATE_TEST_SUITE_P(Published, NinePointOracle, ::testing::ValuesIn(kPublished),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           name[name.find(' ')] = '_';
                           return name;
                         });

}  // namespace
}  // namespace cognate::synthesis::nine_point_test
