/// Body guidance on a raster against all combinations, evaluated by code of the test's own: the
/// textbook's triangle for closure, the crank scanned for each pose and refined by golden sections.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems::guidance_raster_test {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

struct Place {
  double x, y, angle;
};

/// Pivots A and D of the frame, B and C in the body's axes, the two links.
struct Guide {
  Vec2d a, d, b, c;
  double crank, rocker;
};

/// Where the body stands, by the law of cosines in the triangle B, C, D; `side` +1 where C is to
/// the left of B→D.
std::optional<Place> body(const Guide& guide, double angle, int side) {
  const double bx = guide.a.x + guide.crank * std::cos(angle);
  const double by = guide.a.y + guide.crank * std::sin(angle);
  const double coupler = std::hypot(guide.c.x - guide.b.x, guide.c.y - guide.b.y);
  const double way = std::hypot(guide.d.x - bx, guide.d.y - by);
  const double cosine =
      (coupler * coupler + way * way - guide.rocker * guide.rocker) / (2 * coupler * way);
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  const double to = std::atan2(guide.d.y - by, guide.d.x - bx) + side * std::acos(cosine);
  const double turned = to - std::atan2(guide.c.y - guide.b.y, guide.c.x - guide.b.x);
  const double s = std::sin(turned), k = std::cos(turned);
  return Place{bx - (k * guide.b.x - s * guide.b.y), by - (s * guide.b.x + k * guide.b.y), turned};
}

double miss(const Guide& guide, const Place& pose, double weight, double angle, int side) {
  const auto at = body(guide, angle, side);
  if (!at) return kNothing;
  const double turned = weight * std::remainder(at->angle - pose.angle, kTurn);
  return std::pow(at->x - pose.x, 2) + std::pow(at->y - pose.y, 2) + turned * turned;
}

/// The least over the crank's turn: of the deepest of 1440 angles and its neighbours.
double least_miss(const Guide& guide, const Place& pose, double weight, int side) {
  constexpr int kScan = 1440;
  int least = 0;
  double value = kNothing;
  for (int k = 0; k < kScan; ++k) {
    const double at = miss(guide, pose, weight, kTurn * k / kScan, side);
    if (at < value) value = at, least = k;
  }
  double low = kTurn * (least - 1) / kScan, high = kTurn * (least + 1) / kScan;
  for (int i = 0; i < 80; ++i) {
    const double one = low + 0.381966 * (high - low), two = high - 0.381966 * (high - low);
    const bool left = miss(guide, pose, weight, one, side) < miss(guide, pose, weight, two, side);
    (left ? high : low) = left ? two : one;
  }
  return std::min(value, miss(guide, pose, weight, 0.5 * (low + high), side));
}

double error_of(const Guide& guide, const std::vector<Place>& poses, double weight) {
  double best = kNothing;
  for (const int side : {-1, 1}) {
    double sum = 0;
    for (const Place& pose : poses) sum += least_miss(guide, pose, weight, side);
    best = std::min(best, sum);
  }
  return best;
}

struct Window {
  std::vector<Place> poses;
  std::vector<double> crank, rocker;
  Vec2d a, b;                                // given
  std::array<double, 2> c_u, c_v, d_x, d_y;  // bounds, on a raster of 0.5

  std::string text() const {
    std::string rows;
    for (const Place& pose : poses) {
      rows += fmt::format("[{}, {}, {}],", pose.x, pose.y, pose.angle * 360 / kTurn);
    }
    return fmt::format(
        "kind = \"motion-generation\"\n[target]\nposes = [{}]\nmethod = \"least-squares\"\n"
        "angle_weight = 2\n[mechanism]\nfixed_pivots = [[{}, {}]]\nmoving_pivots = [[{}, {}]]\n"
        "[bounds]\npivot_d = [[{}, {}], [{}, {}]]\nmoving_pivot_d = [[{}, {}], [{}, {}]]\n"
        "[constraints]\nno_circuit_defect = false\nno_order_defect = false\n"
        "[raster]\ncrank = [{}]\nrocker = [{}]\npivots = 0.5\nmoving_pivots = 0.5\n"
        "[solve]\ndesigns = 1\nstarts = 40\n",
        rows, a.x, a.y, b.x, b.y, d_x[0], d_y[0], d_x[1], d_y[1], c_u[0], c_v[0], c_u[1], c_v[1],
        fmt::join(crank, ", "), fmt::join(rocker, ", "));
  }
};

Window window(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto half = [](double value) { return std::round(2 * value) / 2; };
  Window made;
  const double crank = 1.5 + share(random), rocker = 3 + 1.5 * share(random);
  for (const double by : {0.9, 1.0, 1.1}) {
    made.crank.push_back(std::round(20 * crank * by) / 20);
    made.rocker.push_back(std::round(20 * rocker * by) / 20);
  }
  made.a = {0, 0};
  made.b = {half(share(random)), half(share(random))};
  const Vec2d c{made.b.x + 3 + share(random), made.b.y + share(random)};
  const Vec2d d{4 + share(random), share(random) - 0.5};
  made.c_u = {half(c.x) - 0.5, half(c.x) + 0.5};
  made.c_v = {half(c.y), half(c.y) + 0.5};
  made.d_x = {half(d.x), half(d.x) + 0.5};
  made.d_y = {half(d.y) - 0.5, half(d.y)};
  const int side = share(random) < 0.5 ? -1 : 1;
  const double first = kTurn * share(random);
  for (int j = 0; j < 5; ++j) {
    const auto at = body({made.a, d, made.b, c, crank, rocker}, first + 0.3 * j, side);
    if (!at) return window(seed + 1000);
    made.poses.push_back({at->x + 0.1 * share(random), at->y + 0.1 * share(random),
                          at->angle + 0.05 * share(random)});
  }
  return made;
}

/// Of all combinations. Bounds of the other dyad's pivots make that on the given ones the driven.
double least_of_all(const Window& window) {
  double best = kNothing;
  const auto each = [](const std::array<double, 2>& range, const auto& body) {
    for (double value = range[0]; value <= range[1] + 1e-9; value += 0.5) body(value);
  };
  for (const double crank : window.crank) {
    for (const double rocker : window.rocker) {
      each(window.c_u, [&](double u) {
        each(window.c_v, [&](double v) {
          each(window.d_x, [&](double x) {
            each(window.d_y, [&](double y) {
              const Guide guide{window.a, {x, y}, window.b, {u, v}, crank, rocker};
              best = std::min(best, error_of(guide, window.poses, 2));
            });
          });
        });
      });
    }
  }
  return best;
}

MotionProblem problem_of(const std::string& text) {
  const auto problem = parse_task(text);
  if (problem) return std::get<MotionProblem>(*problem);
  for (const Fault& fault : problem.error()) ADD_FAILURE() << fault.line << ": " << fault.message;
  return {};
}

bool proven(const Result& result) {
  return find_quantity(result.quantities, QuantityKey<bool>{"raster_proven"}).value_or(false);
}

TEST(GuidanceRaster, IsTheBestOfAllCombinations) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Window small = window(seed);
    SCOPED_TRACE(small.text());
    const Result result = solve(problem_of(small.text()), {.threads = 1});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(proven(result));
    const double best = least_of_all(small);
    const Design& design = result.designs.front();
    EXPECT_NEAR(design.error.sum_of_squares, best, 1e-6 * best);
    EXPECT_TRUE(all_satisfied(design.constraints));
    const FourBar& found = four_bar(design);
    EXPECT_EQ(found.pivot_d.x, std::round(2 * found.pivot_d.x) / 2);
    EXPECT_EQ(found.pivot_d.y, std::round(2 * found.pivot_d.y) / 2);
    EXPECT_EQ(std::ranges::count(small.crank, found.crank), 1);
    EXPECT_EQ(std::ranges::count(small.rocker, found.rocker), 1);
  }
}

TEST(GuidanceRaster, ProvesNothingOfWhatIsFreeBesideTheRaster) {
  const auto is_proven = [](const std::string& raster) {
    const Result result = solve(
        problem_of("kind = \"motion-generation\"\n[target]\nmethod = \"least-squares\"\n"
                   "poses = [[0, 0, 0], [1, 0.5, 10], [2, 0.4, 25], [2.6, 0.1, 41]]\n[raster]\n" +
                   raster),
        {.threads = 1});
    EXPECT_FALSE(result.designs.empty());
    return proven(result);
  };
  EXPECT_FALSE(is_proven("crank = [1, 1.5, 2]\n"));
}

/// No worse than any combination whose lengths are given in a file of its own.
TEST(GuidanceRaster, SearchesWhatIsFreeBesideTheRasterByItself) {
  const std::string file =
      "kind = \"motion-generation\"\n[target]\nmethod = \"least-squares\"\n"
      "poses = [[0, 0, 0], [1, 0.5, 10], [2, 0.4, 25], [2.6, 0.1, 41], [3, -0.8, 50], [2.4, -2, "
      "20]]\n";
  const Result on_raster =
      solve(problem_of(file + "[raster]\ncrank = [1, 2]\nrocker = [1.5, 3]\n"), {.threads = 2});
  ASSERT_FALSE(on_raster.designs.empty());
  const double best = on_raster.designs.front().error.rms;
  for (const double crank : {1.0, 2.0}) {
    for (const double rocker : {1.5, 3.0}) {
      const Result given =
          solve(problem_of(file + fmt::format("[mechanism]\ndyads = [\"RR\"]\ncrank = {}\nrocker = "
                                              "{}\n",
                                              crank, rocker)),
                {.seed = 7, .threads = 2});
      if (given.status != Status::solved) continue;
      EXPECT_LE(best, given.designs.front().error.rms * (1 + 1e-5)) << crank << ' ' << rocker;
    }
  }
}

/// The crank angles nearest to the poses break their order at every combination: each is searched
/// all the same.
TEST(GuidanceRaster, SearchesCombinationsThatBreakALimitWhereTheyAreTried) {
  const std::string file =
      "kind = \"motion-generation\"\n[target]\nmethod = \"least-squares\"\nangle_weight = 2\n"
      "poses = [[-0.638, 2.789, 0.156], [-0.527, 2.703, 0.692], [-0.456, 2.717, 2.258], [-0.355, "
      "2.762, 2.378], [-0.228, 2.752, 5.121], [-0.202, 2.829, 6.709], [-0.152, 2.887, 8.082], "
      "[-0.094, 2.975, 10.447]]\n[bounds]\nlength = [0.3, 12]\npivot_a = [[-6, -6], [6, 6]]\n"
      "pivot_d = [[-8, -8], [8, 8]]\n[solve]\nstarts = 100\n";
  const Result on_raster = solve(problem_of(file + "[raster]\npivots = [-1, 6]\n"), {.threads = 2});
  const Result given = solve(
      problem_of(file + "[mechanism]\ndyads = [\"RR\"]\nfixed_pivots = [[6, -1], [-1, -1]]\n"),
      {.seed = 2, .threads = 2});
  ASSERT_EQ(given.status, Status::solved);
  ASSERT_EQ(on_raster.status, Status::solved);
  EXPECT_LE(on_raster.designs.front().error.rms, 1.05 * given.designs.front().error.rms);
}

TEST(GuidanceRaster, RefusesWhatItCannotDo) {
  const auto fault = [](const std::string& text) {
    const auto read = parse_task("kind = \"motion-generation\"\n" + text);
    return read ? std::string() : read.error().front().message;
  };
  const std::string poses = "[target]\nposes = [[0, 0, 0], [1, 0.5, 10], [2, 0.4, 25]]\n";
  EXPECT_NE(fault(poses + "[raster]\nlength = 1\n").find("met exactly"), std::string::npos);
  const std::string nearest = poses + "method = \"least-squares\"\n[raster]\nlength = 1\n";
  EXPECT_NE(fault(nearest + "[mechanism]\ndyads = [\"RR\", \"PR\"]\n").find("four-bars"),
            std::string::npos);
  EXPECT_NE(fault(nearest + "[constraints]\nno_branch_defect = false\nno_circuit_defect = false\n")
                .find("assembly of its own"),
            std::string::npos);
  EXPECT_NE(fault(nearest + "[bounds]\ncrank = [0.2, 0.8]\n").find("no value of crank"),
            std::string::npos);
}

}  // namespace
}  // namespace cognate::problems::guidance_raster_test
