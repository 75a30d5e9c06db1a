/// Exact synthesis of paths: planted linkages come back, for any units, threads and order; and
/// every problem without an answer is reported as such.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::synthesis::nine_point_solve_test {
namespace {

using Complex = std::complex<double>;

/// Slow builds ask for less: then Alt's problem is left to the oracle test.
bool is_slow() {
  return std::getenv("COGNATE_TEST_SEEDS") != nullptr;
}

/// A real four-bar with its coupler at angle 0 in the reference, and positions that it goes
/// through.
struct Planted {
  Complex moving[2], fixed[2];
  std::vector<PathPose> positions;
};

/// Places the coupler by the crank's angle, over `sweep`, and the law of cosines, the way the
/// analysis does, not by the equations of the solver.
Planted plant(std::mt19937_64& random, int poses, int points, double sweep = kTurn) {
  std::uniform_real_distribution<double> near(-0.3, 0.3), any(0, kTurn);
  const double crank = 0.5 + 0.3 * near(random), coupler = 2 + near(random);
  const double rocker = 1.6 + near(random), frame = 1.9 + near(random);
  const Complex traced(1 + near(random), 0.8 + near(random));  // from B along the coupler
  const auto coupler_at = [&](double angle, Complex& b, Complex& direction) {
    b = std::polar(crank, angle);
    const Complex to_pivot = frame - b;
    const double distance = std::abs(to_pivot);
    const double cosine =
        (coupler * coupler + distance * distance - rocker * rocker) / (2 * coupler * distance);
    direction = std::polar(1.0, std::arg(to_pivot) + std::acos(cosine));
  };
  const double start = any(random);
  Planted planted;
  Complex first, first_direction;
  for (int j = 0; j < poses + points; ++j) {
    Complex b, direction;
    const double evenly = double(j) / (poses + points);
    coupler_at(start + sweep * (evenly + 0.05 * near(random)), b, direction);
    const Complex at = b + traced * direction;
    if (j == 0) {
      first = at;
      first_direction = direction;
      planted.moving[0] = b;
      planted.moving[1] = b + coupler * direction;
    }
    PathPose pose{{at.real(), at.imag()}, {}};
    if (j < poses && poses > 1) pose.angle = std::arg(direction);
    planted.positions.push_back(pose);
  }
  planted.fixed[0] = 0;
  planted.fixed[1] = frame;
  return planted;
}

Complex in_plane(const PathSystem& system, const Complex& z) {
  const Vec2d at = to_plane(system, z);
  return {at.x, at.y};
}

/// The largest distance of the pivots of `root`, or of the same with its dyads swapped, from those
/// planted.
double distance(const PathSystem& system, const PathRoot& root, const Planted& planted) {
  double least = std::numeric_limits<double>::infinity();
  for (const bool swap : {false, true}) {
    const auto& first = swap ? root.second : root.first;
    const auto& second = swap ? root.first : root.second;
    least =
        std::min(least, std::max({std::abs(in_plane(system, first.moving) - planted.moving[0]),
                                  std::abs(in_plane(system, first.fixed) - planted.fixed[0]),
                                  std::abs(in_plane(system, second.moving) - planted.moving[1]),
                                  std::abs(in_plane(system, second.fixed) - planted.fixed[1])}));
  }
  return least;
}

/// Checks that one of the real roots, or a cognate of it, is the planted linkage as nearly as its
/// condition allows.
::testing::AssertionResult comes_back(const ExactPathSolutions& found, const Planted& planted) {
  double least = std::numeric_limits<double>::infinity();
  for (const PathRoot& root : found.roots) {
    if (!root.real) continue;
    std::vector<PathRoot> same{root};
    if (found.system.kind.poses == 1) {
      const auto triplet = cognates(found.system, root);
      same.assign(triplet.begin(), triplet.end());
    }
    for (const PathRoot& one : same) {
      const double allowed = 1e-13 + 1e-14 * root.condition;
      least = std::min(least, distance(found.system, one, planted) / allowed);
    }
  }
  if (least < 1) return ::testing::AssertionSuccess();
  auto failure = ::testing::AssertionFailure()
                 << "nearest at " << least << " times the tolerance; ";
  for (const PathPose& at : planted.positions) {
    failure << "{{" << at.at.x << ", " << at.at.y << "}, " << at.angle.value_or(NAN) << "}, ";
  }
  return failure;
}

TEST(NinePointSolve, FindsPlantedLinkages) {
  std::mt19937_64 random(4);
  const int trials[] = {
      0, is_slow() ? 0 : 3, is_slow() ? 0 : 3, is_slow() ? 2 : 20, is_slow() ? 5 : 50, 50};
  for (int poses = 1; poses <= 5; ++poses) {
    for (int trial = 0; trial < trials[poses]; ++trial) {
      const Planted planted = plant(random, poses, 10 - 2 * poses);
      const ExactPathSolutions found = solve_exact_path(planted.positions);
      ASSERT_EQ(found.status, ExactPathStatus::solved);
      EXPECT_EQ(found.finite, found.tracked) << "poses " << poses << " trial " << trial;
      EXPECT_TRUE(comes_back(found, planted)) << "poses " << poses << " trial " << trial;
    }
  }
}

/// Points that a crank meets within ten degrees: most paths need double-double numbers.
TEST(NinePointSolve, FindsTheLinkageOfAShortArc) {
  if (is_slow()) GTEST_SKIP();
  std::mt19937_64 random(7);
  const Planted planted = plant(random, 1, 8, kTurn / 36);
  const ExactPathSolutions found = solve_exact_path(planted.positions);
  EXPECT_EQ(found.lost, 0);
  EXPECT_TRUE(comes_back(found, planted));
}

TEST(NinePointSolve, HasConjugateRootsInPairs) {
  int tested = 0;
  std::mt19937_64 random(5);
  const ExactPathSolutions found = solve_exact_path(plant(random, 3, 4).positions);
  const auto trace = [](const PathRoot& root, bool bar) {
    return bar ? root.first.fixed_bar + root.second.fixed_bar
               : root.first.fixed + root.second.fixed;
  };
  bool complex_seen = false;
  for (const PathRoot& root : found.roots) {
    EXPECT_FALSE(root.real && complex_seen) << "real roots come first";
    complex_seen = complex_seen || !root.real;
    const auto is_partner = [&](const PathRoot& other) {
      return std::abs(trace(other, false) - std::conj(trace(root, true))) <
             1e-8 * (1 + std::abs(trace(root, true)));
    };
    EXPECT_TRUE(std::any_of(found.roots.begin(), found.roots.end(), is_partner));
    if (!root.real) continue;
    ++tested;
    EXPECT_EQ(root.first.moving_bar, std::conj(root.first.moving));
    EXPECT_EQ(root.second.fixed_bar, std::conj(root.second.fixed));
  }
  EXPECT_GE(tested, 18);
}

TEST(NinePointSolve, IsTheSameWhateverTheThreads) {
  std::mt19937_64 random(6);
  const Planted planted = is_slow() ? plant(random, 4, 2) : plant(random, 1, 8);
  ExactPathOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const auto a = solve_exact_path(planted.positions, one);
  const auto b = solve_exact_path(planted.positions, two);
  ASSERT_EQ(a.roots.size(), b.roots.size());
  for (std::size_t i = 0; i < a.roots.size(); ++i) {
    EXPECT_EQ(std::memcmp(&a.roots[i].first, &b.roots[i].first, sizeof a.roots[i].first), 0) << i;
    EXPECT_EQ(a.roots[i].rotations, b.roots[i].rotations) << i;
  }
}

TEST(NinePointSolve, DoesNotDependOnUnitsOrPlace) {
  std::mt19937_64 random(7);
  const Planted planted = plant(random, 4, 2);
  const auto plain = solve_exact_path(planted.positions);
  for (const double scale : {1e-12, 1e12}) {
    std::vector<PathPose> moved = planted.positions;
    for (PathPose& at : moved) at.at = scale * (at.at + Vec2d{3, -5});
    const auto found = solve_exact_path(moved);
    ASSERT_EQ(found.finite, plain.finite);
    for (std::size_t i = 0; i < plain.roots.size(); ++i) {
      EXPECT_EQ(found.roots[i].real, plain.roots[i].real);
      const double tolerance = 1e-14 * (1 + plain.roots[i].condition);
      EXPECT_LT(std::abs(found.roots[i].first.moving - plain.roots[i].first.moving), tolerance);
    }
  }
}

TEST(NinePointSolve, GivesCognatesThatAreSolutions) {
  int tested = 0;
  if (is_slow()) GTEST_SKIP();
  std::mt19937_64 random(8);
  const auto found = solve_exact_path(plant(random, 1, 8).positions);
  for (const PathRoot& root : found.roots) {
    if (!root.real) continue;
    ++tested;
    for (const PathRoot& one : cognates(found.system, root)) {
      for (std::size_t j = 0; j < 8; ++j) {
        const Complex turn = one.rotations[j];
        for (const auto* dyad : {&one.first, &one.second}) {
          const double link = std::abs(dyad->moving - dyad->fixed);
          const Complex turned = turn * dyad->moving + found.system.d[j] - dyad->fixed;
          EXPECT_NEAR(std::abs(turned), link, 1e-12 * (1 + root.condition));
        }
      }
    }
  }
  EXPECT_GE(tested, 82);
}

TEST(NinePointSolve, SaysWhyThereIsNoAnswer) {
  std::mt19937_64 random(9);
  const auto positions = plant(random, 4, 2).positions;
  const auto status = [](std::vector<PathPose> list) { return solve_exact_path(list).status; };
  EXPECT_EQ(status({}), ExactPathStatus::wrong_count);
  EXPECT_EQ(status({positions.begin(), positions.end() - 1}), ExactPathStatus::wrong_count);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    auto list = positions;
    list[2].at.x = bad;
    EXPECT_EQ(status(list), ExactPathStatus::not_finite);
  }
  auto list = positions;
  list[3].angle = std::nan("");
  EXPECT_EQ(status(list), ExactPathStatus::not_finite);
  list = positions;
  list[5] = {list[1].at, {}};
  const auto found = solve_exact_path(list);
  EXPECT_EQ(found.status, ExactPathStatus::coincident);
  EXPECT_EQ(found.coincident, (std::array{1, 5}));
}

TEST(NinePointSolve, StopsWhenAsked) {
  std::mt19937_64 random(10);
  ExactPathOptions options;
  options.stop = [] { return true; };
  const auto found = solve_exact_path(plant(random, 3, 4).positions, options);
  EXPECT_EQ(found.status, ExactPathStatus::interrupted);
  EXPECT_TRUE(found.roots.empty());
}

TEST(NinePointSolve, ReportsItsProgress) {
  std::mt19937_64 random(11);
  ExactPathOptions options;
  options.threads = 2;
  double last = 0;
  options.progress = [&](double share) {
    EXPECT_GT(share, last);
    EXPECT_LE(share, 1);
    last = share;
  };
  solve_exact_path(plant(random, 3, 4).positions, options);
  EXPECT_GT(last, 0.5);
}

// Poses with no turn between them are guided by parallel links alone: every dyad is at infinity.
TEST(NinePointSolve, CountsPathsToInfinityForTranslations) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<PathPose> list;
  for (int j = 0; j < 5; ++j) list.push_back({{any(random), any(random)}, 0.3});
  const auto found = solve_exact_path(list);
  EXPECT_EQ(found.status, ExactPathStatus::solved);
  EXPECT_EQ(found.finite, 0);
  EXPECT_EQ(found.at_infinity + found.singular, 6);
}

// Wampler, Morgan & Sommese met the same: four collinear points leave 1438 finite triplets, the
// other four having a slider in place of a crank.
TEST(NinePointSolve, SendsFourTripletsToInfinityForFourCollinearPoints) {
  if (is_slow()) GTEST_SKIP();
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<PathPose> list;
  for (int j = 0; j < 9; ++j) {
    const double s = any(random);
    list.push_back({j < 4 ? Vec2d{s, 0.25 + 0.5 * s} : Vec2d{s, any(random)}, {}});
  }
  const auto found = solve_exact_path(list);
  EXPECT_EQ(found.finite, 1438);
  EXPECT_EQ(found.at_infinity, 4);
  EXPECT_EQ(found.lost + found.singular + found.duplicates, 0);
}

}  // namespace
}  // namespace cognate::synthesis::nine_point_solve_test
