/// The screening of timed paths: planted designs have error zero, and a dense least-squares solver
/// finds the same linear unknowns.
#include "synthesis/lanes/path_screen.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/linkage/motion.hpp"

namespace cognate::synthesis::path_screen_test {
namespace {

/// A target with everything free, at crank increments 0, 0.5, 1, …, moved to its centroid.
struct Fixture {
  std::vector<double> half_cos, half_sin, x, y, weight;
  SeparableTarget target;

  explicit Fixture(const std::vector<Vec2d>& points) {
    Vec2d centroid{};
    for (const Vec2d& p : points) centroid = centroid + (1.0 / double(points.size())) * p;
    for (std::size_t j = 0; j < points.size(); ++j) {
      half_cos.push_back(std::cos(0.25 * double(j)));
      half_sin.push_back(std::sin(0.25 * double(j)));
      x.push_back(points[j].x - centroid.x);
      y.push_back(points[j].y - centroid.y);
      weight.push_back(1);
      target.squares += x.back() * x.back() + y.back() * y.back();
    }
    target.half_cos = half_cos.data();
    target.half_sin = half_sin.data();
    target.x = x.data();
    target.y = y.data();
    target.weight = weight.data();
    target.count = static_cast<int>(points.size());
    target.weight_sum = double(points.size());
    for (int k = 0; k < 4; ++k) target.greatest[k] = 1e6;
  }
};

std::vector<Vec2d> planted_points(const FourBar& linkage, double phase) {
  std::vector<Vec2d> points;
  const Motion motion(linkage);
  for (int j = 0; j < 9; ++j) {
    points.push_back(*motion.at(frame_angle(linkage) + phase + 0.5 * j)->coupler_point);
  }
  return points;
}

TEST(PathScreen, FindsAPlantedDesignWithoutError) {
  const FourBar linkage{{1, 2}, {4, 3}, 1.1, 2.9, 2.4, Assembly::crossed, Vec2d{1.2, -0.8}};
  const Fixture fixture(planted_points(linkage, 0.7));
  const auto links = lengths(linkage);
  PathCandidates candidates(PathCandidates::lanes);
  for (std::size_t i = 0; i < PathCandidates::lanes; ++i) {
    candidates.coupler[i] = links.coupler / links.crank * (1 + 0.01 * double(i));
    candidates.rocker[i] = links.rocker / links.crank;
    candidates.frame[i] = links.frame / links.crank;
    candidates.phase_cos[i] = std::cos(0.35);
    candidates.phase_sin[i] = std::sin(0.35);
  }
  screen(fixture.target, candidates);
  EXPECT_NEAR(candidates.crossed[0], 0, 1e-12);
  EXPECT_GT(candidates.open[0], 1e-4);
  for (std::size_t i = 1; i < PathCandidates::lanes; ++i) EXPECT_GT(candidates.crossed[i], 1e-8);

  const auto fit = separable_fit(
      fixture.target,
      Lengths<double>{1, candidates.coupler[0], candidates.rocker[0], candidates.frame[0]},
      Vec2d{std::cos(0.35), std::sin(0.35)}, -1.0);
  EXPECT_NEAR(fit.crank, 1.1, 1e-9);
  EXPECT_NEAR(std::atan2(fit.frame_direction.y, fit.frame_direction.x), frame_angle(linkage), 1e-9);
  const Vec2d point = conj(fit.frame_direction) * fit.coupler_point;
  EXPECT_NEAR(std::hypot(point.x, point.y), std::hypot(1.2, 0.8), 1e-8);
}

/// Least squares in t, s, q by a QR factorisation of the real problem.
double dense_error(const Fixture& fixture, const Lengths<double>& ratios, double phase,
                   double assembly) {
  const int n = fixture.target.count;
  Eigen::MatrixXd matrix(2 * n, 6);
  Eigen::VectorXd rhs(2 * n);
  const Closure<double> closure(ratios);
  for (int j = 0; j < n; ++j) {
    const double theta = phase + 0.5 * j;
    const auto at = closure.at(crank_direction(theta), assembly);
    if (!(at.discriminant >= 0)) return std::nan("");
    const double c = std::cos(theta), s = std::sin(theta);
    matrix.row(2 * j) << 1, 0, c, -s, at.coupler.x, -at.coupler.y;
    matrix.row(2 * j + 1) << 0, 1, s, c, at.coupler.y, at.coupler.x;
    rhs.segment<2>(2 * j) << fixture.x[j], fixture.y[j];
  }
  const Eigen::VectorXd best = matrix.colPivHouseholderQr().solve(rhs);
  return (matrix * best - rhs).squaredNorm();
}

TEST(PathScreen, AgreesWithDenseLeastSquares) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> ratio(0.5, 3.0), angle(-3.0, 3.0), coordinate(-1, 1);
  std::vector<Vec2d> points(8);
  for (Vec2d& p : points) p = {coordinate(random), coordinate(random)};
  const Fixture fixture(points);
  PathCandidates candidates(64 * PathCandidates::lanes);
  std::vector<double> phases;
  for (std::size_t i = 0; i < candidates.coupler.size(); ++i) {
    candidates.coupler[i] = ratio(random);
    candidates.rocker[i] = ratio(random);
    candidates.frame[i] = ratio(random);
    phases.push_back(angle(random));
    candidates.phase_cos[i] = std::cos(phases[i] / 2);
    candidates.phase_sin[i] = std::sin(phases[i] / 2);
  }
  screen(fixture.target, candidates);
  int compared = 0;
  for (std::size_t i = 0; i < candidates.coupler.size(); ++i) {
    const Lengths<double> ratios{1, candidates.coupler[i], candidates.rocker[i],
                                 candidates.frame[i]};
    const double expected = dense_error(fixture, ratios, phases[i], 1.0);
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(candidates.open[i]));
      continue;
    }
    ++compared;
    EXPECT_NEAR(candidates.open[i], expected, 1e-9);
  }
  EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace cognate::synthesis::path_screen_test
