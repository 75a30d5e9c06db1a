/// Straight lines on a raster against all combinations, evaluated by code of the test's own: the
/// textbook's triangle for closure, segments from a scan of starts whose strips are turned until
/// they are narrowest.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems::straight_line_raster_test {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr double kDegree = kTurn / 360;

/// Links of a crank-rocker and the coupler point on B–C's line, so that one assembly is the mirror
/// image of the other.
struct Links {
  double crank, coupler, rocker, frame, point;

  bool is_crank_rocker() const {
    const double rest = coupler + rocker + frame;
    const double longest = std::max({coupler, rocker, frame});
    return crank < std::min({coupler, rocker, frame}) && crank + longest < rest - longest;
  }
  double size() const {
    return std::max({coupler, rocker, frame, std::abs(point), std::abs(point - coupler)});
  }
};

/// The coupler point by the law of cosines in the triangle B, C, D.
Vec2d place(const Links& links, double angle) {
  const double bx = links.crank * std::cos(angle), by = links.crank * std::sin(angle);
  const double way = std::hypot(links.frame - bx, by);
  const double cosine = (links.coupler * links.coupler + way * way - links.rocker * links.rocker) /
                        (2 * links.coupler * way);
  const double to = std::atan2(-by, links.frame - bx) + std::acos(cosine);
  return {bx + links.point * std::cos(to), by + links.point * std::sin(to)};
}

double least(const std::function<double(double)>& value, double low, double high) {
  for (int i = 0; i < 32; ++i) {
    const double one = low + 0.381966 * (high - low), two = high - 0.381966 * (high - low);
    (value(one) < value(two) ? high : low) = value(one) < value(two) ? two : one;
  }
  return value(0.5 * (low + high));
}

/// Half the width of the narrowest strip about the points from `from` to `to`.
double half_width(const Links& links, double from, double to, int count) {
  std::vector<Vec2d> points;
  for (int k = 0; k <= count; ++k) points.push_back(place(links, from + (to - from) * k / count));
  const Vec2d ends = points.back() - points.front();
  const auto width = [&](double direction) {
    double low = kNothing, high = -kNothing;
    for (const Vec2d& p : points) {
      const double height = std::cos(direction) * p.y - std::sin(direction) * p.x;
      low = std::min(low, height), high = std::max(high, height);
    }
    return 0.5 * (high - low);
  };
  const double along = std::atan2(ends.y, ends.x);
  return least(width, along - 0.2, along + 0.2);
}

double chord(const Links& links, double from, double to) {
  const Vec2d ends = place(links, to) - place(links, from);
  return std::hypot(ends.x, ends.y);
}

/// Where the chord from `from` reaches `length` within a degree of `near`.
double end_of(const Links& links, double from, double near, double length) {
  double low = near - kDegree, high = near + kDegree;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (chord(links, from, middle) < length ? low : high) = middle;
  }
  return low;
}

/// The least deviation over a segment of the length.
double least_deviation(const Links& links, double length) {
  double best = kNothing, start = 0, end = 0;
  for (int i = 0; i < 360; ++i) {
    for (int cells = 3; cells < 359; ++cells) {
      const double from = i * kDegree, to = from + cells * kDegree;
      if (chord(links, from, to) < length || chord(links, from, to - kDegree) >= length) continue;
      const double width = half_width(links, from, to, cells);
      if (width < best) best = width, start = from, end = to;
    }
  }
  if (best == kNothing) return best;
  return least(
      [&](double from) {
        const double to = end_of(links, from, end + (from - start) * 0.5, length);
        const double off = std::abs(chord(links, from, to) - length);
        return off < 1e-6 * length ? half_width(links, from, to, 240) : kNothing;
      },
      start - kDegree, start + kDegree);
}

/// The longest chord of a segment within the deviation.
double greatest_length(const Links& links, double deviation) {
  const auto length_from = [&](double from) {
    double low = from, high = from + 0.9 * kTurn;
    for (int i = 0; i < 22; ++i) {
      const double middle = 0.5 * (low + high);
      (half_width(links, from, middle, 90) <= deviation ? low : high) = middle;
    }
    return chord(links, from, low);
  };
  double best = 0;
  int start = 0;
  for (int i = 0; i < 72; ++i) {
    const double length = length_from(5 * i * kDegree);
    if (length > best) best = length, start = i;
  }
  for (int i = -20; i <= 20; ++i) {
    best = std::max(best, length_from((5 * start + 0.25 * i) * kDegree));
  }
  return best;
}

constexpr double kPoint = 9;
const std::vector<double> kCranks{1, 1.75, 2.4}, kCouplers{3.5, 4, 4.5, 5}, kOthers{3.5, 4.25, 5};

/// Of all crank-rockers of the lists.
void for_each_crank_rocker(const std::function<void(const Links&)>& body) {
  for (const double crank : kCranks) {
    for (const double coupler : kCouplers) {
      for (const double rocker : kOthers) {
        for (const double frame : kOthers) {
          const Links links{crank, coupler, rocker, frame, kPoint};
          if (links.is_crank_rocker()) body(links);
        }
      }
    }
  }
}

std::string file(const std::string& target) {
  return fmt::format(
      "kind = \"straight-line\"\n[target]\n{}\n[mechanism]\ncoupler_point = [{}, 0]\n"
      "[bounds]\nlength = [0.5, 6]\n"
      "[constraints]\nclass = \"crank-rocker\"\nsize_over_length_max = 3\n"
      "[raster]\ncrank = [{}]\ncoupler = 0.5\nrocker = [{}]\nframe = [{}]\n"
      "[solve]\nstarts = 40\ndesigns = 1\n",
      target, kPoint, fmt::join(kCranks, ", "), fmt::join(kOthers, ", "), fmt::join(kOthers, ", "));
}

StraightLineProblem problem_of(std::string text) {
  // The coupler from its list, by a step within bounds of its own.
  const auto at = text.find("length = [0.5, 6]");
  if (at != std::string::npos) text.insert(at, "coupler = [3.5, 5]\n");
  const auto problem = parse_task(text);
  if (problem) return std::get<StraightLineProblem>(*problem);
  for (const Fault& fault : problem.error()) ADD_FAILURE() << fault.line << ": " << fault.message;
  return {};
}

double fact(const Result& result, const char* key) {
  return find_quantity(result.quantities, QuantityKey<double>{key}).value_or(-1);
}

Links links_of(const Result& result) {
  const FourBar& found = four_bar(result.designs.front());
  return {found.crank, found.coupler, found.rocker, norm(found.pivot_d - found.pivot_a), kPoint};
}

void expect_on_raster(const Result& result) {
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_TRUE(find_quantity(result.quantities, QuantityKey<bool>{"raster_proven"}).value_or(false));
  EXPECT_EQ(fact(result, "raster_combinations"), 108);
  EXPECT_TRUE(all_satisfied(result.designs.front().constraints));
  const Links links = links_of(result);
  EXPECT_EQ(std::ranges::count(kCranks, links.crank), 1);
  EXPECT_EQ(std::ranges::count(kCouplers, links.coupler), 1);
  for (const double other : {links.rocker, links.frame}) {
    EXPECT_EQ(std::ranges::count(kOthers, other), 1);
  }
}

TEST(StraightLineRaster, HasTheLeastDeviationOfAllCombinations) {
  constexpr double kLength = 4;
  double best = kNothing;
  for_each_crank_rocker([&](const Links& links) {
    if (links.size() <= 3 * kLength) best = std::min(best, least_deviation(links, kLength));
  });
  const Result result = solve(problem_of(file("length = 4")), {.threads = 1});
  expect_on_raster(result);
  EXPECT_NEAR(fact(result, "raster_error"), best, 2e-3 * best);
  EXPECT_NEAR(least_deviation(links_of(result), kLength), best, 2e-3 * best);
  EXPECT_GT(fact(result, "rounded_error"), fact(result, "raster_error") * (1 - 1e-9));
}

TEST(StraightLineRaster, ClaimsNoProofWhereADimensionIsFree) {
  constexpr double kLength = 4;
  double best = kNothing;
  for_each_crank_rocker([&](const Links& links) {
    if (links.size() <= 3 * kLength) best = std::min(best, least_deviation(links, kLength));
  });
  std::string text = file("length = 4");
  const auto at = text.find("rocker = [");
  text.erase(at, text.find('\n', at) + 1 - at);
  const Result result = solve(problem_of(text), {.threads = 1});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_FALSE(find_quantity(result.quantities, QuantityKey<bool>{"raster_proven"}).value_or(true));
  EXPECT_EQ(fact(result, "raster_combinations"), 36);
  EXPECT_LT(fact(result, "raster_error"), best);
}

TEST(StraightLineRaster, HasTheGreatestLengthOfAllCombinations) {
  constexpr double kDeviation = 0.02;
  double best = 0;
  for_each_crank_rocker([&](const Links& links) {
    const double length = greatest_length(links, kDeviation);
    if (links.size() <= 3 * length) best = std::max(best, length);
  });
  const Result result = solve(problem_of(file("deviation = 0.02")), {.threads = 1});
  expect_on_raster(result);
  EXPECT_NEAR(fact(result, "raster_length"), best, 2e-3 * best);
}

TEST(StraightLineRaster, HasTheLeastSizeOfAllCombinations) {
  constexpr double kLength = 4, kDeviation = 0.02;
  double best = kNothing;
  for_each_crank_rocker([&](const Links& links) {
    if (links.size() >= std::min(best, 3 * kLength)) return;
    if (least_deviation(links, kLength) <= kDeviation) best = links.size();
  });
  ASSERT_LT(best, kNothing);
  const Result result = solve(problem_of(file("length = 4\ndeviation = 0.02")), {.threads = 1});
  expect_on_raster(result);
  EXPECT_NEAR(fact(result, "raster_size"), best / kLength, 1e-9);
  EXPECT_LE(least_deviation(links_of(result), kLength), kDeviation * (1 + 1e-6));
}

TEST(StraightLineRaster, RefusesWhatItCannotDo) {
  const auto fault = [](const std::string& text) {
    const auto read = parse_task("kind = \"straight-line\"\n" + text);
    return read ? std::string() : read.error().front().message;
  };
  const auto refuses = [&](const std::string& text, const char* why) {
    EXPECT_NE(fault(text).find(why), std::string::npos) << fault(text);
  };
  const std::string raster = "[raster]\nlength = 1\n", length = "[target]\nlength = 10\n";
  EXPECT_EQ(fault(length + raster), "");
  refuses(raster, "a front is searched");
  refuses("[target]\ndeviation_relative = 0.001\n" + raster, "without end");
  refuses(length + "[raster]\ncrank = [30]\n", "no value of crank");
  refuses(length + "[raster]\ncrank = 1\n[mechanism]\ncrank = 2\n", "no dimension");
  refuses(length + "direction_deg = 0\n" + raster + "[mechanism]\nframe_angle_deg = 0\n",
          "directions of line and frame");
  refuses(length + raster + "offset = 1\n", "offset");
}

}  // namespace
}  // namespace cognate::problems::straight_line_raster_test
