/// Closed curves as targets: planted coupler curves are found again, in place and as shapes.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/curve_following.hpp"
#include "problems/path/deviation_between_samples.hpp"
#include "problems/path/shape_placement.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::closed_path_test {
namespace {

/// Crank-rockers and a double crank.
const FourBar kPlanted[] = {
    {{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}},
    {{0, 0}, {-1.4, 1.1}, 0.5, 1.7, 1.5, Assembly::crossed, Vec2d{0.6, -0.9}},
    {{0, 0}, {0.6, 0.1}, 1.5, 1.2, 1.4, Assembly::open, Vec2d{0.5, 0.8}},
};

struct Move {
  double scale = 1, turn = 0;
  Vec2d shift;
  Vec2d operator()(const Vec2d& p) const {
    const Vec2d direction{std::cos(turn), std::sin(turn)};
    return shift + scale * (direction * p);
  }
};

/// The coupler curve of `linkage` as a polyline of many sides, moved.
std::string polyline(const FourBar& linkage, const Move& move = {}) {
  constexpr int kSides = 4000;
  std::string rows;
  for (int k = 0; k < kSides; ++k) {
    const Vec2d p = move(*Motion(linkage).at(kTurn * k / kSides)->coupler_point);
    rows += fmt::format("[{}, {}],", p.x, p.y);
  }
  return "kind = \"path-generation\"\n[target]\ncurve = [" + rows + "]\n";
}

PathProblem problem_of(const std::string& text) {
  const auto problem = parse_task(text);
  if (problem) return std::get<PathProblem>(*problem);
  for (const Fault& fault : problem.error()) ADD_FAILURE() << fault.line << ": " << fault.message;
  return {};
}

/// The fourth corner of the quadrilateral of links, by the law of cosines at D.
Vec2d coupler_point(const FourBar& linkage, double crank_angle) {
  const Vec2d b =
      linkage.pivot_a + linkage.crank * Vec2d{std::cos(crank_angle), std::sin(crank_angle)};
  const Vec2d diagonal = linkage.pivot_d - b;
  const double d = norm(diagonal), l2 = linkage.coupler, l3 = linkage.rocker;
  const double at_b = std::acos((l2 * l2 + d * d - l3 * l3) / (2 * l2 * d));
  const double angle =
      std::atan2(diagonal.y, diagonal.x) + (linkage.assembly == Assembly::open ? at_b : -at_b);
  return b + Vec2d{std::cos(angle), std::sin(angle)} * *linkage.coupler_point;
}

/// The greatest distance between two coupler curves, either way, from point to point.
double hausdorff(const FourBar& one, const FourBar& other, const Move& move) {
  constexpr int kPoints = 720;
  std::vector<Vec2d> a, b;
  for (int k = 0; k < kPoints; ++k) {
    a.push_back(coupler_point(one, kTurn * k / kPoints));
    b.push_back(move(coupler_point(other, kTurn * k / kPoints)));
  }
  const auto farthest = [](const auto& from, const auto& to) {
    double greatest = 0;
    for (const Vec2d& p : from) {
      double least = std::numeric_limits<double>::infinity();
      for (const Vec2d& q : to) least = std::min(least, norm(p - q));
      greatest = std::max(greatest, least);
    }
    return greatest;
  };
  return std::max(farthest(a, b), farthest(b, a));
}

double quantity(const std::vector<Quantity>& quantities, const std::string& name) {
  for (const Quantity& one : quantities) {
    if (one.name == name) return std::get<double>(one.value);
  }
  ADD_FAILURE() << "no " << name;
  return 0;
}

TEST(ClosedPath, APlantedCurveIsFoundFromEverySeed) {
  for (const FourBar& planted : kPlanted) {
    const PathProblem problem =
        problem_of(polyline(planted) + "[bounds]\nlength = [0.2, 5]\n[solve]\ndesigns = 1\n");
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Result result = solve(problem, {.seed = seed});
      ASSERT_EQ(result.status, Status::solved);
      const Design& best = result.designs.front();
      // The sides of the polyline are some 1e-3 long: they cut the curve by 1e-7 or so.
      EXPECT_LT(best.error.max, 2e-6) << planted.crank << " seed " << seed;
      EXPECT_LT(quantity(best.metrics.quantities, "curve_deviation_max"), 2e-6);
      EXPECT_LT(hausdorff(four_bar(best), planted, {}), 0.02);
      EXPECT_NEAR(quantity(result.quantities, "target_length"), problem.curve->curve.length(),
                  1e-12);
    }
  }
}

TEST(ClosedPath, AShapeIsFoundFromAllFourLengthsAndItsPlace) {
  // The figure is given 40 times as large, turned and elsewhere; the links in their own size.
  const Move move{40, 2.2, {-300, 125}};
  const FourBar& planted = kPlanted[0];
  const PathProblem problem =
      problem_of(polyline(planted, move) +
                 "place = \"similar\"\n[mechanism]\ncrank = 0.8\ncoupler = 1.9\nrocker = 1.6\n" +
                 fmt::format("fixed_pivots = [[{}, {}], [{}, {}]]\n", planted.pivot_a.x,
                             planted.pivot_a.y, planted.pivot_d.x, planted.pivot_d.y));
  for (const std::uint64_t seed : {1, 2}) {
    const Result result = solve(problem, {.seed = seed});
    ASSERT_EQ(result.status, Status::solved);
    const Design& best = result.designs.front();
    const FourBar& found = four_bar(best);
    EXPECT_LT(best.error.max, 40 * 2e-6);
    EXPECT_EQ(found.crank, planted.crank);
    EXPECT_EQ(found.pivot_a, planted.pivot_a);
    EXPECT_EQ(found.pivot_d, planted.pivot_d);
    EXPECT_EQ(found.assembly, planted.assembly);
    EXPECT_NEAR(norm(*found.coupler_point - *planted.coupler_point), 0, 1e-5);
    EXPECT_NEAR(quantity(best.metrics.quantities, "target_scale"), 1 / move.scale, 1e-8);
    EXPECT_NEAR(quantity(best.metrics.quantities, "target_turn_deg"), -move.turn / kDegree, 1e-4);
    // p = R(-turn) (q - shift) / 40.
    const Vec2d back = Move{1 / move.scale, -move.turn, {}}(-move.shift);
    EXPECT_NEAR(quantity(best.metrics.quantities, "target_shift_x"), back.x, 1e-4);
    EXPECT_NEAR(quantity(best.metrics.quantities, "target_shift_y"), back.y, 1e-4);
  }
}

TEST(ClosedPath, BoundedLengthsAndTheirPlaceAreMetToTheDigit) {
  const PathProblem problem = problem_of(
      polyline(kPlanted[1], {0.01, 0.4, {1, 2}}) +
      "place = \"similar\"\n[mechanism]\ncrank = 50\npivot_d = [7, 8]\nframe_angle_deg = 30\n"
      "[bounds]\ncoupler = [100, 180]\nrocker = [140, 160]\nframe = [170, 190]\n[constraints]\n"
      "class = \"crank-rocker\"\n");
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& best = result.designs.front();
  EXPECT_LT(best.error.max, 2e-8);
  const FourBar& found = four_bar(best);
  EXPECT_EQ(found.crank, 50);
  EXPECT_NEAR(found.coupler, 170, 1e-3);
  EXPECT_NEAR(found.rocker, 150, 1e-3);
  EXPECT_EQ(found.pivot_d, (Vec2d{7, 8}));
  EXPECT_NEAR(frame_angle(found), 30 * kDegree, 1e-9);
  EXPECT_NEAR(quantity(best.metrics.quantities, "target_scale"), 1e4, 1);
  EXPECT_TRUE(all_satisfied(best.constraints));
}

TEST(ClosedPath, WithoutLimitsAShapeStaysInPlace) {
  const Result result =
      solve(problem_of(polyline(kPlanted[0]) + "place = \"similar\"\n[solve]\nstarts = 50\n"), {});
  ASSERT_EQ(result.status, Status::solved);
  const auto& quantities = result.designs.front().metrics.quantities;
  EXPECT_EQ(quantity(quantities, "target_scale"), 1);
  EXPECT_EQ(quantity(quantities, "target_turn_deg"), 0);
  EXPECT_EQ(quantity(quantities, "target_shift_x"), 0);
}

TEST(ClosedPath, ThreadsDoNotMatter) {
  const PathProblem problem = problem_of(polyline(kPlanted[2]) +
                                         "place = \"similar\"\n[bounds]\nlength = [10, 30]\n"
                                         "[solve]\nstarts = 60\n");
  const Result one = solve(problem, {.threads = 1}), three = solve(problem, {.threads = 3});
  ASSERT_EQ(one.designs.size(), three.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(one.designs[i].error.sum_of_squares, three.designs[i].error.sum_of_squares);
    EXPECT_EQ(one.designs[i].crank_angles, three.designs[i].crank_angles);
  }
}

/// Half of a coupler curve and back: all samples can be met, the other half is a loop too many.
TEST(ClosedPath, ALoopTooManyIsSeen) {
  const FourBar& planted = kPlanted[0];
  std::vector<Vec2d> half;
  for (int k = 0; k <= 100; ++k) half.push_back(coupler_point(planted, k * kPi / 100));
  for (int k = 99; k > 0; --k) half.push_back(half[static_cast<std::size_t>(k)] + Vec2d{1e-3, 0});
  const ClosedCurve curve(half);
  const double deviation = curve_deviation(curve, planted, {});
  double farthest = 0;
  for (int k = 0; k < 720; ++k) {
    const Vec2d p = coupler_point(planted, k * kPi / 360);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2d& q : half) least = std::min(least, norm(p - q));
    farthest = std::max(farthest, least);
  }
  EXPECT_GT(farthest, 0.3);
  EXPECT_NEAR(deviation, farthest, 1e-3);
  EXPECT_FALSE(check_extra_loop(curve, deviation, 1e-3).satisfied);
  EXPECT_TRUE(check_extra_loop(curve, 2e-3, 1e-3).satisfied);
}

/// Samples of an aerofoil are met best by linkages that leave it between two of them, by eight
/// times its chord: designs within it are found all the same.
TEST(ClosedPath, DesignsWithALoopTooManyDoNotHideTheOthers) {
  std::string rows;
  constexpr int kVertices = 60;
  for (int k = 0; k < kVertices; ++k) {
    const double angle = kTurn * k / kVertices, x = (1 + std::cos(angle)) / 2;
    const double half = 0.6 * (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x +
                               0.2843 * x * x * x - 0.1036 * x * x * x * x);
    const double camber = 0.15 * x * (1 - x);
    rows += fmt::format("[{}, {}],", 100 * x, 100 * (camber + (2 * k < kVertices ? half : -half)));
  }
  const Result result = solve(problem_of("kind = \"path-generation\"\n[target]\ncurve = [" + rows +
                                         "]\nplace = \"similar\"\n[bounds]\nlength = [20, 100]\n"
                                         "[solve]\nstarts = 250\ndesigns = 1\n"),
                              {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& best = result.designs.front();
  EXPECT_LT(best.error.rms, 0.25);
  EXPECT_LT(quantity(best.metrics.quantities, "curve_deviation_max"), 1);
}

TEST(DeviationBetweenSamples, RejectsLoopsAndOtherOrders) {
  const FourBar& planted = kPlanted[0];
  const auto samples = [&](double share) {
    PathProblem problem;
    problem.constraints.full_turn = problem.constraints.no_extra_loop = true;
    for (int k = 0; k < 40; ++k) {
      problem.points.push_back(coupler_point(planted, share * kTurn * k / 40));
    }
    return problem;
  };
  const auto angles = [](double share) {
    std::vector<double> all;
    for (int k = 0; k < 40; ++k) all.push_back(share * kTurn * k / 40);
    return all;
  };
  PathProblem whole = samples(1), part = samples(0.4);
  EXPECT_FALSE(DeviationBetweenSamples(whole).strays(planted, angles(1)));
  EXPECT_FALSE(
      DeviationBetweenSamples(whole).strays(planted, angles(-1)));  // the order alone is looked at
  EXPECT_TRUE(DeviationBetweenSamples(part).strays(planted, angles(0.4)));
  std::vector<double> swapped = angles(1);
  std::swap(swapped[3], swapped[20]);
  EXPECT_TRUE(DeviationBetweenSamples(whole).strays(planted, swapped));
  whole.constraints.no_order_defect = part.constraints.no_extra_loop = false;
  EXPECT_FALSE(DeviationBetweenSamples(whole).strays(planted, swapped));
  EXPECT_FALSE(DeviationBetweenSamples(part).strays(planted, angles(0.4)));
  part.constraints.no_extra_loop = true;
  part.constraints.full_turn = false;  // no closed curve
  EXPECT_FALSE(DeviationBetweenSamples(part).strays(planted, angles(0.4)));
}

/// The least turn into a range of directions, against a fine grid of turns.
TEST(ShapePlacement, TurnsAsLittleAsTheFrameAngleAllows) {
  PathProblem problem = problem_of(polyline(kPlanted[0]) + "place = \"similar\"\n");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-3 * kPi, 3 * kPi);
  for (int trial = 0; trial < 300; ++trial) {
    const double from = uniform(random);
    problem.bounds.frame_angle = Range{from, from + std::abs(uniform(random)) / 1.4};
    FourBar linkage = kPlanted[0];
    const double direction = uniform(random);
    linkage.pivot_d = linkage.pivot_a + Vec2d{std::cos(direction), std::sin(direction)};
    const double turn = placement_of(problem, linkage).turn;
    double least = std::numeric_limits<double>::infinity();
    constexpr int kGrid = 7200;
    for (int k = -kGrid; k <= kGrid; ++k) {
      const double tried = k * kPi / kGrid;
      for (int whole = -5; whole <= 5; ++whole) {
        const double angle = direction + tried + kTurn * whole;
        const bool inside =
            angle >= problem.bounds.frame_angle->min && angle <= problem.bounds.frame_angle->max;
        if (inside) least = std::min(least, std::abs(tried));
      }
    }
    if (std::isinf(least)) continue;  // narrower than the grid
    EXPECT_NEAR(std::abs(turn), least, kTurn / kGrid) << trial;
  }
}

TEST(ClosedPath, TheDrawingsOfTheLibraryAreFollowed) {
  const std::filesystem::path folder = std::filesystem::path(kLibraryFolder) / "path";
  const struct {
    const char* file;
    double rms;
  } drawings[] = {{"bean.toml", 2.5321}, {"drop-of-any-size.toml", 0.42125}};
  for (const auto& known : drawings) {
    const auto problem = read_task(folder / known.file);
    ASSERT_TRUE(problem) << known.file;
    for (const std::uint64_t seed : {1, 2}) {
      const Result result = solve(std::get<PathProblem>(*problem), {.seed = seed});
      ASSERT_EQ(result.status, Status::solved) << known.file;
      EXPECT_LT(result.designs.front().error.rms, known.rms) << known.file << " seed " << seed;
      for (const Design& design : result.designs) {
        EXPECT_TRUE(all_satisfied(design.constraints)) << known.file;
      }
    }
  }
}

}  // namespace
}  // namespace cognate::problems::closed_path_test
