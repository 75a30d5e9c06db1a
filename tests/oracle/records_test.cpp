/// Every published problem reaches its best known error, from every seed, by default settings, with
/// a design that an independent evaluation confirms.
#include "tests/oracle/records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "problems/read.hpp"
#include "problems/result.hpp"

namespace cognate {
namespace {

using problems::Design;
using problems::FunctionProblem;
using problems::MotionProblem;
using problems::PathProblem;

/// Seeds per problem: 20, unless the environment asks for fewer (slow builds).
int seeds() {
  const char* text = std::getenv("COGNATE_TEST_SEEDS");
  return text ? std::max(1, std::atoi(text)) : 20;
}

/// The coupler point by the textbook's angles: law of cosines at B.
Vec2d textbook_point(const FourBar& linkage, double crank_angle) {
  const double bx = linkage.pivot_a.x + linkage.crank * std::cos(crank_angle);
  const double by = linkage.pivot_a.y + linkage.crank * std::sin(crank_angle);
  const double dx = linkage.pivot_d.x - bx, dy = linkage.pivot_d.y - by, d = std::hypot(dx, dy);
  const double l2 = linkage.coupler, l3 = linkage.rocker;
  const double at_b = std::acos((l2 * l2 + d * d - l3 * l3) / (2 * l2 * d));
  const double phi = std::atan2(dy, dx) + (linkage.assembly == Assembly::open ? at_b : -at_b);
  const double u = linkage.coupler_point->x, v = linkage.coupler_point->y;
  return {bx + u * std::cos(phi) - v * std::sin(phi), by + u * std::sin(phi) + v * std::cos(phi)};
}

double squared_size(const PathProblem& problem) {
  Vec2d centre{};
  const double share = 1.0 / double(problem.points.size());
  for (const Vec2d& p : problem.points) centre = centre + share * p;
  double squares = 0;
  for (const Vec2d& p : problem.points) squares += share * squared_norm(p - centre);
  return squares;
}

double textbook_error(const PathProblem& problem, const Design& design) {
  double sum = 0;
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    sum +=
        squared_norm(textbook_point(four_bar(design), design.crank_angles[j]) - problem.points[j]);
  }
  return sum;
}

/// The published problems all ask for a crank-rocker: the crank is the shortest link and Grashof's
/// rule holds, to the rounding of the lengths.
void expect_crank_rocker(const FourBar& linkage) {
  const auto links = lengths(linkage);
  std::vector<double> all{links.crank, links.coupler, links.rocker, links.frame};
  std::sort(all.begin(), all.end());
  EXPECT_LE(links.crank, all[0] * (1 + 1e-12));
  EXPECT_LE(all[0] + all[3], (all[1] + all[2]) * (1 + 1e-12));
}

/// Prescribed crank angles are kept: each increment is the file's, in the sense found.
void expect_timing(const PathProblem& problem, const Design& design) {
  if (problem.timing == problems::Timing::free) return;
  for (std::size_t j = 1; j < problem.points.size(); ++j) {
    const double wanted = problem.crank_angles[j] - problem.crank_angles[0];
    const double found = design.crank_angles[j] - design.crank_angles[0];
    const double ccw = std::remainder(found - wanted, 2 * std::numbers::pi);
    const double cw = std::remainder(found + wanted, 2 * std::numbers::pi);
    EXPECT_LT(std::min(std::abs(ccw), std::abs(cw)), 1e-12);
  }
}

void check(const Record& record, const PathProblem& problem, const Design& design) {
  const double size = squared_size(problem);
  expect_crank_rocker(four_bar(design));
  expect_timing(problem, design);
  const double error = textbook_error(problem, design);
  EXPECT_TRUE(reaches(record, error, size)) << error;
  EXPECT_GE(error, record.best_known * (1 - 1e-6)) << "better than the best known: update records";
}

void check(const Record& record, const FunctionProblem&, const Design& design) {
  expect_crank_rocker(four_bar(design));
  EXPECT_NEAR(design.error.sum_of_squares, record.best_known, 1e-6 * record.best_known);
}

/// The body's pose by the textbook's angles; `in_link`: of its axes from the line B–C.
double textbook_error(const MotionProblem& problem, const Design& design) {
  const FourBar& linkage = four_bar(design);
  FourBar ahead = linkage;  // a point ahead of the body's origin along the coupler
  ahead.coupler_point = *linkage.coupler_point + Vec2d{1, 0};
  const auto fact =
      std::ranges::find(design.metrics.facts, "body_angle_in_link_deg", &problems::Fact::name);
  const double in_link = std::get<double>(fact->value) * std::numbers::pi / 180;
  double sum = 0;
  for (std::size_t j = 0; j < problem.poses.size(); ++j) {
    const Vec2d at = textbook_point(linkage, design.crank_angles[j]);
    const Vec2d along = textbook_point(ahead, design.crank_angles[j]) - at;
    const double turn = std::remainder(
        std::atan2(along.y, along.x) + in_link - problem.poses[j].angle, 2 * std::numbers::pi);
    sum += squared_norm(at - problem.poses[j].at) + std::pow(problem.angle_weight * turn, 2);
  }
  return sum;
}

void check(const Record& record, const MotionProblem& problem, const Design& design) {
  const double error = textbook_error(problem, design);
  EXPECT_TRUE(reaches(record, error, 1)) << error;
  EXPECT_GE(error, record.best_known * (1 - 1e-6)) << "better than the best known: update records";
}

template <class OtherProblem>
void check(const Record&, const OtherProblem&, const Design&) {
  FAIL() << "no record is of this kind of problem";
}

class Records : public testing::TestWithParam<int> {};

TEST_P(Records, AreReachedFromEverySeed) {
  const Record record = read_records()[static_cast<std::size_t>(GetParam())];
  const auto problem = problems::read_problem(record.file);
  ASSERT_TRUE(problem) << record.file << ": " << problem.error().front().message;
  for (int seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE(record.file.filename().string() + ", seed " + std::to_string(seed));
    std::visit(
        [&](const auto& target) {
          const auto result = solve(target, {.seed = static_cast<std::uint64_t>(seed)});
          ASSERT_EQ(result.status, problems::Status::solved);
          ASSERT_FALSE(result.designs.empty());
          for (const auto& constraint : result.designs.front().constraints) {
            EXPECT_TRUE(constraint.satisfied) << constraint.name;
          }
          check(record, target, result.designs.front());
        },
        *problem);
  }
}

INSTANTIATE_TEST_SUITE_P(Published, Records,
                         testing::Range(0, static_cast<int>(read_records().size())),
                         [](const auto& info) {
                           auto name = read_records()[info.param].file.stem().string();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace cognate
