// Strips against samples, collisions against dense positions, stacks against all assignments.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "analysis/layers/collisions.hpp"
#include "analysis/layers/plates.hpp"
#include "analysis/layers/stacking.hpp"
#include "analysis/layers/strip.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/hull_distance.hpp"

namespace cognate::layers_test {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Strip any_strip(std::mt19937& random) {
  return {uniform(random, -3, 3), uniform(random, -1, 1), uniform(random, 0, 0.5)};
}

// A value that a strip allows at t.
double value(const Strip& strip, double t, double share) {
  return strip.middle + t * strip.slope + share * strip.radius;
}

void expect_holds(const Strip& strip, double t, double x) {
  if (!std::isfinite(strip.radius)) return;
  EXPECT_LE(std::abs(x - strip.middle - t * strip.slope), strip.radius);
}

TEST(Strips, HoldWhatTheirOperandsCanBe) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Strip a = any_strip(random), b = any_strip(random);
    for (int k = 0; k < 20; ++k) {
      const double t = k < 2 ? 2 * k - 1 : uniform(random, -1, 1);
      const double x = value(a, t, k % 3 - 1), y = value(b, t, uniform(random, -1, 1));
      expect_holds(a + b, t, x + y);
      expect_holds(a - b, t, x - y);
      expect_holds(a * b, t, x * y);
      expect_holds(a / b, t, x / y);
      if (x >= 0) expect_holds(sqrt(a), t, std::sqrt(x));
    }
  }
}

TEST(Strips, SayWhatTheyDoNotKnow) {
  EXPECT_FALSE(std::isfinite((Strip(1) / Strip(0, 1, 0)).radius));
  EXPECT_FALSE(std::isfinite((Strip(0) * (Strip(1) / Strip(0, 1, 0))).radius));
  EXPECT_FALSE(std::isfinite(sqrt(Strip(1) / Strip(0, 1, 0)).radius));
  EXPECT_EQ(sqrt(Strip(-1, 0.5, 0)).magnitude(), 0);
  // A quarter of the width is a sixteenth of the radius.
  const auto radius = [](double half) { return sqrt(Strip(2, half, 0)).radius; };
  EXPECT_NEAR(radius(0.4) / radius(0.1), 16, 1);
}

std::vector<Vec2d> any_hull(std::mt19937& random, int corners) {
  const Vec2d at{uniform(random, -3, 3), uniform(random, -3, 3)};
  const double turn = uniform(random, 0, kTurn);
  std::vector<Vec2d> hull;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + kTurn * i / corners;
    hull.push_back(at + 1.5 * Vec2d{std::cos(angle), std::sin(angle)});
  }
  return hull;
}

// The least distance of points on their rims, and 0 where a point of one lies within the other.
double sampled_distance(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
  constexpr int kSteps = 60;
  const auto rim = [&](const std::vector<Vec2d>& hull) {
    std::vector<Vec2d> points;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      for (int k = 0; k < kSteps; ++k) {
        points.push_back(hull[i] + (1.0 * k / kSteps) * (hull[(i + 1) % hull.size()] - hull[i]));
      }
    }
    return points;
  };
  double least = kInfinity;
  for (const Vec2d& p : rim(a)) {
    for (const Vec2d& q : rim(b)) least = std::min(least, norm(q - p));
  }
  return least;
}

TEST(HullGap, IsTheShortestOfTheRims) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const auto a = any_hull(random, 1 + i % 4), b = any_hull(random, 1 + i / 4 % 3);
    const Vec2d gap = hull_gap(a, b);
    const double sampled = sampled_distance(a, b);
    EXPECT_LE(norm(gap), sampled + 1e-12);
    if (norm(gap) == 0) continue;
    EXPECT_NEAR(norm(gap), sampled, 0.05);
    // It is a gap: moved by it, one touches the other.
    std::vector<Vec2d> moved = a;
    for (Vec2d& corner : moved) corner = corner + gap;
    EXPECT_NEAR(hull_distance(moved, b), 0, 1e-12);
    for (Vec2d& corner : moved) corner = corner - 0.01 * gap;
    EXPECT_NEAR(hull_distance(moved, b), 0.01 * norm(gap), 1e-12);
  }
}

// A crank-rocker with a bar on the crank that turns past a disc of the frame.
Mechanism<double> crank_rocker() {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.emplace_back(Rrr<double>{{1, {1, 0}}, {0, {4, 0}}, 3, 3, Assembly::open});
  return mechanism;
}

PairPassage passage(const Plate& a, const Plate& b, double clearance, double from, double to) {
  const auto mechanism = crank_rocker();
  const auto motion = follow(mechanism, from, to);
  const PlatePair pair{&a, &b};
  return find_collisions(mechanism, motion, {&pair, 1}, clearance).pairs.front();
}

TEST(Collisions, AreFoundWhereTheyBegin) {
  // The tip at distance 1 comes to the disc at (0, 2) as it turns: |tip − disc| = 1.5.
  const Plate tip{1, {{1, 0}}, 0.1}, disc{0, {{0, 2}}, 0.2};
  const auto found = passage(tip, disc, 1.2, 0, kTurn);
  EXPECT_EQ(found.passage, Passage::collides);
  EXPECT_NEAR(found.drive, std::asin((5 - 1.5 * 1.5) / 4), 1e-7);
  const auto back = passage(tip, disc, 1.2, kTurn, 0);
  EXPECT_EQ(back.passage, Passage::collides);
  EXPECT_NEAR(back.drive, kPi - std::asin((5 - 1.5 * 1.5) / 4), 1e-7);
}

TEST(Collisions, AreExcludedUpToTheResolution) {
  // They come as near as 1 at 90 degrees.
  const Plate tip{1, {{1, 0}}, 0.1}, disc{0, {{0, 2}}, 0.2};
  EXPECT_EQ(passage(tip, disc, 0.7 - 1e-7, 0, kTurn).passage, Passage::free);
  EXPECT_EQ(passage(tip, disc, 0.7 + 1e-7, 0, kTurn).passage, Passage::collides);
  EXPECT_EQ(passage(tip, disc, 0.7, 0, kTurn).passage, Passage::unresolved);
  // What keeps its distance without moving against the other.
  const Plate inner{0, {{0, 0}}, 0.3};
  EXPECT_EQ(passage(tip, inner, 0.6 - 1e-6, 0, kTurn).passage, Passage::free);
  EXPECT_EQ(passage(tip, inner, 0.6 + 1e-6, 0, kTurn).passage, Passage::collides);
}

TEST(Collisions, EndWhenTold) {
  const auto mechanism = crank_rocker();
  const Plate tip{1, {{1, 0}}, 0.1}, disc{0, {{0, 2}}, 0.2};
  const PlatePair pair{&tip, &disc};
  const auto motion = follow(mechanism, 0, kTurn);
  EXPECT_FALSE(find_collisions(mechanism, motion, {&pair, 1}, 0, [] { return true; }).complete);
}

TEST(Plates, OfAFourBarAreItsBarsAndPins) {
  const auto mechanism = crank_rocker();
  const Attached<double> point{2, {1, 1}};
  const auto made =
      plates(mechanism, follow(mechanism, 0, kTurn), {&point, 1}, {{0, 0.2, 0.4, 0.2}, 0.1, 0});
  ASSERT_EQ(made.links.size(), 3u);
  EXPECT_EQ(made.links[0].corners.size(), 2u);
  EXPECT_EQ(made.links[1].corners.size(), 3u);
  EXPECT_EQ(made.links[1].radius, 0.2);
  ASSERT_EQ(made.pins.size(), 4u);
  EXPECT_TRUE(made.pins[0].on_base);
  EXPECT_EQ(made.pins[0].links, std::vector<int>{0});
  EXPECT_EQ(made.pins[1].links, (std::vector<int>{0, 1}));
}

// A slider-crank's block rests in the base: its pin rises to the coupler.
TEST(Plates, OfABlockAreAPin) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.emplace_back(Rrp<double>{{1, {1, 0}}, 3, {0, {0, 0}, {1, 0}, 0}});
  const auto made = plates(mechanism, follow(mechanism, 0, kTurn), {}, {{0, 1, 1, 1}, 0.5, 0});
  EXPECT_EQ(made.links.size(), 2u);
  ASSERT_EQ(made.pins.size(), 3u);
  EXPECT_TRUE(made.pins[2].on_base);
  EXPECT_EQ(made.pins[2].links, std::vector<int>{1});
}

// The way of the block on the bar of a Whitworth mechanism: from |crank − frame| to their sum.
TEST(Plates, OfAGuideBarReachAsFarAsItsBlock) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.emplace_back(Rpr<double>{{1, {1, 0}}, {0, {0, -2.5}}, 0});
  const auto made = plates(mechanism, follow(mechanism, 0, kTurn), {}, {{0, 1, 1, 1}, 0.5, 0});
  ASSERT_EQ(made.links.size(), 2u);
  double reach = 0;
  for (const Vec2d& corner : made.links[1].corners) reach = std::max(reach, corner.x);
  EXPECT_NEAR(reach, 3.5, 1e-8);
  EXPECT_GE(reach, 3.5);
}

// Whether every layer holds what it may, straight from the rules.
bool is_allowed(const StackProblem& problem, const std::vector<int>& layers) {
  const auto in = [](LinkSet set, std::size_t i) { return (set >> i & 1) != 0; };
  const std::size_t links = layers.size();
  for (std::size_t a = 0; a < links; ++a) {
    for (std::size_t b = 0; b < links; ++b) {
      if (in(problem.apart[a], b) && layers[a] == layers[b]) return false;
    }
  }
  std::vector<std::pair<int, int>> reach;
  for (const StackPin& pin : problem.pins) {
    int low = pin.on_base ? 0 : 1000, high = 0;
    for (std::size_t i = 0; i < links; ++i) {
      if (!in(pin.links, i)) continue;
      low = std::min(low, layers[i]);
      high = std::max(high, layers[i]);
    }
    for (std::size_t i = 0; i < links; ++i) {
      const bool passes = low < layers[i] && layers[i] < high && !in(pin.links, i);
      if (passes && in(pin.stops_at, i)) return false;
    }
    reach.emplace_back(low, high);
  }
  for (std::size_t p = 0; p < reach.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      const bool hit = (problem.pins[p].pins_hit >> q & 1) != 0;
      const int low = std::max(reach[p].first, reach[q].first);
      if (hit && std::min(reach[p].second, reach[q].second) - low >= 2) return false;
    }
  }
  return true;
}

std::optional<int> fewest_by_trying(const StackProblem& problem) {
  const std::size_t links = problem.apart.size();
  for (int count = 1; count <= static_cast<int>(links); ++count) {
    std::vector<int> layers(links, 1);
    for (;;) {
      if (is_allowed(problem, layers)) return count;
      std::size_t digit = 0;
      while (digit < links && layers[digit] == count) layers[digit++] = 1;
      if (digit == links) break;
      ++layers[digit];
    }
  }
  return std::nullopt;
}

StackProblem any_stack(std::mt19937& random, std::size_t links, std::size_t pins) {
  StackProblem problem;
  problem.apart.assign(links, 0);
  const auto draw = [&](double share) { return uniform(random, 0, 1) < share; };
  for (std::size_t a = 0; a < links; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!draw(0.4)) continue;
      problem.apart[a] |= LinkSet{1} << b;
      problem.apart[b] |= LinkSet{1} << a;
    }
  }
  for (std::size_t p = 0; p < pins; ++p) {
    StackPin pin{.on_base = draw(0.4)};
    for (std::size_t i = 0; i < links; ++i) {
      if (draw(0.35)) pin.links |= LinkSet{1} << i;
    }
    for (std::size_t i = 0; i < links; ++i) {
      if (draw(0.35) && (pin.links >> i & 1) == 0) pin.stops_at |= LinkSet{1} << i;
    }
    for (std::size_t a = 0; a < links; ++a) {
      if ((pin.links >> a & 1) != 0) problem.apart[a] |= pin.links & ~(LinkSet{1} << a);
    }
    problem.pins.push_back(pin);
    for (std::size_t q = 0; q < p; ++q) {
      if (!draw(0.1)) continue;
      problem.pins[p].pins_hit |= std::uint64_t{1} << q;
      problem.pins[q].pins_hit |= std::uint64_t{1} << p;
    }
  }
  return problem;
}

TEST(Stacking, FindsTheFewestOfAllAssignments) {
  std::mt19937 random(11);
  int without = 0;
  for (int i = 0; i < 400; ++i) {
    const StackProblem problem =
        any_stack(random, 1 + static_cast<std::size_t>(i % 5), static_cast<std::size_t>(i % 7));
    const Stack stack = fewest_layers(problem);
    const auto fewest = fewest_by_trying(problem);
    EXPECT_EQ(fewest.has_value(), !stack.layers.empty()) << i;
    if (fewest) {
      EXPECT_EQ(stack.count, *fewest) << i;
      EXPECT_TRUE(is_allowed(problem, stack.layers)) << i;
      EXPECT_EQ(*std::ranges::max_element(stack.layers), stack.count);
      continue;
    }
    ++without;
    // The links that block each other do so alone, and no longer without any one of them.
    const auto part = [&](LinkSet kept) {
      StackProblem some = problem;
      for (std::size_t a = 0; a < some.apart.size(); ++a) {
        some.apart[a] &= (kept >> a & 1) != 0 ? kept : 0;
      }
      for (StackPin& pin : some.pins) {
        pin.links &= kept;
        pin.stops_at &= kept;
        if (std::popcount(pin.links) + (pin.on_base ? 1 : 0) < 2) pin = StackPin{};
      }
      return fewest_by_trying(some).has_value();
    };
    EXPECT_FALSE(part(stack.blocked)) << i;
    for (LinkSet rest = stack.blocked; rest != 0; rest &= rest - 1) {
      EXPECT_TRUE(part(stack.blocked & ~(rest & -rest))) << i;
    }
  }
  EXPECT_GT(without, 10);
}

// The greatest stack is as quick as any.
TEST(Stacking, TakesFourteenLinks) {
  StackProblem problem;
  problem.apart.assign(kMostStackedLinks, (LinkSet{1} << kMostStackedLinks) - 1);
  for (std::size_t i = 0; i < problem.apart.size(); ++i) problem.apart[i] &= ~(LinkSet{1} << i);
  EXPECT_EQ(fewest_layers(problem).count, kMostStackedLinks);
}

}  // namespace
}  // namespace cognate::layers_test
