/// Crank-rockers from the time ratio: published examples, planted linkages, limits, degeneracies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"

namespace cognate::synthesis::quick_return_rocker_test {
namespace {

constexpr double pi = kPi;
constexpr double degree = pi / 180;

[[nodiscard]] bool has(const RockerSolutions& found, const Lengths<double>& links,
                       double tolerance) {
  const double size = links.coupler + links.frame;
  return std::ranges::any_of(found.designs, [&](const QuickReturnRocker& design) {
    const Lengths<double> own = lengths(design.linkage);
    const double off =
        std::max({std::abs(own.crank - links.crank), std::abs(own.coupler - links.coupler),
                  std::abs(own.frame - links.frame)});
    return off <= tolerance * design.condition * size;
  });
}

/// Li & Xu 2011, example 3-8.
const RockerTask book{1.25, 290, 34 * degree};

TEST(QuickReturnRocker, PublishedExample) {
  const auto line = rockers_on_line(book, {1, 1, 0});
  const Lengths<double> first{77.29265548020777, 215.08512711099073, 290, 277.28748496880445};
  EXPECT_TRUE(has(line, first, 1e-15));
  EXPECT_TRUE(has(line, {27.837, 462.047, 290, 214.531}, 1e-5));
  const auto planted = std::ranges::find_if(line.designs, [](const QuickReturnRocker& design) {
    return design.linkage.pivot_a.x < -190;
  });
  ASSERT_NE(planted, line.designs.end());
  EXPECT_NEAR(planted->linkage.pivot_a.x, -196.0718609596045, 1e-11);
  EXPECT_NEAR(planted->linkage.pivot_a.y, 196.0718609596045, 1e-11);
  EXPECT_NEAR(planted->transmission.min / degree, 43.584217563433704, 1e-11);
  EXPECT_NEAR(planted->transmission.max / degree, 87.87092744972567, 1e-11);

  EXPECT_TRUE(
      has(rockers_with_crank(book, 77), {77, 218.43520498001126, 290, 276.8037081761766}, 1e-15));
  EXPECT_TRUE(has(rockers_with_coupler(book, 215), {77.30001875403204, 215, 290, 277.2996696569583},
                  1e-15));
  EXPECT_TRUE(
      has(rockers_with_frame(book, 277), {77.1188168514126, 217.08285220138112, 290, 277}, 1e-15));
}

/// What is requested of a linkage, as it moves: the rocker's swing by sampling its angle.
double sampled_swing(const FourBar& linkage) {
  const Motion motion(linkage);
  const double about = motion.at(0)->rocker_angle;
  double least = 0, most = 0;
  for (int i = 0; i < 20000; ++i) {
    const double angle =
        std::remainder(motion.at(2 * pi * i / 20000)->rocker_angle - about, 2 * pi);
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  return most - least;
}

TEST(QuickReturnRocker, StandsAtItsLimitsWhereItSays) {
  for (const QuickReturnRocker& design : rockers_with_crank(book, 77).designs) {
    const Motion motion(design.linkage);
    const double h = 290 * std::sin(17 * degree);
    const auto outer = motion.at(design.outer), inner = motion.at(design.inner);
    ASSERT_TRUE(outer && inner);
    const double side = design.mirror ? 1 : -1;
    EXPECT_NEAR(outer->c.x, -side * h, 1e-10);
    EXPECT_NEAR(inner->c.x, side * h, 1e-10);
    EXPECT_NEAR(outer->c.y, inner->c.y, 1e-10);
    EXPECT_NEAR(sampled_swing(design.linkage), book.swing, 1e-6);
    const double turn = std::abs(std::remainder(design.outer - design.inner, 2 * pi));
    EXPECT_NEAR((2 * pi - turn) / turn, 1.25, 1e-12);
  }
}

/// A crank-rocker at random, and the task it does.
struct Planted {
  RockerTask task;
  Lengths<double> links;
  Vec2d pivot_a;  ///< in the plane of the task
};

std::optional<Planted> plant(std::mt19937_64& random, double unit) {
  std::uniform_real_distribution<double> length(0.1, 3);
  const Lengths<double> links{0.3 * length(random) * unit, length(random) * unit,
                              length(random) * unit, length(random) * unit};
  if (!crank_rotates(links) || mobility_class(links) != MobilityClass::crank_rocker ||
      grashof_excess(links) > -1e-3) {
    return std::nullopt;
  }
  const auto outer = outer_limit(links), inner = inner_limit(links);
  const auto ratio = time_ratio(links);
  if (!outer || !inner || !ratio) return std::nullopt;
  Planted planted{
      {*ratio, links.rocker, std::abs(outer->rocker_angle - inner->rocker_angle)}, links, {}};
  // D in the origin, the bisector of the limits along +y.
  const double bisector = 0.5 * (outer->rocker_angle + inner->rocker_angle);
  const double to_a = pi + (pi / 2 - bisector);
  planted.pivot_a = links.frame * Vec2d{std::cos(to_a), std::sin(to_a)};
  return planted;
}

TEST(QuickReturnRocker, RecoversPlantedLinkages) {
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> turn(-pi, pi), exponent(-12, 12);
  constexpr double tolerance = 1e-14;
  int planted = 0, crank = 0, coupler = 0, frame = 0, line = 0;
  while (planted < 4000) {
    const auto plant_one = plant(random, std::pow(10, exponent(random)));
    if (!plant_one) continue;
    ++planted;
    const auto& [task, links, a] = *plant_one;
    const Vec2d normal{std::cos(turn(random)), std::sin(turn(random))};
    const auto on_line = rockers_on_line(task, {normal.x, normal.y, dot(normal, a)});
    const auto with_frame = rockers_with_frame(task, links.frame);
    crank += has(rockers_with_crank(task, links.crank), links, tolerance);
    coupler += has(rockers_with_coupler(task, links.coupler), links, tolerance);
    frame += has(with_frame, links, tolerance);
    line += has(on_line, links, tolerance);
    for (const auto* found : {&on_line, &with_frame}) {
      for (const QuickReturnRocker& design : found->designs) {
        EXPECT_LE(design.residual, 1e-10);
        EXPECT_EQ(mobility_class(lengths(design.linkage)), MobilityClass::crank_rocker);
        EXPECT_FALSE(std::isnan(design.condition + design.outer + design.inner));
      }
    }
  }
  // The swing of a planted linkage is itself rounded: what is lost lies within rounding of the end
  // of an arc or of a line that touches it.
  EXPECT_EQ(crank, 4000);
  EXPECT_EQ(coupler, 4000);
  EXPECT_EQ(frame, 4000);
  EXPECT_EQ(line, 4000);
}

TEST(QuickReturnRocker, FindsNothingBeyondTheLimitsOfAnArc) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> swing(0.05, 3.0), ratio(1.01, 4);
  int arcs = 0;
  for (int i = 0; i < 2000; ++i) {
    const RockerTask task{ratio(random), 2, swing(random)};
    for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
      const auto limits = arc_limits(task, arc);
      const double theta = return_angle(task.time_ratio).angle;
      EXPECT_EQ(limits.has_value(), theta < pi / 2 - sign(arc) * task.swing / 2);
      if (!limits) continue;
      const auto count = [&](double crank) {
        const auto found = rockers_with_crank(task, crank);
        return std::ranges::count(found.designs, arc, &QuickReturnRocker::arc);
      };
      const double room = limits->crank.max - limits->crank.min;
      if (room < 1e-3) continue;
      ++arcs;
      EXPECT_EQ(count(limits->crank.min + 1e-6 * room), 2);
      EXPECT_EQ(count(limits->crank.max - 1e-6 * room), 2);
      EXPECT_EQ(count(limits->crank.min * (1 - 1e-6)), 0);
      EXPECT_EQ(count(limits->crank.max * (1 + 1e-6)), 0);
    }
  }
  EXPECT_GT(arcs, 1500);
}

/// The greatest least transmission angle of an arc by brute force.
double sampled_best(const RockerTask& task, PivotArc arc) {
  double best = 0;
  for (const RockerFamilyPoint& point : rocker_family(task, arc, {}, 4000)) {
    best = std::max(best, point.transmission);
  }
  return best;
}

TEST(QuickReturnRocker, TransmitsBest) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> swing(0.1, 2.8), ratio(1.02, 2.5);
  int arcs = 0;
  for (int i = 0; i < 100; ++i) {
    const RockerTask task{ratio(random), 290, swing(random)};
    for (const QuickReturnRocker& best : best_rockers(task, {}).designs) {
      const double sampled = sampled_best(task, best.arc);
      EXPECT_GE(best.transmission.acute_min, sampled - 1e-13);
      EXPECT_LE(best.transmission.acute_min, sampled + 1e-4);
      arcs += !best.mirror;
    }
  }
  EXPECT_GT(arcs, 100);
}

TEST(QuickReturnRocker, KeepsToBoundsWhereItTransmitsBest) {
  const auto free = best_rockers(book, {});
  ASSERT_FALSE(free.designs.empty());
  const double coupler = free.designs[0].linkage.coupler;
  const auto bound = best_rockers(book, {.coupler = {0, 0.9 * coupler}});
  ASSERT_FALSE(bound.designs.empty());
  EXPECT_LE(bound.designs[0].linkage.coupler, 0.9 * coupler * (1 + 1e-15));
  EXPECT_TRUE(best_rockers(book, {.crank = {300, 400}}).designs.empty());
}

[[nodiscard]] bool keeps(const QuickReturnRocker& design, const RockerBounds& bounds) {
  const auto [l1, l2, l3, l4] = lengths(design.linkage);
  const auto [shortest, longest] = std::minmax({l1, l2, l3, l4});
  return longest <= bounds.link_ratio_max * shortest * (1 + 1e-9) &&
         design.transmission.min >= bounds.transmission_min - 1e-9 &&
         design.transmission.max <= bounds.transmission_max + 1e-9;
}

/// The best of an arc that satisfies the bounds, among linkages by their cranks.
double best_by_crank(const RockerTask& task, PivotArc arc, const RockerBounds& bounds) {
  constexpr int kCranks = 700;
  const auto limits = arc_limits(task, arc);
  double best = -1;
  for (int i = 1; limits && i < kCranks; ++i) {
    const double room = limits->crank.max - limits->crank.min;
    for (const auto& design :
         rockers_with_crank(task, limits->crank.min + room * i / kCranks).designs) {
      if (design.arc == arc && keeps(design, bounds)) {
        best = std::max(best, design.transmission.acute_min);
      }
    }
  }
  return best;
}

TEST(QuickReturnRocker, FindsTheBestThatKeepsToRatioAndTransmission) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> swing(0.3, 1.6), ratio(1.02, 1.8), part(0, 1);
  int possible = 0;
  for (int i = 0; i < 40; ++i) {
    const RockerTask task{ratio(random), 290, swing(random)};
    RockerBounds bounds;
    bounds.link_ratio_max = 1.5 + 4 * part(random);
    if (i % 2 == 0) bounds.transmission_min = 0.9 * part(random);
    if (i % 4 == 0) bounds.transmission_max = pi / 2 + part(random);
    const auto found = best_rockers(task, bounds);
    for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
      const double sampled = best_by_crank(task, arc, bounds);
      if (sampled < 0) continue;
      ++possible;
      const auto best = std::ranges::find(found.designs, arc, &QuickReturnRocker::arc);
      ASSERT_NE(best, found.designs.end()) << i;
      EXPECT_TRUE(keeps(*best, bounds)) << i;
      EXPECT_GE(best->transmission.acute_min, sampled - 1e-9) << i;
    }
  }
  EXPECT_GT(possible, 15);
}

/// Bounds that a planted linkage meets, and hardly another of its arc.
TEST(QuickReturnRocker, FindsTheNarrowPartThatKeepsToRatioAndTransmission) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> swing(0.3, 1.6), ratio(1.02, 1.8), part(0.02, 0.98);
  int narrow = 0;
  for (int i = 0; i < 200; ++i) {
    const RockerTask task{ratio(random), 290, swing(random)};
    const auto limits = arc_limits(task, PivotArc::near);
    if (!limits) continue;
    const double room = limits->crank.max - limits->crank.min;
    const auto planted = rockers_with_crank(task, limits->crank.min + room * part(random));
    for (const QuickReturnRocker& one : planted.designs) {
      const auto [l1, l2, l3, l4] = lengths(one.linkage);
      const auto [shortest, longest] = std::minmax({l1, l2, l3, l4});
      RockerBounds bounds;
      bounds.link_ratio_max = longest / shortest * (1 + 1e-7);
      bounds.transmission_min = one.transmission.min - 1e-7;
      bounds.transmission_max = one.transmission.max + 1e-7;
      const auto found = best_rockers(task, bounds);
      const auto best = std::ranges::find(found.designs, one.arc, &QuickReturnRocker::arc);
      ASSERT_NE(best, found.designs.end()) << i;
      EXPECT_TRUE(keeps(*best, bounds)) << i;
      narrow += std::abs(best->linkage.crank - one.linkage.crank) < 1e-4 * one.linkage.crank;
    }
  }
  EXPECT_GT(narrow, 50);
}

/// K = 1 has a best linkage up to a link ratio, and goes beyond it where only that helps.
TEST(QuickReturnRocker, ChoosesWithoutQuickReturn) {
  const RockerTask task{1, 290, 34 * degree};
  const auto usual = best_rockers(task, {});
  ASSERT_EQ(usual.designs.size(), 2U);
  const double h = 290 * std::sin(17 * degree);
  const Lengths<double> links = lengths(usual.designs[0].linkage);
  EXPECT_NEAR(std::max(links.coupler, links.frame), free_link_ratio(task) * h, 1e-9);
  // Beyond: the shortest coupler from which the angle stays above 72.5°, and no shorter one.
  RockerBounds steep;
  steep.transmission_min = 72.5 * degree;
  const auto beyond = best_rockers(task, steep);
  ASSERT_FALSE(beyond.designs.empty());
  const auto& [linkage, transmission] =
      std::pair(beyond.designs[0].linkage, beyond.designs[0].transmission);
  EXPECT_NEAR(transmission.min, 72.5 * degree, 1e-9);
  for (const double part : {0.5, 0.9, 0.99}) {
    const auto shorter = rockers_with_coupler(task, part * linkage.coupler);
    ASSERT_FALSE(shorter.designs.empty());
    EXPECT_LT(shorter.designs[0].transmission.min, 72.5 * degree);
  }
  steep.transmission_min = 80 * degree;  // more than 90° − φ/2
  EXPECT_FALSE(keeps(best_rockers(task, steep).designs.at(0), steep));
}

TEST(QuickReturnRocker, TimeRatioOne) {
  const RockerTask task{1, 2, 1};
  const double h = 2 * std::sin(0.5);
  // The classical relation of the crank-rocker without quick return.
  for (const auto& found : {rockers_with_coupler(task, 3), rockers_with_frame(task, 3),
                            rockers_on_line(task, {1, 0.5, -2})}) {
    ASSERT_FALSE(found.designs.empty());
    for (const QuickReturnRocker& design : found.designs) {
      const auto [l1, l2, l3, l4] = lengths(design.linkage);
      EXPECT_NEAR(l1, h, 1e-14);
      EXPECT_NEAR(l1 * l1 + l4 * l4, l2 * l2 + l3 * l3, 1e-13 * (l4 * l4));
    }
  }
  EXPECT_EQ(rockers_with_coupler(task, 3).designs.size(), 2U);
  EXPECT_EQ(rockers_with_crank(task, h).degeneracy, RockerDegeneracy::any_coupler);
  EXPECT_EQ(rockers_with_crank(task, 0.9 * h).degeneracy, RockerDegeneracy::none);
  EXPECT_EQ(rockers_on_line(task, {0, 3, 3 * 2 * std::cos(0.5)}).degeneracy,
            RockerDegeneracy::line_is_the_arc);
  EXPECT_TRUE(rockers_on_line(task, {0, 1, 1}).designs.empty());
  const auto bounded = best_rockers(task, {.coupler = {0, 8}});
  ASSERT_EQ(bounded.designs.size(), 2U);
  EXPECT_NEAR(bounded.designs[0].linkage.coupler, 8, 1e-13);
  EXPECT_EQ(rocker_family(task, PivotArc::near, {}, 9).size(), 9U);
}

TEST(QuickReturnRocker, IsContinuousAtTimeRatioOne) {
  const auto one = rockers_with_frame({1, 2, 1}, 3),
             near_one = rockers_with_frame({1 + 1e-13, 2, 1}, 3);
  ASSERT_EQ(one.designs.size(), 2U);
  ASSERT_EQ(near_one.designs.size(), 4U);  // of two arcs that are nearly one
  for (const QuickReturnRocker& design : near_one.designs) {
    EXPECT_NEAR(design.linkage.coupler, one.designs[0].linkage.coupler, 1e-11);
    EXPECT_NEAR(design.linkage.crank, one.designs[0].linkage.crank, 1e-11);
  }
}

TEST(QuickReturnRocker, NamesTheArcAboutTheRockerPivot) {
  int tested = 0;
  const double swing = 1.2, theta = swing / 2;
  const RockerTask task{(pi + theta) / (pi - theta), 2, swing};
  EXPECT_EQ(rockers_with_frame(task, 2).degeneracy, RockerDegeneracy::one_frame);
  EXPECT_EQ(rockers_with_frame(task, 1.7).degeneracy, RockerDegeneracy::one_frame);
  for (const QuickReturnRocker& design : rockers_with_crank(task, 0.9).designs) {
    if (design.arc != PivotArc::near) continue;
    ++tested;
    EXPECT_NEAR(lengths(design.linkage).frame, 2, 1e-14);
  }
  EXPECT_GE(tested, 2);
}

TEST(QuickReturnRocker, MarksMirrorImages) {
  const auto found = rockers_on_line(book, {0, 1, 200});
  ASSERT_FALSE(found.designs.empty());
  EXPECT_EQ(std::ranges::count(found.designs, true, &QuickReturnRocker::mirror),
            std::ssize(found.designs) / 2);
  const auto across = rockers_on_line(book, {1, 1, 0});
  EXPECT_EQ(std::ranges::count(across.designs, true, &QuickReturnRocker::mirror), 0);
}

TEST(QuickReturnRocker, RefusesPivotsWithTheLimitsOnTwoCircuits) {
  // The bisector extended through D is seen from within the angle of the swing.
  const auto found = rockers_on_line({2.2, 2, 1}, {1, 0.01, 0});
  EXPECT_TRUE(found.designs.empty());
  EXPECT_GT(found.circuit_defects, 0);
}

}  // namespace
}  // namespace cognate::synthesis::quick_return_rocker_test
