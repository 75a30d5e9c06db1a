/// Quick returns on a raster against all combinations, judged by the test's own triangles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/read.hpp"

namespace cognate::problems::quick_return_raster_test {
namespace {

constexpr double kDegreeOf = kTurn / 360;

using Values = std::vector<double>;

/// A combination: its lengths in the order of the grid, the error, the second merit, the size.
struct Tried {
  Values lengths;
  double error = 0, second = 0, size = 0;
};

/// Whether a is better than b by the rules of the documentation, rounding apart.
bool is_better(const Tried& a, const Tried& b) {
  constexpr double kEqual = 1e-9;
  if (std::abs(a.error - b.error) > kEqual) return a.error < b.error;
  if (std::abs(a.second - b.second) > kEqual) return a.second < b.second;
  return a.size < b.size;
}

/// The best of the product of `grid` by `judge`, which gives nothing where a limit is broken.
template <class Judge>
std::optional<Tried> best_of(const std::vector<Values>& grid, const Judge& judge) {
  std::optional<Tried> best;
  std::vector<std::size_t> at(grid.size(), 0);
  for (;;) {
    Values lengths;
    for (std::size_t i = 0; i < grid.size(); ++i) lengths.push_back(grid[i][at[i]]);
    const std::optional<Tried> tried = judge(lengths);
    if (tried && (!best || is_better(*tried, *best))) best = tried;
    std::size_t axis = 0;
    while (axis < grid.size() && ++at[axis] == grid[axis].size()) at[axis++] = 0;
    if (axis == grid.size()) return best;
  }
}

Values multiples(double step, int first, int last) {
  Values all;
  for (int i = first; i <= last; ++i) all.push_back(i * step);
  return all;
}

double sum(const Values& all) {
  double total = 0;
  for (const double value : all) total += std::abs(value);
  return total;
}

/// The angle at the origin of a triangle with a corner on the x axis at `p`, the other side being
/// `q` and the opposite one `r`: by its corner's coordinates.
double corner_angle(double p, double q, double r) {
  const double x = (p * p + q * q - r * r) / (2 * p);
  return std::atan2(std::sqrt(std::max(0.0, q * q - x * x)), x);
}

/// What is desired and limited, in degrees.
struct Wish {
  double ratio = 1, swing = 0, stroke = 0;
  double transmission = 0, links = std::numeric_limits<double>::infinity(), pressure = 90;

  double theta() const { return kPi * (ratio - 1) / (ratio + 1); }
};

std::optional<Tried> rocker(const Wish& wish, const Values& l) {
  const double a = l[0], c = l[1], r = l[2], f = l[3];
  const auto [shortest, longest] = std::minmax({a, c, r, f});
  if (a != shortest || !(2 * (shortest + longest) < a + c + r + f)) return std::nullopt;
  if (longest > wish.links * shortest) return std::nullopt;
  const double theta = std::abs(corner_angle(f, c - a, r) - corner_angle(f, c + a, r));
  const double swing = std::abs(corner_angle(f, r, c + a) - corner_angle(f, r, c - a));
  const double least =
      std::min(corner_angle(c, r, f - a), kPi - corner_angle(c, r, f + a)) / kDegreeOf;
  if (least < wish.transmission) return std::nullopt;
  return Tried{l,
               std::max(std::abs(theta - wish.theta()), std::abs(swing - wish.swing * kDegreeOf)),
               -least * kDegreeOf, sum(l)};
}

std::optional<Tried> slider(const Wish& wish, const Values& l) {
  const double a = l[0], b = l[1], e = std::abs(l[2]);
  if (!(a + e < b)) return std::nullopt;
  const auto at = [&](double reach) { return std::sqrt(reach * reach - e * e); };
  const double theta = std::atan2(e, at(b - a)) - std::atan2(e, at(b + a));
  const double pressure = std::asin((a + e) / b);
  if (pressure > wish.pressure * kDegreeOf) return std::nullopt;
  return Tried{
      l,
      std::max(std::abs(theta - wish.theta()), std::abs((at(b + a) - at(b - a)) / wish.stroke - 1)),
      pressure, sum(l)};
}

/// The ram of the shaper followed by positions of its crank: where it stands, and how its rod
/// leans.
std::optional<Tried> shaper(const Wish& wish, const Values& l) {
  const double a = l[0], f = l[1], bar = l[2], rod = l[3], height = l[4];
  if (!(a < f) || bar < f + a) return std::nullopt;
  constexpr int kPositions = 720;
  double left = std::numeric_limits<double>::infinity(), right = -left, steepest = 0;
  int turns = 0;
  double last = 0, before = 0;
  for (int i = 0; i < kPositions + 2; ++i) {
    const double crank = (i + 0.5) * kTurn / kPositions;
    const double x = a * std::cos(crank), y = f + a * std::sin(crank);
    const double far = std::hypot(x, y);
    const double lean = (height - bar * y / far) / rod;
    if (std::abs(lean) >= 1) return std::nullopt;
    steepest = std::max(steepest, std::asin(std::abs(lean)));
    const double ram = bar * x / far - rod * std::sqrt(1 - lean * lean);
    left = std::min(left, ram);
    right = std::max(right, ram);
    if (i >= 2 && (ram - last) * (last - before) < 0) ++turns;
    before = last;
    last = ram;
  }
  if (turns > 2 || steepest > wish.pressure * kDegreeOf) return std::nullopt;
  const double theta = 2 * std::asin(a / f);
  return Tried{l,
               std::max(std::abs(theta - wish.theta()), std::abs((right - left) / wish.stroke - 1)),
               steepest, sum(l)};
}

Result solved(const std::string& file) {
  const auto problem = parse_task<QuickReturnProblem>(file);
  EXPECT_TRUE(problem) << file;
  return problem ? solve(*problem, {.threads = 1}) : Result{};
}

double fact(const Result& result, std::string_view name) {
  const auto found = std::ranges::find(result.quantities, name, &Quantity::name);
  if (found == result.quantities.end()) return -1;
  if (const auto* truth = std::get_if<bool>(&found->value)) return *truth ? 1 : 0;
  return std::get<double>(found->value);
}

/// The lengths that were found, in the order of the grid.
Values found_lengths(const Design& design) {
  const auto& description = design.mechanism.description;
  if (const auto* bar = std::get_if<FourBar>(&description)) {
    return {bar->crank, bar->coupler, bar->rocker,
            std::hypot(bar->pivot_a.x - bar->pivot_d.x, bar->pivot_a.y - bar->pivot_d.y)};
  }
  if (const auto* bar = std::get_if<SliderCrank>(&description)) {
    return {bar->crank, bar->coupler, bar->offset};
  }
  if (const auto* bar = std::get_if<GuideBar>(&description)) return {bar->crank, bar->pivot_a.y};
  return {};
}

void expect_same(const Result& result, const std::optional<Tried>& best, double unit,
                 std::string_view word, const std::string& file) {
  SCOPED_TRACE(file);
  EXPECT_EQ(fact(result, "raster_proven"), 1);
  EXPECT_EQ(fact(result, "raster_covered"), fact(result, "raster_combinations"));
  if (!best) {
    EXPECT_TRUE(result.designs.empty());
    return;
  }
  ASSERT_FALSE(result.designs.empty());
  EXPECT_TRUE(all_satisfied(result.designs.front().constraints));
  EXPECT_NEAR(fact(result, fmt::format("raster_{}", word)) * unit, best->error, 1e-9);
  const double rounded = fact(result, fmt::format("rounded_{}", word));
  if (rounded >= 0 && fact(result, "rounded_feasible") == 1) {
    EXPECT_GE(rounded * unit, best->error - 1e-9);
  }
  const Values found = found_lengths(result.designs.front());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], best->lengths[i], 1e-9);
}

double drawn(std::mt19937& random, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(random() % 1000) / 1000;
}

TEST(QuickReturnRaster, RockerGivenIsTheBestOfAllCombinations) {
  std::mt19937 random(1);
  int with_answer = 0;
  for (int i = 0; i < 15; ++i) {
    Wish wish{.ratio = drawn(random, 1, 1.8), .swing = drawn(random, 15, 90)};
    wish.transmission = drawn(random, 0, 50);
    if (i % 2 == 0) wish.links = drawn(random, 3, 6);
    const double step = drawn(random, 0.5, 3), given = drawn(random, 20, 40);
    const std::string file = fmt::format(
        "kind = \"quick-return\"\ntarget = {{time_ratio = {}}}\n"
        "mechanism = {{rocker = {}, swing_deg = {}}}\nbounds = {{length = [1, 60]}}\n"
        "constraints = {{transmission_angle_deg = [{}, {}], link_ratio_max = {}}}\n"
        "raster = {{length = {}}}\n",
        wish.ratio, given, wish.swing, wish.transmission, 180 - wish.transmission,
        std::min(wish.links, 1e9), step);
    const Values all = multiples(step, static_cast<int>(std::ceil(1 / step)),
                                 static_cast<int>(std::floor(60 / step)));
    Values cranks = all;
    std::erase_if(cranks, [&](double crank) { return crank > given; });
    const auto best =
        best_of({cranks, all, {given}, all}, [&](const Values& l) { return rocker(wish, l); });
    with_answer += best ? 1 : 0;
    expect_same(solved(file), best, kDegreeOf, "error_deg", file);
  }
  EXPECT_GE(with_answer, 8);
}

TEST(QuickReturnRaster, OpenRockerIsTheBestAndTheSmallestOfItsShape) {
  std::mt19937 random(2);
  for (int i = 0; i < 6; ++i) {
    const Wish wish{.ratio = drawn(random, 1, 1.6), .swing = drawn(random, 20, 80)};
    const std::string file = fmt::format(
        "kind = \"quick-return\"\ntarget = {{time_ratio = {}}}\n"
        "mechanism = {{swing_deg = {}}}\nbounds = {{length = [2, 40]}}\nraster = {{length = 2, "
        "coupler = [7, 12.5, 18, 33]}}\n",
        wish.ratio, wish.swing);
    const Values all = multiples(2, 1, 20);
    const auto best = best_of({all, {7, 12.5, 18, 33}, all, all},
                              [&](const Values& l) { return rocker(wish, l); });
    ASSERT_TRUE(best);
    expect_same(solved(file), best, kDegreeOf, "error_deg", file);
  }
}

TEST(QuickReturnRaster, SliderIsTheBestOfAllCombinations) {
  std::mt19937 random(3);
  int with_answer = 0;
  for (int i = 0; i < 12; ++i) {
    Wish wish{.ratio = drawn(random, 1, 2.2), .stroke = drawn(random, 20, 40)};
    wish.pressure = drawn(random, 30, 85);
    const std::string file = fmt::format(
        "kind = \"quick-return\"\ntarget = {{time_ratio = {}}}\n"
        "mechanism = {{type = \"slider-crank\", stroke = {}}}\n"
        "bounds = {{coupler = [5, 80], offset = [-20, 50]}}\n"
        "constraints = {{pressure_angle_deg_max = {}}}\nraster = {{length = 1.5}}\n",
        wish.ratio, wish.stroke, wish.pressure);
    const auto best = best_of({multiples(1.5, 1, 53), multiples(1.5, 4, 53), multiples(1.5, 0, 33)},
                              [&](const Values& l) { return slider(wish, l); });
    with_answer += best ? 1 : 0;
    const Result result = solved(file);
    SCOPED_TRACE(file);
    EXPECT_EQ(fact(result, "raster_proven"), 1);
    EXPECT_EQ(result.designs.empty(), !best);
    if (!best || result.designs.empty()) continue;
    EXPECT_NEAR(fact(result, "raster_error_relative"), best->error, 1e-9);
    const Values found = found_lengths(result.designs.front());
    EXPECT_EQ(found[0], best->lengths[0]);
    EXPECT_EQ(found[1], best->lengths[1]);
    EXPECT_EQ(std::abs(found[2]), best->lengths[2]);  // or its image
  }
  EXPECT_GE(with_answer, 8);
}

TEST(QuickReturnRaster, GuideIsTheBestOfAllCombinations) {
  std::mt19937 random(4);
  for (int i = 0; i < 20; ++i) {
    const Wish wish{.ratio = drawn(random, 1.05, 5)};
    const double offset = i % 2 == 0 ? 0 : drawn(random, 0.5, 5);
    const std::string file = fmt::format(
        "kind = \"quick-return\"\ntarget = {{time_ratio = {}}}\n"
        "mechanism = {{type = \"guide-bar\", offset = {}}}\n"
        "bounds = {{frame = [20, 160]}}\nraster = {{length = 2}}\n",
        wish.ratio, offset);
    const auto best = best_of(
        {multiples(2, 1, 80), multiples(2, 10, 80)}, [&](const Values& l) -> std::optional<Tried> {
          if (!(l[0] + offset < l[1])) return std::nullopt;
          const double swing =
              std::asin((l[0] - offset) / l[1]) + std::asin((l[0] + offset) / l[1]);
          return Tried{l, std::abs(swing - wish.theta()), std::asin(offset / (l[1] - l[0])),
                       sum(l)};
        });
    expect_same(solved(file), best, kDegreeOf, "error_deg", file);
  }
}

TEST(QuickReturnRaster, ShaperIsTheBestOfAllCombinations) {
  std::mt19937 random(5);
  for (int i = 0; i < 3; ++i) {
    Wish wish{.ratio = drawn(random, 1.2, 2.5), .stroke = drawn(random, 200, 400)};
    wish.pressure = drawn(random, 8, 40);
    const std::string file = fmt::format(
        "kind = \"quick-return\"\ntarget = {{time_ratio = {}}}\n"
        "mechanism = {{type = \"shaper\", stroke = {}}}\n"
        "bounds = {{crank = [40, 120], frame = [200, 300], bar = [320, 640], rod = [100, 200], "
        "ram_height = [300, 640]}}\n"
        "constraints = {{pressure_angle_deg_max = {}}}\n"
        "raster = {{length = 20, rod = [100, 160]}}\n",
        wish.ratio, wish.stroke, wish.pressure);
    const auto best = best_of({multiples(20, 2, 6),
                               multiples(20, 10, 15),
                               multiples(20, 16, 32),
                               {100, 160},
                               multiples(20, 15, 32)},
                              [&](const Values& l) { return shaper(wish, l); });
    const Result result = solved(file);
    SCOPED_TRACE(file);
    ASSERT_TRUE(best);
    ASSERT_FALSE(result.designs.empty());
    EXPECT_EQ(fact(result, "raster_proven"), 1);
    // The ram's limits lie between the positions of the oracle.
    EXPECT_NEAR(fact(result, "raster_error_relative"), best->error, 1e-4);
    EXPECT_NEAR(result.designs.front().metrics.transmission_acute_min, kRightAngle - best->second,
                1e-5);
  }
}

TEST(QuickReturnRaster, SeveralDesignsAreTheBestThatDifferInShape) {
  const Result result = solved(R"(
    kind = "quick-return"
    target = {time_ratio = 1.3}
    mechanism = {swing_deg = 40}
    bounds = {length = [1, 30]}
    raster = {length = 1}
    solve = {designs = 8}
  )");
  ASSERT_EQ(result.designs.size(), 8U);
  const Wish wish{.ratio = 1.3, .swing = 40};
  double last = 0;
  std::vector<Values> shapes;
  for (const Design& design : result.designs) {
    Values links = found_lengths(design);
    const auto tried = rocker(wish, links);
    ASSERT_TRUE(tried);
    EXPECT_GE(tried->error, last - 1e-9);
    last = tried->error;
    const double crank = links[0];
    for (double& link : links) link /= crank;
    for (const Values& other : shapes) {
      double off = 0;
      for (std::size_t i = 0; i < links.size(); ++i) {
        off = std::max(off, std::abs(links[i] - other[i]));
      }
      EXPECT_GT(off, 1e-9);
    }
    shapes.push_back(links);
  }
}

TEST(QuickReturnRaster, EndsEarlyWithABoundThatHolds) {
  constexpr std::string_view kFile = R"(
    kind = "quick-return"
    target = {{time_ratio = 1.37}}
    mechanism = {{swing_deg = 51}}
    bounds = {{length = [1, 90]}}
    raster = {{length = 1, boxes = {}}}
  )";
  const Result early = solved(fmt::format(kFile, 900));
  const Result whole = solved(fmt::format(kFile, 10'000'000));
  EXPECT_EQ(fact(early, "raster_proven"), 0);
  EXPECT_EQ(fact(whole, "raster_proven"), 1);
  EXPECT_LT(fact(early, "raster_covered"), fact(early, "raster_combinations"));
  EXPECT_LE(fact(early, "raster_bound"), fact(whole, "raster_error_deg") + 1e-9);
}

std::string faults(std::string_view more) {
  const auto problem = parse_task<QuickReturnProblem>(
      "kind = \"quick-return\"\ntarget = {time_ratio = 1.3}\n" + std::string(more));
  std::string all;
  if (!problem) {
    for (const auto& one : problem.error()) all += one.message + "\n";
  }
  return all;
}

TEST(QuickReturnRaster, RefusesWhatItCannotSearch) {
  const auto expect = [](std::string_view file, std::string_view words) {
    EXPECT_NE(faults(file).find(words), std::string::npos) << faults(file);
  };
  expect(
      "mechanism = {swing_deg = 30, rocker = 20, crank_pivot_line = [1, 1, 0]}\n"
      "bounds = {length = [1, 50]}\nraster = {length = 1}\n",
      "crank_pivot_line");
  expect("mechanism = {swing_deg = 30, rocker = 20}\nraster = {length = 1}\n", "bounds.coupler");
  expect(
      "mechanism = {swing_deg = 30, rocker = 20}\nbounds = {length = [1, 50]}\n"
      "raster = {crank = 1}\n",
      "leaves coupler free");
  expect(
      "mechanism = {swing_deg = 30, rocker = 20, crank = 5, coupler = 20, frame = 25}\n"
      "raster = {length = 1}\n",
      "puts no length");
  expect(
      "mechanism = {swing_deg = 30, rocker = 20}\nbounds = {length = [1, 50], frame = [11, 12]}\n"
      "raster = {length = 1, frame = 20}\n",
      "bounds.frame");
  expect("mechanism = {type = \"guide-bar\", frame = 20}\nraster = {rocker = 1}\n", "\"crank\"");
  expect("mechanism = {type = \"slider-crank\", stroke = 20}\nraster = {length = \"free\"}\n",
         "at least one of");
  expect("mechanism = {type = \"slider-crank\", stroke = 20}\nbounds = {coupler = [1, 9]}\n",
         "unknown key \"coupler\" in [bounds]");
  EXPECT_EQ(faults("mechanism = {type = \"guide-bar\", frame = 20}\nraster = {crank = 1}\n"), "");
  // Both stay faults without a raster.
  expect("mechanism = {type = \"guide-bar\"}\n", "frame");
  expect("mechanism = {swing_deg = 30}\n", "rocker");
}

}  // namespace
}  // namespace cognate::problems::quick_return_raster_test
