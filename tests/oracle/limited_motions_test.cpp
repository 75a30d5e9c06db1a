/// Motions with several limits that a planted four-bar meets: what the search finds is no worse,
/// whichever its seed.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "problems/guidance/order.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems::limited_motions_test {
namespace {

using synthesis::Pose;

/// Twenty poses of a rocker-crank over 44 degrees of its crank, disturbed by a thousandth. Its own
/// sum of squares is 4.131e-6; within the limits a neighbour of it has 0.523 of that. Searched with
/// all limits from the start, a poor minimum of eight times the planted error is met seven times
/// before that one once.
constexpr std::array<std::array<double, 3>, 20> kPoses{
    {{-0.3591039, -0.7307387, 85.20449}, {-0.4452448, -0.7846776, 85.82019},
     {-0.4642282, -0.7951158, 85.84248}, {-0.4661302, -0.7963793, 85.96459},
     {-0.5225343, -0.8235850, 86.12214}, {-0.5349683, -0.8289288, 86.11167},
     {-0.6437270, -0.8692413, 86.55732}, {-0.6782548, -0.8796082, 86.72427},
     {-0.7392414, -0.8934688, 86.85131}, {-0.7613364, -0.8981571, 86.90808},
     {-0.8532201, -0.9110378, 87.08314}, {-0.8712454, -0.9120862, 86.98197},
     {-0.9695624, -0.9146610, 87.10929}, {-0.9720046, -0.9145861, 86.96368},
     {-0.9814181, -0.9142787, 87.11700}, {-0.9990890, -0.9135699, 87.16414},
     {-1.0299036, -0.9116093, 86.95177}, {-1.0369263, -0.9108771, 87.03478},
     {-1.1270315, -0.8992857, 87.02033}, {-1.1723369, -0.8901351, 86.71064}}};

MotionProblem parsed(const std::string& text) {
  const auto problem = parse_task(text);
  if (!problem) throw std::runtime_error("faulty test problem");
  return std::get<MotionProblem>(*problem);
}

std::string rows(const std::vector<std::size_t>& order) {
  std::string text;
  for (const std::size_t i : order) {
    const auto& [x, y, angle] = kPoses.at(i);
    text += fmt::format("{}[{}, {}, {}]", text.empty() ? "" : ", ", x, y, angle);
  }
  return text;
}

MotionProblem limited_motion(const std::vector<std::size_t>& order, const std::string& more) {
  return parsed(
      "kind = \"motion-generation\"\n[target]\nposes = [" + rows(order) +
      "]\nangle_weight = 0.2531692145175308\n[mechanism]\ndyads = [\"RR\"]\n[constraints]\n" +
      more +
      "class = \"rocker-crank\"\ntransmission_angle_deg = [45.19525, 108.39811]\n"
      "link_ratio_max = 2.43642\n"
      "pivot_region = [[-2.156386, -0.955547], [-0.560138, 0.535287]]\n");
}

std::vector<std::size_t> in_turn() {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < kPoses.size(); ++i) order.push_back(i);
  return order;
}

constexpr double kPlanted = 4.131277588364379e-06, kBest = 0.5229;

TEST(LimitedMotions, ReachTheBestWithEachSeed) {
  const MotionProblem problem = limited_motion(in_turn(), "");
  int solved = 0;
  for (const std::uint64_t seed : {1, 3}) {
    const Result result = solve(problem, {.seed = seed});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_NEAR(result.designs.front().error.sum_of_squares / kPlanted, kBest, 0.005) << seed;
    ++solved;
  }
  EXPECT_EQ(solved, 2);
}

/// The transmission angle is limited between the poses furthest apart, which are not the first and
/// the last of the file.
TEST(LimitedMotions, WithoutAnOrderAreLimitedOverTheirWholeRange) {
  auto order = in_turn();
  std::mt19937_64 random(5);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  const MotionProblem problem = limited_motion(order, "no_order_defect = false\n");
  const Result result = solve(problem, {.seed = 1});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.designs.front().error.sum_of_squares, kPlanted * (kBest + 0.005));
}

/// Poses that a four-bar meets exactly, in order, but whose neighbours share crank angles: parted
/// until each has its own, they are met again.
TEST(PartedStations, GiveEachPoseItsOwnAngleWhereThatIsBetter) {
  std::mt19937_64 random(8);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int begun = 0, met = 0;
  for (int n = 0; n < 40; ++n) {
    DyadPair pair;
    pair.first = {synthesis::DyadKind::rr, {0, 0}, {}, {0, 0}, {1, 0}, uniform(0.4, 0.8)};
    pair.second = {synthesis::DyadKind::rr,
                   {uniform(1.5, 2), uniform(-0.3, 0.3)},
                   {},
                   {2, uniform(-0.3, 0.3)},
                   {1, 0},
                   uniform(1.3, 1.8)};
    MotionProblem problem;
    problem.method = MotionMethod::least_squares;
    problem.dyads = {synthesis::DyadKind::rr};
    const double sense = n % 2 == 0 ? 1 : -1, start = uniform(-3, 3);
    for (int j = 0; j < 9; ++j) {
      const double angle = start + sense * 0.25 * (j + uniform(0, 0.6));
      const Vec2d pin = pair.first.length * Vec2d{std::cos(angle), std::sin(angle)};
      // Two circles about the pin and the second fixed pivot.
      const Vec2d way = pair.second.fixed - pin;
      const double d = norm(way), coupler = norm(pair.second.in_body);
      const double at_pin =
          std::acos((coupler * coupler + d * d - pair.second.length * pair.second.length) /
                    (2 * coupler * d));
      problem.poses.push_back({pin, std::atan2(way.y, way.x) + at_pin -
                                        std::atan2(pair.second.in_body.y, pair.second.in_body.x)});
    }
    bool closes = true;
    for (const Pose& pose : problem.poses) closes = closes && std::isfinite(pose.angle);
    if (!closes) continue;
    ++begun;
    OrderedMotion motion{form_of(problem, pair), {}};
    const std::vector<double> own = MotionModel(problem, motion.form).variables_of(pair);
    const auto angles = MotionModel(problem, motion.form).station_angles(own);
    motion.form.stations = {0, 0, 0, 1, 1, 2, 2, 2, 2};
    motion.x = MotionModel(problem, motion.form)
                   .with_angles(own, std::vector{angles[1], angles[3], angles[6]});
    double error = 1;
    for (int round = 0; round < 12; ++round) {
      const auto solution =
          synthesis::solve(synthesis::Solver::gauss_newton, MotionModel(problem, motion.form),
                           motion.x, {.tolerance = 1e-14, .max_iterations = 400});
      error = solution.objective;
      motion.x = solution.x;
      auto next = parted(problem, motion);
      if (!next) break;
      motion = *std::move(next);
    }
    met += error < 1e-12 && motion.form.stations.back() == 8;
  }
  EXPECT_GT(begun, 25);
  EXPECT_GE(met, begun - 3);  // some run to another minimum on the way
}

}  // namespace
}  // namespace cognate::problems::limited_motions_test
