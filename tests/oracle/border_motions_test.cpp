/// Motions whose best four-bar stands at a dead point, or hardly closes between two poses: the
/// search finds the best that is known; its error is computed again by other code, which finds no
/// neighbour that is nearer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "problems/guidance/fit.hpp"

namespace cognate::problems::border_motions_test {
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

/// A motion of the body, disturbed, with what files exclude by default.
class Motions {
 public:
  explicit Motions(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  Linkage linkage() {
    const Complex d{between(1, 2), between(-0.5, 0.5)};
    const Complex b{between(-0.5, 0.5), between(-0.5, 0.5)};
    const Complex c{between(0.5, 1.5), between(-0.5, 1)};
    return {{0, 0}, d, b, c, between(0.8, 1.6), between(0.4, 1.2)};
  }

  /// Poses at even steps of the crank; empty where it is open at one.
  std::vector<Pose> poses(const Linkage& linkage, double from, double to) {
    constexpr int kPoses = 8;
    std::normal_distribution<double> disturbance(0, 0.04);
    const auto off = [&] { return disturbance(random_); };
    std::vector<Pose> poses;
    for (int k = 0; k < kPoses; ++k) {
      Place place;
      if (!place_at(linkage, from + (to - from) * k / (kPoses - 1), place)) return {};
      const double x = place.at.real() + off(), y = place.at.imag() + off();
      poses.push_back({{x, y}, std::arg(place.turn) + off()});
    }
    return poses;
  }

  static MotionProblem problem_of(std::vector<Pose> poses) {
    MotionProblem problem;
    problem.method = MotionMethod::least_squares;
    problem.dyads = {synthesis::DyadKind::rr};
    problem.angle_weight = 0.7;
    problem.poses = std::move(poses);
    auto& constraints = problem.constraints;
    constraints.no_branch_defect = constraints.no_order_defect = true;
    constraints.no_circuit_defect = true;
    return problem;
  }

 private:
  std::mt19937_64 random_;
};

/// Poses of a linkage over a radian up to its dead point.
MotionProblem up_to_dead_point(Motions& motions) {
  while (true) {
    const Linkage linkage = motions.linkage();
    Place place;
    double angle = 1;
    while (angle < 2 * std::numbers::pi && place_at(linkage, angle, place)) angle += 2e-3;
    auto poses = motions.poses(linkage, angle - 1, angle - 2e-3);
    if (angle < 2 * std::numbers::pi && !poses.empty()) {
      return Motions::problem_of(std::move(poses));
    }
  }
}

/// Poses of a linkage that hardly closes where its crank is in line with the frame, away from the
/// far pivot, on both sides of that.
MotionProblem across_border(Motions& motions) {
  while (true) {
    Linkage linkage = motions.linkage();
    const double span = std::abs(linkage.d - linkage.a) + linkage.crank;
    linkage.rocker = span * motions.between(1.001, 1.01) - std::abs(linkage.c - linkage.b);
    if (linkage.rocker < 0.3) continue;
    const double line = std::arg(linkage.a - linkage.d);
    auto poses = motions.poses(linkage, line - 0.8, line + 0.8);
    if (!poses.empty()) return Motions::problem_of(std::move(poses));
  }
}

/// What the search finds, and the crank angle at each pose, one after the other in one sense.
struct Found {
  Linkage linkage;
  double objective = 0;
  std::vector<double> angles;
};

/// Angles in [low, high] at which the crank is in line with the frame.
std::vector<double> lines_within(const Linkage& linkage, double low, double high) {
  std::vector<double> lines;
  const double first = std::arg(linkage.d - linkage.a);
  for (int k = -6; k <= 6; ++k) {
    const double line = first + k * std::numbers::pi;
    if (line >= low && line <= high) lines.push_back(line);
  }
  return lines;
}

/// The same crank angles one after the other in the sense in which that takes one turn at most.
void follow_one_sense(std::vector<double>& angles) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (const double sense : {1.0, -1.0}) {
    std::vector<double> followed = angles;
    for (std::size_t k = 1; k < angles.size(); ++k) {
      double step = std::fmod(sense * (angles[k] - angles[k - 1]), kTurn);
      if (step < 0) step += kTurn;
      followed[k] = followed[k - 1] + sense * step;
    }
    if (std::abs(followed.back() - followed.front()) <= kTurn) angles = followed;
  }
}

std::optional<Found> found_by_search(const MotionProblem& problem) {
  problems::Run run;
  run.seed = 1;
  run.threads = 1;
  const Deadline none(run);
  Work work;
  const auto result =
      search_motions(problem, {}, 200, synthesis::Solver::gauss_newton, 1e-12, run, none, work);
  if (result.minima.empty()) return std::nullopt;
  const auto& [form, origin, solution] = result.minima.front();
  const MotionModel model(problem, form);
  const auto stations = model.station_angles(solution.x);
  // C is to the left of B→D where Im(K E), (B − D) × (C − B), is negative.
  Found found{linkage_of(model.pair(solution.x), -form.sides.front()), solution.objective};
  for (std::size_t j = 0; j < problem.poses.size(); ++j) {
    found.angles.push_back(stations[model.station_of(j)]);
  }
  follow_one_sense(found.angles);
  return found;
}

/// The sum of squares by the code of this file; infinite where the linkage opens between the poses,
/// or the crank does not follow them within one turn.
double own_error(const Found& found, const MotionProblem& problem) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto [low, high] = std::ranges::minmax(found.angles);
  if (high - low > 2 * std::numbers::pi) return kInfinite;
  Place place;
  for (const double line : lines_within(found.linkage, low, high)) {
    if (!place_at(found.linkage, line, place)) return kInfinite;
  }
  double sum = 0;
  for (std::size_t j = 0; j < problem.poses.size(); ++j) {
    if (!place_at(found.linkage, found.angles[j], place)) return kInfinite;
    sum += squares_of(place, problem.poses[j], problem.angle_weight);
  }
  return sum;
}

/// The crank angle within a twentieth of a radian of `angle` at which the body is nearest to a
/// pose: the best of a fine grid, then thirds of what lies about it. Where the linkage is open it
/// is not.
double nearest_angle(const Linkage& linkage, const Pose& pose, double weight, double angle) {
  constexpr double kReach = 0.05;
  constexpr int kSteps = 50, kThirds = 40;
  const auto squares = [&](double at) {
    Place place;
    return place_at(linkage, at, place) ? squares_of(place, pose, weight)
                                        : std::numeric_limits<double>::infinity();
  };
  double best = angle;
  for (int k = -kSteps; k <= kSteps; ++k) {
    const double at = angle + kReach * k / kSteps;
    if (squares(at) < squares(best)) best = at;
  }
  double low = best - kReach / kSteps, high = best + kReach / kSteps;
  for (int k = 0; k < kThirds; ++k) {
    const double third = (high - low) / 3, left = low + third, right = high - third;
    if (squares(left) > squares(right) || (squares(left) == squares(right) && right < best)) {
      low = left;
    } else {
      high = right;
    }
  }
  const double middle = (low + high) / 2;
  return squares(middle) < squares(best) ? middle : best;
}

/// The squares of another linkage with every pose at its nearest crank angle; infinite where it
/// opens between the poses, or passes them in another order.
double neighbours_error(const Linkage& linkage, const Found& found, const MotionProblem& problem) {
  Found other{linkage, 0, {}};
  for (std::size_t j = 0; j < problem.poses.size(); ++j) {
    other.angles.push_back(
        nearest_angle(linkage, problem.poses[j], problem.angle_weight, found.angles[j]));
  }
  const bool in_order = std::ranges::is_sorted(other.angles) ||
                        std::ranges::is_sorted(other.angles, std::ranges::greater{});
  return in_order ? own_error(other, problem) : std::numeric_limits<double>::infinity();
}

/// The least of some hundred neighbours of what was found.
double least_of_neighbours(const Found& found, const MotionProblem& problem) {
  std::mt19937_64 random(5);
  double least = std::numeric_limits<double>::infinity();
  for (const double size : {1e-3, 1e-4}) {
    std::normal_distribution<double> step(0, size);
    const auto moved = [&](const Complex& p) { return p + Complex(step(random), step(random)); };
    for (int k = 0; k < 150; ++k) {
      Linkage other = found.linkage;
      for (Complex* pivot : {&other.a, &other.d, &other.b, &other.c}) *pivot = moved(*pivot);
      other.crank *= 1 + step(random);
      other.rocker *= 1 + step(random);
      least = std::min(least, neighbours_error(other, found, problem));
    }
  }
  return least;
}

/// Of motions by their numbers the best errors that are known; by how much, relative to what is
/// found, a neighbour may be nearer.
template <class Planted>
void expect_reached(Motions motions, Planted&& planted, std::vector<std::pair<int, double>> known,
                    double nearer) {
  int number = 0;
  for (const auto& [wanted, best] : known) {
    SCOPED_TRACE(wanted);
    MotionProblem problem = planted(motions);
    for (; number < wanted; ++number) problem = planted(motions);
    ++number;
    const auto found = found_by_search(problem);
    ASSERT_TRUE(found);
    EXPECT_LT(found->objective, 1.001 * best);
    EXPECT_NEAR(own_error(*found, problem), found->objective, 1e-6 * best);
    EXPECT_GT(least_of_neighbours(*found, problem), (1 - nearer) * found->objective);
  }
}

// Without holding stations at dead points the search ends above all of these, by 16 % to 119 %;
// without closing between poses, or without releasing what is held, above some.
TEST(BorderMotions, ReachTheBestKnownAtDeadPoints) {
  expect_reached(Motions(11), up_to_dead_point,
                 {{3, 0.0126840477}, {5, 0.00547144731}, {59, 0.00851118176}}, 1e-5);
}

// Where the dead point lies beside the line in which the linkage hardly closes, a pose creeps
// towards it still: neighbours of two of these are nearer by 0.02 % and 0.3 %.
TEST(BorderMotions, ReachTheBestKnownWhereTheyHardlyClose) {
  expect_reached(Motions(12), across_border,
                 {{8, 0.0144414051},
                  {13, 0.00887973974},
                  {35, 0.0123836699},
                  {52, 0.0103747827},
                  {54, 0.00652072687}},
                 5e-3);
}

}  // namespace
}  // namespace cognate::problems::border_motions_test
