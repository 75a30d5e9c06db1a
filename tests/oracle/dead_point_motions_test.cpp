/// Motions whose best four-bar stands at a dead point, or on the border of what closes: no
/// neighbour of what the search finds is nearer to the poses, by other code than its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "problems/guidance/fit.hpp"

namespace cognate::problems::dead_point_motions_test {
namespace {

using Complex = std::complex<double>;
using synthesis::Pose;

/// Pivots A and D, the pins B and C in the body's axes, and the lengths of the links A-B and D-C.
struct Linkage {
  Complex a, d, b, c;
  double crank = 0, rocker = 0;
  double side = 1;  ///< of B→D on which C lies: +1 to the left
};

struct Place {
  Complex at;
  Complex turn;
};

/// Where the body stands at a crank angle; false where the linkage is open.
bool place_at(const Linkage& linkage, double angle, Place& place) {
  const Complex pin = linkage.a + std::polar(linkage.crank, angle), to_d = linkage.d - pin;
  const double coupler = std::abs(linkage.c - linkage.b), apart = std::abs(to_d);
  const double along = (coupler * coupler + apart * apart - linkage.rocker * linkage.rocker) / 2;
  const double cosine = along / (coupler * apart);
  if (!(std::abs(cosine) <= 1)) return false;
  const Complex direction = std::polar(1.0, std::arg(to_d) + linkage.side * std::acos(cosine));
  place.turn = direction * coupler / (linkage.c - linkage.b);
  place.at = pin - place.turn * linkage.b;
  return true;
}

double squares_of(const Place& place, const Pose& pose, double weight) {
  const double turned = weight * std::arg(place.turn * std::polar(1.0, -pose.angle));
  return std::norm(place.at - Complex(pose.at.x, pose.at.y)) + turned * turned;
}

/// The least error at one pose over all crank angles between `from` and `to`: from the best of many
/// samples and from each end of what closes, beside which the body turns fast, by ever smaller
/// steps.
double least_squares(const Linkage& linkage, const Pose& pose, double weight, double from,
                     double to) {
  constexpr int kSamples = 800, kRounds = 80;
  const auto error = [&](double angle) {
    Place place;
    return place_at(linkage, angle, place) ? squares_of(place, pose, weight)
                                           : std::numeric_limits<double>::infinity();
  };
  const double width = (to - from) / kSamples;
  std::vector<double> begun{from};
  for (int k = 0; k <= kSamples; ++k) {
    const double angle = from + width * k;
    if (error(angle) < error(begun.front())) begun.front() = angle;
    double inside = angle, outside = angle + width;
    if (std::isinf(error(inside)) == std::isinf(error(outside))) continue;
    if (std::isinf(error(inside))) std::swap(inside, outside);
    while (true) {
      const double middle = (inside + outside) / 2;
      if (middle == inside || middle == outside) break;
      (std::isinf(error(middle)) ? outside : inside) = middle;
    }
    begun.push_back(inside);
  }
  double least = std::numeric_limits<double>::infinity();
  for (double best : begun) {
    double own = error(best);
    for (double step = width; step > width * std::pow(0.6, kRounds); step *= 0.6) {
      for (const double angle : {best - step, best + step}) {
        if (const double found = error(angle); found < own) {
          own = found;
          best = angle;
        }
      }
    }
    least = std::min(least, own);
  }
  return least;
}

Linkage linkage_of(const DyadPair& pair, double side) {
  const auto complex = [](const Vec2d& p) { return Complex(p.x, p.y); };
  return {complex(pair.first.fixed),
          complex(pair.second.fixed),
          complex(pair.first.in_body),
          complex(pair.second.in_body),
          pair.first.length,
          pair.second.length,
          side};
}

/// Poses of a linkage up to its dead point, disturbed.
MotionProblem up_to_dead_point(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  MotionProblem problem;
  problem.method = MotionMethod::least_squares;
  problem.dyads = {synthesis::DyadKind::rr};
  problem.angle_weight = 0.7;
  auto& constraints = problem.constraints;
  constraints.no_branch_defect = constraints.no_order_defect = constraints.no_circuit_defect = true;
  while (problem.poses.empty()) {
    const Linkage linkage{{0, 0},
                          {between(1, 2), between(-0.5, 0.5)},
                          {between(-0.5, 0.5), between(-0.5, 0.5)},
                          {between(0.5, 1.5), between(-0.5, 1)},
                          between(0.8, 1.6),
                          between(0.4, 1.2)};
    constexpr int kTurn = 3600, kPart = 600, kPoses = 8;
    Place place;
    const auto closes = [&](int k) {
      return place_at(linkage, 2 * std::numbers::pi * k / kTurn, place);
    };
    int first = kPart;
    while (first < kTurn && closes(first)) ++first;
    if (first == kTurn || !closes(first - kPart)) continue;
    std::normal_distribution<double> disturbance(0, 0.04);
    for (int k = 0; k < kPoses; ++k) {
      closes(first - 1 - kPart * (kPoses - 1 - k) / (kPoses - 1));
      problem.poses.push_back(
          {{place.at.real() + disturbance(random), place.at.imag() + disturbance(random)},
           std::arg(place.turn) + disturbance(random)});
    }
  }
  return problem;
}

/// With the crank between two angles.
double sum_of_squares(const Linkage& linkage, const MotionProblem& problem, double from,
                      double to) {
  double sum = 0;
  for (const Pose& pose : problem.poses) {
    sum += least_squares(linkage, pose, problem.angle_weight, from, to);
  }
  return sum;
}

/// Whether coupler and rocker are within two degrees of one line at one of the crank angles.
bool is_near_dead_point(const Linkage& linkage, const std::vector<double>& crank_angles) {
  return std::ranges::any_of(crank_angles, [&](double angle) {
    Place place;
    if (!place_at(linkage, angle, place)) return true;
    const Complex far = place.at + place.turn * linkage.c;
    const Complex pin = linkage.a + std::polar(linkage.crank, angle);
    const double sine = std::imag((pin - far) * std::conj(linkage.d - far)) /
                        (std::abs(pin - far) * linkage.rocker);
    return std::abs(sine) < 0.035;
  });
}

/// The least error of some hundred neighbours over the error `own` of what was found.
double least_of_neighbours(const Linkage& found, const MotionProblem& problem, double own,
                           double from, double to, std::mt19937_64& random) {
  double least = std::numeric_limits<double>::infinity();
  for (const double size : {1e-3, 1e-4}) {
    std::normal_distribution<double> step(0, size);
    const auto moved = [&](const Complex& p) { return p + Complex(step(random), step(random)); };
    for (int k = 0; k < 150; ++k) {
      Linkage other{moved(found.a), moved(found.d), moved(found.b), moved(found.c), 0, 0,
                    found.side};
      other.crank = found.crank * (1 + step(random));
      other.rocker = found.rocker * (1 + step(random));
      least = std::min(least, sum_of_squares(other, problem, from, to) / own);
    }
  }
  return least;
}

TEST(DeadPointMotions, HaveNoNearerNeighbour) {
  std::mt19937_64 random(11);
  int on_border = 0;
  for (int number = 0; number < 30; ++number) {
    SCOPED_TRACE(number);
    const MotionProblem problem = up_to_dead_point(random);
    problems::Run run;
    run.seed = 1;
    run.threads = 1;
    const Deadline none(run);
    Work work;
    const auto found =
        search_motions(problem, {}, 200, synthesis::Solver::gauss_newton, 1e-12, run, none, work);
    ASSERT_FALSE(found.minima.empty());
    const auto& [form, origin, solution] = found.minima.front();
    const MotionModel model(problem, form);
    auto angles = model.station_angles(solution.x);
    for (std::size_t k = 1; k < angles.size(); ++k) {
      angles[k] = angles[k - 1] + std::remainder(angles[k] - angles[k - 1], 2 * std::numbers::pi);
    }
    const double from = std::ranges::min(angles) - 0.05, to = std::ranges::max(angles) + 0.05;
    // C is to the left of B→D where Im(K E), (B − D) × (C − B), is negative.
    const Linkage linkage = linkage_of(model.pair(solution.x), -form.sides.front());
    if (!is_near_dead_point(linkage, angles)) continue;
    const double own = sum_of_squares(linkage, problem, from, to);
    // Poses that share a crank angle to be in order would be nearer without.
    if (own < (1 - 1e-6) * solution.objective) continue;
    ++on_border;
    EXPECT_NEAR(own, solution.objective, 1e-5 * own);
    EXPECT_GT(least_of_neighbours(linkage, problem, own, from, to, random), 1 - 1e-5);
  }
  EXPECT_GE(on_border, 3);
}

}  // namespace
}  // namespace cognate::problems::dead_point_motions_test
