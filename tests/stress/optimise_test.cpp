/// What a search must not care about: units, place, direction and numbering; and what it must: data
/// that a linkage draws, noise on them, and the border of what is possible.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/planted_path.hpp"

namespace cognate::problems {
namespace {

/// Slow builds try one case of each.
int cases(int many) {
  return std::getenv("COGNATE_TEST_SEEDS") ? 1 : many;
}

PathProblem from_library(const std::string& name) {
  return std::get<PathProblem>(*read_task(std::string(kLibraryFolder) + "/path/" + name + ".toml"));
}

struct Copy {
  double scale = 1, angle = 0;
  Vec2d shift;

  Vec2d operator()(const Vec2d& p) const {
    return scale * (Vec2d{std::cos(angle), std::sin(angle)} * p) + shift;
  }
};

/// At the scales of the specification, anywhere within some thousand sizes of the path.
std::vector<Copy> copies() {
  std::vector<Copy> all;
  for (const double scale : {1e-3, 1.0, 1e6}) {
    all.push_back({scale, 0, {}});
    all.push_back({scale, 2.1, {}});
    all.push_back({scale, -0.7, {-2e4 * scale, 3e4 * scale}});
  }
  all.resize(static_cast<std::size_t>(cases(int(all.size()))));
  return all;
}

/// Whether dimensions agree to a thousandth, as they do where the error is flat about its minimum.
bool is_copy(const FourBar& found, const FourBar& original, const Copy& copy) {
  const auto a = lengths(original), b = lengths(found);
  const double unit = copy.scale * a.frame;
  const auto near = [&](double Lengths<double>::*link) {
    return std::abs(b.*link - copy.scale * (a.*link)) < 1e-3 * unit;
  };
  return near(&Lengths<double>::crank) && near(&Lengths<double>::coupler) &&
         near(&Lengths<double>::rocker) && near(&Lengths<double>::frame) &&
         norm(found.pivot_a - copy(original.pivot_a)) < 1e-3 * unit &&
         norm(found.pivot_d - copy(original.pivot_d)) < 1e-3 * unit;
}

class Invariance : public ::testing::TestWithParam<const char*> {};

TEST_P(Invariance, OfTheBestDesign) {
  const PathProblem problem = from_library(GetParam());
  const Design best = solve(problem, {}).designs.front();
  for (const Copy& copy : copies()) {
    SCOPED_TRACE(::testing::Message() << "scale " << copy.scale << ", angle " << copy.angle);
    PathProblem other = problem;
    for (Vec2d& p : other.points) p = copy(p);
    const Result result = solve(other, {.seed = 2});
    ASSERT_EQ(result.status, Status::solved);
    const double squared = copy.scale * copy.scale;
    EXPECT_NEAR(result.designs.front().error.sum_of_squares / squared, best.error.sum_of_squares,
                1e-6 * best.error.sum_of_squares);
    // A cognate that is as good may come before it.
    EXPECT_TRUE(std::ranges::any_of(result.designs, [&](const Design& found) {
      return is_copy(four_bar(found), four_bar(best), copy);
    }));
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, Invariance,
                         ::testing::Values("textbook-eight-points", "textbook-ten-points"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(Numbering, DoesNotMatterWhereAnyOrderWillDo) {
  PathProblem problem = from_library("ten-point-ellipse");
  problem.points.pop_back();
  problem.weights.pop_back();
  const double cyclic = solve(problem, {}).designs.front().error.sum_of_squares;
  problem.order = PointOrder::any;
  std::mt19937_64 random(1);
  for (int i = 0; i < cases(3); ++i) {
    std::ranges::shuffle(problem.points, random);
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_NEAR(result.designs.front().error.sum_of_squares, cyclic, 1e-6 * cyclic);
  }
}

PathProblem drawn_by(const test::PlantedPath& planted, Timing timing) {
  PathProblem problem;
  for (const auto& position : test::positions_of(planted, 0)) {
    problem.points.push_back(position.at);
  }
  problem.timing = timing;
  if (timing != Timing::free) problem.crank_angles = planted.crank_angles;
  for (std::size_t j = 0; timing == Timing::mixed && j < problem.points.size(); ++j) {
    problem.has_crank_angle.push_back(j % 3 == 1);
  }
  problem.weights.assign(problem.points.size(), 1);
  return problem;
}

double rms(const Design& design) {
  return design.error.rms;
}

TEST(PlantedPaths, ComeBackToThePrecisionOfTheData) {
  std::mt19937_64 random(5);
  for (const Timing timing : {Timing::prescribed, Timing::free, Timing::mixed}) {
    for (int i = 0; i < cases(5); ++i) {
      const auto planted = test::random_crank_rocker(random, 12, 1.0);
      const Result result = solve(drawn_by(planted, timing), {});
      ASSERT_FALSE(result.designs.empty());
      EXPECT_LT(rms(result.designs.front()), 1e-8)
          << "timing " << static_cast<int>(timing) << ", case " << i;
    }
  }
}

/// The best design is at least as good as the linkage that drew the points before they were
/// disturbed.
TEST(PlantedPaths, DegradeSmoothlyWithNoise) {
  std::mt19937_64 random(6);
  for (const double noise : {1e-6, 1e-4, 1e-2}) {
    for (int i = 0; i < cases(4); ++i) {
      const auto planted = test::random_crank_rocker(random, 14, 1.0);
      PathProblem problem = drawn_by(planted, Timing::prescribed);
      std::normal_distribution<double> disturbance(0, noise);
      double squares = 0;
      for (Vec2d& p : problem.points) {
        const Vec2d change{disturbance(random), disturbance(random)};
        p = p + change;
        squares += squared_norm(change);
      }
      const Result result = solve(problem, {});
      ASSERT_FALSE(result.designs.empty());
      EXPECT_LE(result.designs.front().error.sum_of_squares, squares * (1 + 1e-9)) << noise;
    }
  }
}

/// All four lengths given: the transmission angle is what it is, to the last digits.
TEST(Border, PartsWhatIsPossibleFromWhatIsNot) {
  const Lengths<double> links{1, 3, 3.5, 4};
  const double least = std::acos((3 * 3 + 3.5 * 3.5 - 3 * 3) / (2 * 3 * 3.5));
  PathProblem problem = from_library("textbook-eight-points");
  problem.given.crank = links.crank;
  problem.given.coupler = links.coupler;
  problem.given.rocker = links.rocker;
  problem.given.frame = links.frame;
  for (const double off : {1e-3, 1e-5, 1e-7}) {
    problem.constraints.transmission_angle = Range{least - off, kPi};
    EXPECT_EQ(solve(problem, {}).status, Status::solved) << off;
    problem.constraints.transmission_angle = Range{least + off, kPi};
    EXPECT_EQ(solve(problem, {}).status, Status::infeasible) << off;
  }
}

}  // namespace
}  // namespace cognate::problems
