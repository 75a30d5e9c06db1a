/// Cams on a raster against all combinations, judged by code of the test's own: the textbook's
/// pitch curve at dense positions, its normal and curvature by differences.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems::cam_raster_test {
namespace {

constexpr double kDegree = kTurn / 360;
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// Up over 120 degrees, down over 100 after 60 at rest: cycloidal.
double displacement(double angle, double rise) {
  const auto part = [](double t) { return t - std::sin(kTurn * t) / kTurn; };
  const double at = angle - kTurn * std::floor(angle / kTurn);
  if (at < 120 * kDegree) return rise * part(at / (120 * kDegree));
  if (at < 180 * kDegree) return rise;
  if (at < 280 * kDegree) return rise * (1 - part((at - 180 * kDegree) / (100 * kDegree)));
  return 0;
}

struct Lengths {
  double base = 0, offset = 0, roller = 0, centre = 0, arm = 0;  // an arm of 0: a slide
};

/// What a file limits, and how far its follower goes.
struct Limits {
  double rise = 0, pressure = 0, convex = 0, profile_max = kNothing;
};

/// The roller's centre, and the direction in which the follower moves.
struct Place {
  Vec2d centre, direction;
};

Place place(const Lengths& d, double angle, double rise) {
  const double s = displacement(angle, rise), sine = std::sin(angle), cosine = std::cos(angle);
  if (d.arm == 0) {
    const double height = std::sqrt(d.base * d.base - d.offset * d.offset) + s;
    return {{height * sine + d.offset * cosine, height * cosine - d.offset * sine}, {sine, cosine}};
  }
  const double start =
      std::acos((d.centre * d.centre + d.arm * d.arm - d.base * d.base) / (2 * d.centre * d.arm));
  const double to = angle + start + s;
  return {{d.centre * sine - d.arm * std::sin(to), d.centre * cosine - d.arm * std::cos(to)},
          {-std::cos(to), std::sin(to)}};
}

double size(const Vec2d& v) {
  return std::hypot(v.x, v.y);
}

/// The greatest pressure angle in degrees; infinite where a limit is broken.
double judged(const Lengths& d, const Limits& limits) {
  if (d.roller >= d.base) return kNothing;
  if (d.arm == 0 && std::abs(d.offset) >= d.base) return kNothing;
  if (d.arm > 0 && (d.base <= std::abs(d.centre - d.arm) || d.base >= d.centre + d.arm)) {
    return kNothing;
  }
  double greatest = 0;
  constexpr double kStep = 1e-4;
  for (int i = 0; i < 1440; ++i) {
    const double at = (i + 0.37) * kTurn / 1440;
    const Place here = place(d, at, limits.rise);
    const Vec2d before = place(d, at - kStep, limits.rise).centre;
    const Vec2d after = place(d, at + kStep, limits.rise).centre;
    const Vec2d first{(after.x - before.x) / (2 * kStep), (after.y - before.y) / (2 * kStep)};
    const Vec2d second{(after.x - 2 * here.centre.x + before.x) / (kStep * kStep),
                       (after.y - 2 * here.centre.y + before.y) / (kStep * kStep)};
    const Vec2d normal{-first.y / size(first), first.x / size(first)};
    const double along = normal.x * here.direction.x + normal.y * here.direction.y;
    greatest = std::max(greatest, std::acos(std::min(1.0, std::abs(along))) / kDegree);
    if (!(greatest <= limits.pressure)) return kNothing;
    const double turning = second.x * first.y - second.y * first.x;  // > 0: convex
    const double radius = std::pow(size(first), 3) / turning - d.roller;
    if (turning > 0 && radius < limits.convex) return kNothing;
    const Vec2d profile{here.centre.x - d.roller * normal.x, here.centre.y - d.roller * normal.y};
    const Vec2d other{here.centre.x + d.roller * normal.x, here.centre.y + d.roller * normal.y};
    if (std::min(size(profile), size(other)) > limits.profile_max) return kNothing;
  }
  return greatest;
}

using Values = std::vector<double>;

/// The smallest; of these the largest roller; of these the least pressure angle.
struct Best {
  Lengths lengths;
  double pressure = kNothing;
  int combinations = 0;
};

struct Grid {
  Values base, offset{0}, roller, centre{0}, arm{0};
};

Best best_of(const Grid& grid, const Limits& limits) {
  Best best;
  best.combinations = static_cast<int>(grid.base.size() * grid.offset.size() * grid.roller.size() *
                                       grid.centre.size() * grid.arm.size());
  for (const double base : grid.base) {
    for (const double roller : grid.roller) {
      for (const double offset : grid.offset) {
        for (const double centre : grid.centre) {
          for (const double arm : grid.arm) {
            const Lengths d{base, offset, roller, centre, arm};
            const double pressure = judged(d, limits);
            if (pressure == kNothing) continue;
            const bool larger = roller > best.lengths.roller;
            const bool same = roller == best.lengths.roller;
            if (larger || (same && pressure < best.pressure)) {
              best.lengths = d;
              best.pressure = pressure;
            }
          }
        }
      }
    }
    if (best.pressure < kNothing) break;
  }
  return best;
}

Values multiples(double step, int first, int last) {
  Values all;
  for (int i = first; i <= last; ++i) all.push_back(i * step);
  return all;
}

std::string motion(const Limits& limits, std::string_view rise) {
  const auto part = [&](std::string_view law, int over, double by) {
    return by == 0 ? fmt::format("[[motion]]\nlaw = \"{}\"\nover_deg = {}\n", law, over)
                   : fmt::format("[[motion]]\nlaw = \"{}\"\nover_deg = {}\n{} = {}\n", law, over,
                                 rise, by);
  };
  const double by = rise == "rise" ? limits.rise : limits.rise / kDegree;
  return part("cycloidal", 120, by) + part("dwell", 60, 0) + part("cycloidal", 100, -by) +
         part("dwell", 80, 0);
}

std::string constraints(const Limits& limits) {
  std::string text =
      fmt::format("[constraints]\npressure_angle_deg_max = {}\ncurvature_radius_min = {}\n",
                  limits.pressure, limits.convex);
  if (limits.profile_max < kNothing) {
    text += fmt::format("profile_radius_max = {}\n", limits.profile_max);
  }
  return text;
}

CamResult solved(const std::string& file, int threads = 1) {
  const auto problem = parse_task<CamProblem>(file);
  EXPECT_TRUE(problem) << file;
  return problem ? solve(*problem, {.threads = threads}) : CamResult{};
}

double fact(const CamResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.quantities, name, &Quantity::name);
  if (found == result.quantities.end()) return -1;
  if (const auto* truth = std::get_if<bool>(&found->value)) return *truth ? 1 : 0;
  return std::get<double>(found->value);
}

void expect_best(const CamResult& result, const Best& best, const std::string& file) {
  SCOPED_TRACE(file);
  EXPECT_EQ(fact(result, "raster_proven"), 1);
  EXPECT_EQ(fact(result, "raster_combinations"), best.combinations);
  if (best.pressure == kNothing) {
    EXPECT_TRUE(result.designs.empty());
    return;
  }
  ASSERT_FALSE(result.designs.empty());
  EXPECT_TRUE(all_satisfied(result.designs.front().constraints));
  const auto& found = result.designs.front().cam.system.follower.dimensions;
  EXPECT_DOUBLE_EQ(found.base_radius, best.lengths.base);
  EXPECT_DOUBLE_EQ(found.roller_radius, best.lengths.roller);
  const auto& checks = result.designs.front().constraints;
  const auto pressure = std::ranges::find(checks, "pressure_angle_deg_max", &ConstraintCheck::name);
  ASSERT_NE(pressure, checks.end());
  EXPECT_NEAR(std::get<double>(pressure->value), best.pressure, 1e-2);
  EXPECT_EQ(fact(result, "raster_size"), found.base_radius);
  const double between = fact(result, "continuous_size");
  EXPECT_LE(between, found.base_radius * (1 + 1e-9));
}

/// A whole number from `first`, below `end`.
double drawn(std::mt19937& random, int first, int end) {
  return first + static_cast<int>(random() % static_cast<unsigned>(end - first));
}

TEST(CamRaster, SlidingRollerIsTheBestOfAllCombinations) {
  std::mt19937 random(7);
  int with_answer = 0;
  for (int i = 0; i < 12; ++i) {
    const Limits limits{drawn(random, 10, 30), drawn(random, 20, 40), drawn(random, 0, 12),
                        i % 3 == 0 ? drawn(random, 50, 70) : kNothing};
    const double step = 1 + 0.5 * drawn(random, 0, 3);
    const std::string file = fmt::format(
        "kind = \"cam\"\nfollower = {{type = \"translating-roller\"}}\n"
        "bounds = {{base_radius = [0, 60], offset = [-12, 12]}}\n"
        "raster = {{base_radius = {}, offset = 3, roller_radius = [4, 6.5, 8, 11]}}\n{}{}",
        step, constraints(limits), motion(limits, "rise"));
    const Grid grid{.base = multiples(step, 1, static_cast<int>(60 / step + 1e-9)),
                    .offset = multiples(3, -4, 4),
                    .roller = {4, 6.5, 8, 11}};
    const Best best = best_of(grid, limits);
    with_answer += best.pressure < kNothing ? 1 : 0;
    expect_best(solved(file), best, file);
  }
  EXPECT_GE(with_answer, 6);
}

TEST(CamRaster, SwingingRollerIsTheBestOfAllCombinations) {
  std::mt19937 random(3);
  int with_answer = 0;
  for (int i = 0; i < 8; ++i) {
    const Limits limits{drawn(random, 12, 24) * kDegree, drawn(random, 30, 45),
                        drawn(random, 0, 6)};
    const std::string file = fmt::format(
        "kind = \"cam\"\nfollower = {{type = \"oscillating-roller\"}}\n"
        "bounds = {{centre_distance = [50, 110]}}\n"
        "raster = {{length = 2, centre_distance = 10, arm = [40, 55, 70, 80], "
        "roller_radius = [5, 9]}}\n{}{}",
        constraints(limits), motion(limits, "rise_deg"));
    const Grid grid{.base = multiples(2, 1, 95),
                    .roller = {5, 9},
                    .centre = multiples(10, 5, 11),
                    .arm = {40, 55, 70, 80}};
    const Best best = best_of(grid, limits);
    with_answer += best.pressure < kNothing ? 1 : 0;
    expect_best(solved(file, 2), best, file);
  }
  EXPECT_GE(with_answer, 4);
}

/// A face's radius of curvature is r + s + s″, here r + 4 everywhere: a circle out of its centre.
TEST(CamRaster, FaceTakesTheNextSizeAboveItsCurvature) {
  const std::string file = R"(
    kind = "cam"
    follower = {type = "translating-flat"}
    constraints = {curvature_radius_min = 12}
    raster = {base_radius = 0.3}
    [[motion]]
    law = "harmonic"
    over_deg = 180
    rise = 8
    [[motion]]
    law = "harmonic"
    over_deg = 180
    rise = -8
  )";
  const auto result = solved(file);
  ASSERT_FALSE(result.designs.empty());
  EXPECT_EQ(result.designs.front().cam.system.follower.dimensions.base_radius, 8.1);
  EXPECT_NEAR(fact(result, "continuous_size"), 8, 1e-9);
  EXPECT_EQ(fact(result, "rounded_feasible"), 1);
}

/// The answer of a list is the smaller of those with either value given.
TEST(CamRaster, AFaceIsSetOffByTheValuesOfItsList) {
  const auto file = [](std::string_view given, std::string_view on_raster) {
    return fmt::format(R"(
      kind = "cam"
      follower = {{type = "oscillating-flat"{}}}
      constraints = {{curvature_radius_min = 3, profile_radius_min = 14, pressure_angle_deg_max = 12}}
      bounds = {{base_radius = [5, 100], centre_distance = [30, 90]}}
      raster = {{base_radius = 1, centre_distance = 3{}}}
      motion = [{{law = "3-4-5", over_deg = 110, rise_deg = 14}}, {{law = "dwell", over_deg = 50}},
                {{law = "cycloidal", over_deg = 90, rise_deg = -14}},
                {{law = "dwell", over_deg = 110}}]
    )",
                       given, on_raster);
  };
  const auto best = solved(file("", ", face_offset = [2, 5]"));
  double smallest = kNothing;
  for (const std::string_view given : {", face_offset = 2", ", face_offset = 5"}) {
    const auto own = solved(file(given, ""));
    ASSERT_FALSE(own.designs.empty());
    smallest = std::min(smallest, own.designs.front().cam.system.follower.dimensions.base_radius);
  }
  ASSERT_FALSE(best.designs.empty());
  const auto& found = best.designs.front().cam.system.follower.dimensions;
  EXPECT_TRUE(found.face_offset == 2 || found.face_offset == 5) << found.face_offset;
  EXPECT_EQ(found.base_radius, smallest);
}

constexpr std::string_view kHead = R"(
  kind = "cam"
  [[motion]]
  law = "cycloidal"
  over_deg = 180
  rise = 20
  [[motion]]
  law = "cycloidal"
  over_deg = 180
  rise = -20
  [constraints]
  pressure_angle_deg_max = 30
  [follower]
  type = "translating-roller"
)";

TEST(CamRaster, RefusesWhatItCannotTry) {
  const auto fault = [](std::string_view more) {
    const auto problem = parse_task<CamProblem>(std::string(kHead) + std::string(more));
    std::string all;
    if (!problem) {
      for (const auto& one : problem.error()) all += one.message + "\n";
    }
    return all;
  };
  EXPECT_NE(fault("roller_radius = 5\n[raster]\nbase_radius = 1\n").find("leaves offset free"),
            std::string::npos);
  EXPECT_NE(fault("[raster]\nlength = 1\n").find("without end"), std::string::npos);
  EXPECT_NE(fault("[raster]\nlength = 0.01\n[bounds]\noffset = [-5, 5]\nroller_radius = [1, 5]\n")
                .find("at most 20000"),
            std::string::npos);
  EXPECT_NE(fault("roller_radius = 5\n[raster]\nlength = 1\nboxes = 5\n[bounds]\noffset = [0, 5]\n")
                .find("branch and bound"),
            std::string::npos);
  EXPECT_NE(fault("roller_radius = 5\n[raster]\ncenter = 1\n").find("\"base_radius\""),
            std::string::npos);
  EXPECT_NE(fault("roller_radius = 5\n[raster]\nbase_radius = 1\noffset = 1\nroller_radius = [4]\n")
                .find("raster.roller_radius is of a length that is given as 5"),
            std::string::npos);
  EXPECT_EQ(fault("roller_radius = 5\n[raster]\nbase_radius = -1\n").find("puts no dimension"),
            std::string::npos);
  EXPECT_NE(fault("roller_radius = 5\n[raster]\nlength = 4\n[bounds]\noffset = [1, 3]\n")
                .find("has no value of offset"),
            std::string::npos);
  EXPECT_NE(fault("roller_radius = 5\n[target]\nobjective = \"pressure-angle\"\n[bounds]\n"
                  "base_radius = [1, 90]\noffset = [0, 3]\n[raster]\nlength = 1\n")
                .find("target.objective"),
            std::string::npos);
}

}  // namespace
}  // namespace cognate::problems::cam_raster_test
