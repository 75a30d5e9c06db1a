/// Bounds of function generators over boxes against single generators in them, whose angles come
/// from intersecting circles in long double and whose best output start from the mean direction.
#include "synthesis/bounds/function_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/function/dead_centre.hpp"

namespace cognate::synthesis::function_bound_test {
namespace {

using Real = long double;
using Point = std::array<double, kBoxSides>;

int repeats(int usual) {
  const char* asked = std::getenv("COGNATE_TEST_SEEDS");
  return asked ? std::max(1, std::min(usual, 40 * std::atoi(asked))) : usual;
}

class Random {
 public:
  explicit Random(unsigned seed) : source_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(source_);
  }
  bool chance(double share) { return uniform(0, 1) < share; }

  ProportionBox box(bool with_phase) {
    ProportionBox box;
    const double kind = uniform(0, 3);
    box.proportions = kind < 1   ? Proportions::crank_shortest
                      : kind < 2 ? Proportions::frame_shortest
                                 : Proportions::any;
    const bool any = box.proportions == Proportions::any;
    const double low[4] = {box.proportions == Proportions::crank_shortest ? 0.5 : 0.05,
                           any ? -0.9 : 0.0, 0.02, 0.0};
    const double high[4] = {box.proportions == Proportions::frame_shortest ? 0.5 : 0.95,
                            any ? 0.9 : kPi, any ? 0.8 : kRightAngle - 0.01, kTurn};
    const double scale = std::pow(10.0, uniform(-6, 0));
    for (int i = 0; i < kBoxSides; ++i) {
      const double width = scale * uniform(0, 1) * (high[i] - low[i]);
      double from = uniform(low[i], high[i] - width);
      if (chance(0.1)) from = low[i];
      if (chance(0.1)) from = high[i] - width;
      box.side[i] = {from, std::min(high[i], from + width)};
    }
    if (!with_phase) box.side[3] = Interval(0);
    box.assembly = chance(0.5) ? 1 : -1;
    return box;
  }

  Point in(const ProportionBox& box) {
    Point point{};
    for (int i = 0; i < kBoxSides; ++i) {
      const Interval& side = box.side[i];
      point[i] = chance(0.2) ? side.low : chance(0.2) ? side.high : uniform(side.low, side.high);
    }
    return point;
  }

 private:
  std::mt19937_64 source_;
};

struct Links {
  Real crank, coupler, rocker, frame;
};
Links links_at(const ProportionBox& box, const Point& at) {
  const Real k = at[0];
  Real difference = at[1], inverse = Real(at[2]) / (1 - Real(at[2]));
  if (box.proportions != Proportions::any) {
    difference = std::abs(2 * k - 1) * std::cos(Real(at[1]));
    inverse = std::cos(Real(at[2]));
  }
  return {1 - k, (1 / inverse + difference) / 2, (1 / inverse - difference) / 2, k};
}

std::optional<Real> output_at(const Links& links, int assembly, Real angle) {
  const Real bx = links.crank * std::cos(angle), by = links.crank * std::sin(angle);
  const Real dx = links.frame - bx, dy = -by, square = dx * dx + dy * dy;
  if (square < 1e-8L || links.rocker < 1e-6L || links.coupler < 1e-6L) return std::nullopt;
  const Real along =
      (square + links.coupler * links.coupler - links.rocker * links.rocker) / (2 * square);
  Real across = links.coupler * links.coupler / square - along * along;
  if (across < -1e-15L) return std::nullopt;
  across = assembly * std::sqrt(std::max(across, Real(0)));
  return std::atan2(by + along * dy + across * dx, bx + along * dx - across * dy - links.frame);
}

Real wrapped(Real angle) {
  return std::remainder(angle, 2 * std::numbers::pi_v<Real>);
}

/// The least sum of squares over the output's start: between two starts where an error jumps by a
/// whole turn the best is the mean, so all ways to cut the circle are tried.
double best_squares(const std::vector<Real>& angles) {
  double best = kInfinity;
  for (const Real cut : angles) {
    Real mean = 0;
    for (const Real angle : angles) mean += wrapped(angle - cut) / Real(angles.size());
    Real sum = 0;
    for (const Real angle : angles) sum += std::pow(wrapped(angle - cut - mean), 2);
    best = std::min(best, double(sum));
  }
  return best;
}

/// Input and output angle at the limit position; the output's is empty where it is free.
struct Start {
  Real input = 0;
  std::optional<Real> output;
};
std::optional<Start> start_of(const DesiredFunction& function, const ProportionBox& box,
                              const Point& at) {
  if (!function.start) {
    return Start{
        at[3], function.output_start ? std::optional<Real>(*function.output_start) : std::nullopt};
  }
  using problems::FunctionStart;
  const Links links = links_at(box, at);
  const auto dead = problems::dead_centre(
      {double(links.crank), double(links.coupler), double(links.rocker), double(links.frame)},
      box.assembly > 0 ? Assembly::open : Assembly::crossed,
      *function.start == LimitOfOutput::outer ? FunctionStart::outer_dead_centre
                                              : FunctionStart::inner_dead_centre);
  if (!dead) return std::nullopt;
  return Start{dead->crank_angle, dead->rocker_angle};
}

std::optional<double> error_at(const DesiredFunction& function, const ProportionBox& box,
                               const Point& at) {
  const Links links = links_at(box, at);
  const auto start = start_of(function, box, at);
  if (!start) return std::nullopt;
  std::vector<Real> angles;
  for (std::size_t j = 0; j < function.input.size(); ++j) {
    const auto output = output_at(links, box.assembly, start->input + function.input[j]);
    if (!output) return std::nullopt;
    angles.push_back(*output - function.output[j]);
  }
  if (!start->output) return best_squares(angles);
  Real sum = 0;
  for (const Real angle : angles) sum += std::pow(wrapped(angle - *start->output), 2);
  return double(sum);
}

ProportionLimits no_limits() {
  ProportionLimits limits;
  limits.greatest_ratio = kInfinity;
  limits.transmission_max = kPi;
  return limits;
}

/// A function that a linkage of the box generates, more or less.
std::optional<DesiredFunction> function_near(Random& random, const ProportionBox& box,
                                             std::optional<LimitOfOutput> start) {
  DesiredFunction function;
  function.start = start;
  function.lengths.greatest.fill(kInfinity);
  const Point at = random.in(box);
  const Links links = links_at(box, at);
  const auto begin = start_of(function, box, at);
  if (!begin) return std::nullopt;
  const double blur = std::pow(10.0, random.uniform(-6, -0.3));
  const int count = 3 + int(random.uniform(0, 8));
  for (int j = 0; j < count; ++j) {
    function.input.push_back(random.uniform(0, 2));
    const auto output = output_at(links, box.assembly, begin->input + function.input[j]);
    if (!output) return std::nullopt;
    const Real from = begin->output.value_or(0);
    function.output.push_back(double(*output - from) + blur * random.uniform(-1, 1));
  }
  if (!start && random.chance(0.3)) function.output_start = random.uniform(-1, 1) * blur;
  return function;
}

void hold_bounds(unsigned seed, std::optional<LimitOfOutput> start, int usual) {
  Random random(seed);
  int checked = 0, tight = 0;
  for (int i = 0; i < repeats(usual); ++i) {
    const ProportionBox box = random.box(!start);
    const auto function = function_near(random, box, start);
    if (!function) continue;
    const auto first = error_at(*function, box, random.in(box));
    if (!first) continue;
    const FunctionBound bound(*function, no_limits());
    const double target = *first * (random.chance(0.5) ? 1 + 1e-9 : random.uniform(0.3, 3));
    const BoxBound found = bound(box, target);
    for (int trial = 0; trial < 6; ++trial) {
      const auto error = trial == 0 ? first : error_at(*function, box, random.in(box));
      if (!error) continue;
      ASSERT_LE(found.least, *error * (1 + 1e-9) + 1e-13) << i;
      ++checked;
      if (found.least > 0.5 * std::min(*error, target)) ++tight;
    }
  }
  EXPECT_GT(checked, repeats(usual) / 2);
  EXPECT_GT(tight, checked / 10);
}

TEST(FunctionBound, NoGeneratorOfABoxIsBetterThanItsBound) {
  hold_bounds(1, std::nullopt, 12000);
}

TEST(FunctionBound, FromTheOuterLimit) {
  hold_bounds(2, LimitOfOutput::outer, 8000);
}

TEST(FunctionBound, FromTheInnerLimit) {
  hold_bounds(3, LimitOfOutput::inner, 8000);
}

TEST(FunctionBound, LimitAnglesHoldThoseOfEachLinkage) {
  Random random(4);
  int checked = 0, narrow = 0;
  for (int i = 0; i < repeats(8000); ++i) {
    const ProportionBox box = random.box(false);
    const bool outer = random.chance(0.5);
    const auto range = limit_angle(box, outer ? LimitOfOutput::outer : LimitOfOutput::inner);
    const Point at = random.in(box);
    const Links links = links_at(box, at);
    // Where B and C lie on one line with A: the crank along A→C or against it.
    const Real reach = outer ? links.crank + links.coupler : links.coupler - links.crank;
    if (std::abs(reach) < 1e-4L) continue;
    const Real cosine = (reach * reach + links.frame * links.frame - links.rocker * links.rocker) /
                        (2 * reach * links.frame);
    if (std::abs(cosine) > 1) continue;
    ASSERT_TRUE(range.has_value()) << i;
    // Of the two mirror images that in which the assembly changes no side.
    const Real side = (outer ? 1 : -1) * box.assembly;
    const Real angle = side * std::acos((outer ? 1 : -1) * cosine);
    Real expected = range->middle;
    for (int s = 0; s < 3; ++s) {
      const double half = box.side[s].radius();
      if (half > 1e-299) expected += range->slope[s] * (at[s] - box.side[s].middle()) / half;
    }
    EXPECT_LE(std::abs(wrapped(angle - expected)), range->radius + 1e-10) << i;
    EXPECT_LE(std::abs(wrapped(angle - range->middle)), range->reach + 1e-10) << i;
    ++checked;
    if (range->radius < 0.1) ++narrow;
  }
  EXPECT_GT(narrow, checked / 4);
}

}  // namespace
}  // namespace cognate::synthesis::function_bound_test
