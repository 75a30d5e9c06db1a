/// Cognates held against the curve they share, point by point, and against each other.
#include "analysis/linkage/cognates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cognates_test {
namespace {

constexpr double pi = kPi;

double distance(const Vec2d& a, const Vec2d& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double largest_difference(const FourBar& a, const FourBar& b) {
  return std::max({distance(a.pivot_a, b.pivot_a), distance(a.pivot_d, b.pivot_d),
                   distance(*a.coupler_point, *b.coupler_point), std::abs(a.crank - b.crank),
                   std::abs(a.coupler - b.coupler), std::abs(a.rocker - b.rocker)});
}

FourBar random_linkage(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.2, 1.0), place(-1.0, 1.0);
  return {{place(random), place(random)},
          {place(random), place(random)},
          length(random),
          length(random),
          length(random),
          random() % 2 == 0 ? Assembly::open : Assembly::crossed,
          Vec2d{place(random), place(random)}};
}

std::string printed(const FourBar& l) {
  std::ostringstream out;
  out << std::hexfloat << "A " << l.pivot_a.x << ", " << l.pivot_a.y << " D " << l.pivot_d.x << ", "
      << l.pivot_d.y << " links " << l.crank << ", " << l.coupler << ", " << l.rocker << " P "
      << l.coupler_point->x << ", " << l.coupler_point->y << " sign " << sign(l.assembly);
  return out.str();
}

/// Calls `check(linkage, crank angle, its pose)` where the linkage closes well away from its dead
/// points and those of its cognates, at which positions are ill conditioned.
template <class Check>
int at_random_positions(unsigned seed, Check check) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(-4.0, 4.0);
  int checked = 0;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage = random_linkage(random);
    const double at = angle(random);
    const auto pose = Motion(linkage).at(at);
    if (!pose) continue;
    const Vec2d ab = pose->b - linkage.pivot_a, bc = pose->c - pose->b,
                dc = pose->c - linkage.pivot_d;
    if (std::min({std::abs(cross(ab, bc)), std::abs(cross(ab, dc)), std::abs(cross(bc, dc))}) <
        0.02) {
      continue;
    }
    const double z = std::hypot(linkage.coupler_point->x, linkage.coupler_point->y);
    const double rest = distance(*linkage.coupler_point, {linkage.coupler, 0});
    if (std::min(z, rest) < 0.05) continue;
    ++checked;
    check(linkage, at, *pose);
  }
  return checked;
}

TEST(Cognates, TraceTheSameCurveAtTheSameTime) {
  std::array<int, 5> classes{};
  const int checked = at_random_positions(31, [&](const FourBar& linkage, double at,
                                                  const Pose& p) {
    ++classes[std::size_t(mobility_class(lengths(linkage)))];
    const auto timed = timed_cognate(linkage);
    ASSERT_TRUE(timed);
    const double timed_angle = at - frame_angle(linkage) + frame_angle(*timed);
    const auto timed_pose = Motion(*timed).at(timed_angle);
    ASSERT_TRUE(timed_pose) << printed(linkage);
    EXPECT_LT(distance(*timed_pose->coupler_point, *p.coupler_point), 1e-11) << printed(linkage);

    const auto coupler = coupler_cognate(linkage, at);
    ASSERT_TRUE(coupler);
    const auto coupler_pose = Motion(coupler->linkage).at(coupler->crank_angle);
    ASSERT_TRUE(coupler_pose) << printed(linkage);
    EXPECT_LT(distance(*coupler_pose->coupler_point, *p.coupler_point), 1e-11) << printed(linkage);

    const auto other = from_other_end(linkage, at);
    const auto other_pose = Motion(other->linkage).at(other->crank_angle);
    ASSERT_TRUE(other_pose) << printed(linkage);
    EXPECT_LT(distance(*other_pose->coupler_point, *p.coupler_point), 1e-11) << printed(linkage);
  });
  EXPECT_GT(checked, 1000);
  EXPECT_GT(std::ranges::min(classes), 20);
}

TEST(Cognates, OfCognatesAreTheOriginal) {
  const auto difference = [](const CognateAt& a, const FourBar& linkage, double at) {
    EXPECT_EQ(a.linkage.assembly, linkage.assembly) << printed(linkage);
    return std::max(largest_difference(a.linkage, linkage),
                    std::abs(std::remainder(a.crank_angle - at, 2 * pi)));
  };
  const auto timed = [](const CognateAt& a) {
    const FourBar cognate = *timed_cognate(a.linkage);
    return CognateAt{cognate, a.crank_angle - frame_angle(a.linkage) + frame_angle(cognate)};
  };
  const auto coupler = [](const CognateAt& a) {
    return *coupler_cognate(a.linkage, a.crank_angle);
  };
  const auto other_end = [](const CognateAt& a) {
    return *from_other_end(a.linkage, a.crank_angle);
  };
  at_random_positions(32, [&](const FourBar& linkage, double at, const Pose&) {
    const CognateAt start{linkage, at};
    EXPECT_LT(difference(timed(timed(start)), linkage, at), 1e-11) << printed(linkage);
    EXPECT_LT(difference(coupler(coupler(start)), linkage, at), 1e-11) << printed(linkage);
    EXPECT_LT(difference(other_end(other_end(start)), linkage, at), 1e-11) << printed(linkage);
    // The three are all there are: going round both ways leads to one linkage from its two ends.
    const CognateAt round = timed(coupler(timed(start)));
    EXPECT_LT(difference(round, other_end(start).linkage, other_end(start).crank_angle), 1e-10)
        << printed(linkage);
  });
}

TEST(Cognates, TwoPublishedOptimaAreEachOthers) {
  // Kunjur & Krishnamurty's eighteen points: two global optima found independently, to 11 digits.
  const auto build = [](double x, double y, double frame, double direction, double crank,
                        double coupler, double rocker, Assembly assembly, Vec2d point) {
    const Vec2d a{x, y};
    return FourBar{a,      a + frame * Vec2d{std::cos(direction), std::sin(direction)},
                   crank,  coupler,
                   rocker, assembly,
                   point};
  };
  const FourBar first =
      build(0.2676555017766404, 0.15464956476517155, 1.053943434877064, 0.28482454670612944,
            0.42387499380145927, 0.9142498244271919, 0.5989168878083408, Assembly::open,
            {0.3705973533271451, 0.39934665568008776});
  const FourBar second =
      build(0.5483086154486572, 0.7165121013827723, 0.777633894361992, -0.34872305853384694,
            0.31274881668788207, 0.44190044396064015, 0.6745633854051432, Assembly::crossed,
            {-0.04078606573488936, -0.3545633537108121});
  const auto cognate = timed_cognate(first);
  ASSERT_TRUE(cognate);
  EXPECT_EQ(cognate->assembly, second.assembly);
  EXPECT_LT(largest_difference(*cognate, second), 1e-9);
}

TEST(Cognates, DegenerateOnesAreEmpty) {
  const FourBar linkage{{0, 0}, {3, 0}, 1, 2.5, 2, Assembly::open, Vec2d{0.3, 0.4}};
  const auto with_point = [&](std::optional<Vec2d> point) {
    FourBar changed = linkage;
    changed.coupler_point = point;
    return changed;
  };
  EXPECT_FALSE(timed_cognate(with_point({})) || coupler_cognate(with_point({}), 1));
  EXPECT_FALSE(timed_cognate(with_point(Vec2d{2.5, 0})));
  EXPECT_TRUE(coupler_cognate(with_point(Vec2d{2.5, 0}), 1));
  EXPECT_FALSE(coupler_cognate(with_point(Vec2d{0, 0}), 1));
  EXPECT_TRUE(timed_cognate(with_point(Vec2d{0, 0})));
  // On the line BC all three pivots are in line, and nothing is lost.
  const auto middle = timed_cognate(with_point(Vec2d{1.25, 0}));
  ASSERT_TRUE(middle);
  EXPECT_EQ(middle->pivot_a, (Vec2d{1.5, 0}));
  const FourBar loose{{0, 0}, {3, 0}, 1, 0.5, 0.5, Assembly::open, Vec2d{0.3, 0.4}};
  EXPECT_FALSE(coupler_cognate(loose, 2) || from_other_end(loose, 2));
}

}  // namespace
}  // namespace cognate::cognates_test
