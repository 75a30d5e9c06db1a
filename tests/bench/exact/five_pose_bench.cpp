/// Time of all dyads through five poses, against Newton's method from random starts and against the
/// textbook's resultant with a general eigenvalue solver; and of the other numbers of poses.
#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/five_poses.hpp"
#include "synthesis/exact/motion/three_poses.hpp"

namespace cognate::synthesis {
namespace {

using Poses = std::array<Pose, 5>;
using Complex = std::complex<double>;

constexpr std::size_t kProblems = 1024;

std::vector<Poses> problems() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-2, 2), angle(-2, 2);
  std::vector<Poses> all(kProblems);
  for (Poses& poses : all) {
    for (Pose& pose : poses) pose = {{place(random), place(random)}, angle(random)};
  }
  return all;
}
const std::vector<Poses> inputs = problems();

void report(benchmark::State& state, std::size_t dyads) {
  state.counters["dyads"] = static_cast<double>(dyads) / static_cast<double>(state.iterations());
}

void closed_form(benchmark::State& state) {
  std::size_t i = 0, dyads = 0;
  for (auto _ : state) {
    const DyadSolutions found = dyads_of_five_poses(inputs[i++ % kProblems]);
    dyads += static_cast<std::size_t>(found.count);
    benchmark::DoNotOptimize(found);
  }
  report(state, dyads);
}
BENCHMARK(closed_form)->Unit(benchmark::kMicrosecond);

/// The linear conditions of the displacements, in (h, w, W, g, G, P, Q) and complex numbers.
Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic> conditions(const Poses& poses) {
  Eigen::MatrixXcd rows(4, 7);
  for (int j = 0; j < 4; ++j) {
    const Pose& pose = poses[static_cast<std::size_t>(j + 1)];
    const Complex e = std::polar(1.0, pose.angle - poses[0].angle);
    const Complex first(poses[0].at.x, poses[0].at.y), at(pose.at.x, pose.at.y);
    const Complex d = at - e * first;
    rows.row(j) << std::norm(d), e * std::conj(d), std::conj(e) * d, -std::conj(d), -d,
        1.0 - std::conj(e), 1.0 - e;
  }
  return rows;
}

/// Straight from the formulas, with dynamic matrices: a null space by singular values, the 4 × 4
/// resultant of the two conics at five points, and the roots of its quartic as eigenvalues.
void dense_resultant(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const Eigen::MatrixXcd rows = conditions(inputs[i++ % kProblems]);
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(rows, Eigen::ComputeFullV);
    const Eigen::MatrixXcd n = svd.matrixV().rightCols(3);
    // Coefficients of a conic x_a x_b − x_c x_h in (s, t, 1).
    const auto conic = [&](int a, int b, int c) {
      const Eigen::MatrixXcd product =
          n.row(a).transpose() * n.row(b) - n.row(c).transpose() * n.row(0);
      return Eigen::MatrixXcd(product + product.transpose());
    };
    const Eigen::MatrixXcd p = conic(1, 4, 5), q = conic(2, 3, 6);
    Eigen::MatrixXcd powers(5, 5);
    Eigen::VectorXcd values(5);
    for (int k = 0; k < 5; ++k) {
      const Complex t = std::polar(1.0, kTurn * k / 5);
      const auto quadratic = [&](const Eigen::MatrixXcd& m) {
        return std::array<Complex, 3>{m(0, 0), 2.0 * (m(0, 1) * t + m(0, 2)),
                                      m(1, 1) * t * t + 2.0 * m(1, 2) * t + m(2, 2)};
      };
      const auto a = quadratic(p), b = quadratic(q);
      Eigen::MatrixXcd sylvester(4, 4);
      sylvester << a[0], a[1], a[2], 0, 0, a[0], a[1], a[2], b[0], b[1], b[2], 0, 0, b[0], b[1],
          b[2];
      values[k] = sylvester.determinant();
      for (int j = 0; j < 5; ++j) powers(k, j) = std::pow(t, j);
    }
    const Eigen::VectorXcd quartic = powers.partialPivLu().solve(values);
    Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(4, 4);
    for (int k = 0; k < 4; ++k) companion(k, 3) = -quartic[k] / quartic[4];
    for (int k = 1; k < 4; ++k) companion(k, k - 1) = 1;
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> roots(companion, false);
    benchmark::DoNotOptimize(roots.eigenvalues());
  }
}
BENCHMARK(dense_resultant)->Unit(benchmark::kMicrosecond);

/// One run of Newton's method on the four distances from a random start; whether it arrives.
bool newton(const Poses& poses, std::mt19937_64& random, Eigen::Vector4d& x) {
  std::uniform_real_distribution<double> place(-4, 4);
  for (int k = 0; k < 4; ++k) x[k] = place(random);
  for (int step = 0; step < 40; ++step) {
    Eigen::Vector4d value;
    Eigen::Matrix4d slope;
    const Vec2d in_body{x[0], x[1]}, fixed{x[2], x[3]};
    const Vec2d turn0{std::cos(poses[0].angle), std::sin(poses[0].angle)};
    const Vec2d from = poses[0].at + turn0 * in_body - fixed;
    for (int j = 0; j < 4; ++j) {
      const Pose& pose = poses[static_cast<std::size_t>(j + 1)];
      const Vec2d turn{std::cos(pose.angle), std::sin(pose.angle)};
      const Vec2d to = pose.at + turn * in_body - fixed;
      value[j] = 0.5 * (squared_norm(to) - squared_norm(from));
      const Vec2d by_body = conj(turn) * to - conj(turn0) * from;
      slope.row(j) << by_body.x, by_body.y, from.x - to.x, from.y - to.y;
    }
    const Eigen::Vector4d change = slope.partialPivLu().solve(value);
    x -= change;
    if (change.norm() <= 1e-12 * (1 + x.norm())) return true;
  }
  return false;
}

/// As many starts as find both or all four dyads nine times in ten, each dyad distinguished from
/// the others.
void random_starts(benchmark::State& state) {
  std::mt19937_64 random(2);
  std::size_t i = 0, dyads = 0;
  for (auto _ : state) {
    const Poses& poses = inputs[i++ % kProblems];
    std::vector<Eigen::Vector4d> found;
    for (int start = 0; start < state.range(0); ++start) {
      Eigen::Vector4d x;
      if (!newton(poses, random, x)) continue;
      const auto same = [&](const Eigen::Vector4d& y) { return (x - y).norm() < 1e-6; };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(x);
    }
    dyads += found.size();
  }
  report(state, dyads);
}
BENCHMARK(random_starts)->Arg(30)->Arg(300)->Unit(benchmark::kMicrosecond);

void centre_of_three(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const std::span<const Pose, 3> poses(inputs[i++ % kProblems].data(), 3);
    benchmark::DoNotOptimize(dyads_with_moving_pivot(poses, {0.3, 0.4}));
  }
}
BENCHMARK(centre_of_three)->Unit(benchmark::kMicrosecond);

void curve_of_four(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const std::span<const Pose, 4> poses(inputs[i++ % kProblems].data(), 4);
    const BurmesterCurves curves(poses);
    benchmark::DoNotOptimize(curves.branch_count());
  }
}
BENCHMARK(curve_of_four)->Unit(benchmark::kMicrosecond);

void point_of_curve(benchmark::State& state) {
  const BurmesterCurves curves(std::span<const Pose, 4>(inputs[0].data(), 4));
  double parameter = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(curves.at(0, parameter));
    parameter += 0.618;
  }
}
BENCHMARK(point_of_curve)->Unit(benchmark::kMicrosecond);

void traced_curve(benchmark::State& state) {
  std::size_t i = 0, points = 0;
  for (auto _ : state) {
    const BurmesterCurves curves(std::span<const Pose, 4>(inputs[i++ % kProblems].data(), 4));
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      points += curves.trace(branch, 0.02, 5).size();
    }
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(state.iterations());
}
BENCHMARK(traced_curve)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
