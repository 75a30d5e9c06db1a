/// Cusps, double points and inflections of coupler curves, held against the sextic's gradient in
/// 113 bits, the curve's sampled crossings and turns, planted cusps, known linkages and cognates.
#include "analysis/coupler_curve/curve_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/coupler_curve/pole.hpp"
#include "analysis/linkage/cognates.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::curve_features_test {

void PrintTo(const FourBar& m, std::ostream* out) {
  *out << std::hexfloat << "{{" << m.pivot_a.x << ", " << m.pivot_a.y << "}, {" << m.pivot_d.x
       << ", " << m.pivot_d.y << "}, " << m.crank << ", " << m.coupler << ", " << m.rocker
       << ", P {" << m.coupler_point->x << ", " << m.coupler_point->y << "}}";
}

namespace {

using test::Quad;
using ::testing::PrintToString;
constexpr double pi = kPi;

FourBar random_linkage(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.3, 1.3);
  return {test::random_point(random),
          test::random_point(random),
          length(random),
          length(random),
          length(random),
          Assembly::open,
          test::random_point(random)};
}

/// Whether no feature depends on the last digits: no link turns by the skin of its teeth.
bool is_plain(const FourBar& m) {
  const auto links = lengths(m);
  return can_assemble(links) && std::abs(grashof_excess(links)) > 0.02 && links.frame > 0.2 &&
         norm(*m.coupler_point) > 0.1 && norm(*m.coupler_point - Vec2d{m.coupler, 0}) > 0.1;
}

/// The curve's polynomial: with the coupler's direction e, |P − ce − A| = l₁ and |P − (c − l₂)e −
/// D| = l₃ are linear in e; F is the numerator of |e|² = 1.
Quad sextic(const FourBar& m, const Vec2<Quad>& p) {
  const Vec2<Quad> c = test::quad(*m.coupler_point);
  const auto row = [&](const Vec2d& pivot, const Vec2<Quad>& arm, double length) {
    const Vec2<Quad> from = p - test::quad(pivot);
    const Quad rest = squared_norm(from) + squared_norm(arm) - Quad(length) * Quad(length);
    return std::pair{conj(from) * arm, rest / 2};
  };
  const auto [w1, k1] = row(m.pivot_a, c, m.crank);
  const auto [w2, k2] = row(m.pivot_d, c - Vec2<Quad>{Quad(m.coupler), Quad(0)}, m.rocker);
  const Quad area = cross(w1, w2);
  return squared_norm(k1 * w2 - k2 * w1) - area * area;
}

/// |∇F| at a point, against that a thousandth off: small only where the curve is singular.
double relative_gradient(const FourBar& m, const Vec2d& at) {
  const auto gradient = [&](const Vec2<Quad>& p) {
    const Quad h("1e-12");
    const Quad x = sextic(m, p + Vec2<Quad>{h, Quad(0)}) - sextic(m, p - Vec2<Quad>{h, Quad(0)});
    const Quad y = sextic(m, p + Vec2<Quad>{Quad(0), h}) - sextic(m, p - Vec2<Quad>{Quad(0), h});
    return sqrt(x * x + y * y) / (2 * h);
  };
  const Vec2<Quad> p = test::quad(at);
  const Quad off = gradient(p + Vec2<Quad>{Quad(1e-3), Quad(2e-3)});
  return static_cast<double>(gradient(p) / off);
}

struct Step {
  Vec2d at;
  Vec2d tangent;
  double bend;
};

/// The curve as closed polygons, one for each circuit, from the position kernel; bends to the left
/// of the way round.
std::vector<std::vector<Step>> sampled(const FourBar& m, int steps) {
  std::vector<std::vector<Step>> circuits;
  const auto links = lengths(m);
  const auto append = [&](std::vector<Step>& circuit, double from, double to, Assembly side) {
    FourBar linkage = m;
    linkage.assembly = side;
    MechanismMotion<2> motion(as_mechanism(linkage));
    for (int k = 0; k < steps; ++k) {
      // Crowded towards dead points.
      const double share =
          crank_rotates(links) ? (k + 0.5) / steps : 0.5 - 0.5 * std::cos(pi * (k + 0.5) / steps);
      if (!motion.move_to(frame_angle(m) + from + (to - from) * share)) continue;
      const auto p = motion.point({2, *m.coupler_point});
      const double way = to > from ? 1 : -1;
      circuit.push_back({p[0], way * p[1], way * cross(p[1], p[2])});
    }
  };
  for (const auto& [from, to] : crank_ranges(links)) {
    circuits.emplace_back();
    append(circuits.back(), from, to, Assembly::open);
    if (crank_rotates(links)) circuits.emplace_back();
    append(circuits.back(), to, from, Assembly::crossed);
  }
  return circuits;
}

bool cross_each_other(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
         cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

/// Where the polygons cross themselves and each other.
std::vector<Vec2d> crossings(const std::vector<std::vector<Step>>& circuits) {
  std::vector<std::pair<Vec2d, Vec2d>> sides;
  for (const auto& circuit : circuits) {
    for (std::size_t i = 0; i < circuit.size(); ++i) {
      sides.emplace_back(circuit[i].at, circuit[(i + 1) % circuit.size()].at);
    }
  }
  std::vector<Vec2d> found;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& [a, b] = sides[i];
    const double reach = norm(b - a);
    for (std::size_t k = i + 2; k < sides.size(); ++k) {
      const auto& [c, d] = sides[k];
      if (std::abs(c.x - a.x) > reach + std::abs(d.x - c.x)) continue;
      if (cross_each_other(a, b, c, d)) found.push_back(0.5 * (a + c));
    }
  }
  return found;
}

/// Whether the linkage of the point stands where it says, and shows it there.
void expect_placed(const FourBar& m, const CurvePoint& point, double tolerance) {
  FourBar linkage = m;
  linkage.assembly = point.position.side;
  const auto pose = Motion(linkage).at(point.position.crank_angle);
  ASSERT_TRUE(pose) << PrintToString(m);
  EXPECT_LT(norm(*pose->coupler_point - point.at), tolerance) << PrintToString(m);
}

TEST(CurveFeatures, DoublePointsAreAllCrossingsOfTheCurve) {
  std::mt19937_64 random(81);
  std::array<int, 4> counts{};
  int on_both_circuits = 0;
  for (int i = 0; i < 120; ++i) {
    const FourBar m = random_linkage(random);
    if (!is_plain(m)) continue;
    const auto features = curve_features(m);
    ASSERT_TRUE(features);
    EXPECT_TRUE(features->cusps.empty());
    const auto expected = crossings(sampled(m, 300));
    ASSERT_EQ(features->double_points.size(), expected.size()) << PrintToString(m);
    ASSERT_LE(features->double_points.size(), 3);
    ++counts[features->double_points.size()];
    for (const DoublePoint& point : features->double_points) {
      const auto near = std::ranges::min(
          expected, {}, [&](const Vec2d& other) { return norm(other - point.at); });
      EXPECT_LT(norm(near - point.at), 0.1) << PrintToString(m);
      EXPECT_LT(relative_gradient(m, point.at), 1e-10) << PrintToString(m);
      expect_placed(m, point.first, 1e-7);
      expect_placed(m, point.second, 1e-7);
      on_both_circuits += point.first.circuit != point.second.circuit;
    }
  }
  EXPECT_GT(std::min({counts[0], counts[1], counts[3]}), 2) << PrintToString(counts);
  EXPECT_GT(on_both_circuits, 5);
}

TEST(CurveFeatures, InflectionsAreAllTurnsOfTheCurvature) {
  std::mt19937_64 random(82);
  int checked = 0, inflections = 0;
  for (int i = 0; i < 150; ++i) {
    const FourBar m = random_linkage(random);
    if (!is_plain(m)) continue;
    ++checked;
    const auto features = curve_features(m);
    std::size_t expected = 0;
    for (const auto& circuit : sampled(m, 4000)) {
      for (std::size_t k = 0; k < circuit.size(); ++k) {
        expected += circuit[k].bend * circuit[(k + 1) % circuit.size()].bend < 0;
      }
    }
    ASSERT_EQ(features->inflections.size(), expected) << PrintToString(m);
    for (const CurvePoint& point : features->inflections) {
      ++inflections;
      expect_placed(m, point, 1e-7);
      FourBar linkage = m;
      linkage.assembly = point.position.side;
      MechanismMotion<3> motion(as_mechanism(linkage));
      ASSERT_TRUE(motion.move_to(point.position.crank_angle));
      const auto path = motion.point({2, *m.coupler_point});
      // At a dead point derivatives by the crank are of no use.
      if (norm(path[1]) > 10 || norm(path[1]) < 0.05) continue;
      EXPECT_NEAR(*curvature(path), 0, 1e-8 * (1 + std::abs(*curvature_rate(path))))
          << PrintToString(m);
    }
  }
  EXPECT_GT(checked, 80);
  EXPECT_GT(inflections, 200);
}

TEST(CurveFeatures, PointsOfTheMovingCentrodeHaveCusps) {
  std::mt19937_64 random(83);
  std::uniform_real_distribution<double> share(0.02, 0.98);
  int checked = 0;
  for (int i = 0; i < 250; ++i) {
    FourBar m = random_linkage(random);
    if (!is_plain(m)) continue;
    m.assembly = i % 2 == 0 ? Assembly::open : Assembly::crossed;
    const auto range = crank_ranges(lengths(m)).back();
    const double angle = frame_angle(m) + range.from + share(random) * (range.to - range.from);
    MechanismMotion<3> motion(as_mechanism(m));
    if (!motion.move_to(angle)) continue;
    const auto& coupler = motion.bodies()[2];
    const auto at = pole(coupler);
    if (!at || norm(at->at) > 10 || norm(at->rate) < 0.05) continue;
    m.coupler_point = conj(coupler.direction) * (at->at - coupler.origin[0]);
    if (!is_plain(m)) continue;
    ++checked;
    const auto features = curve_features(m);
    ASSERT_TRUE(features);
    ASSERT_EQ(features->cusps.size(), 1) << PrintToString(m);
    const CurvePoint& cusp = features->cusps.front();
    EXPECT_LT(norm(cusp.at - at->at), 1e-11) << PrintToString(m);
    EXPECT_NEAR(test::turn(angle, cusp.position.crank_angle), 0, 1e-7) << PrintToString(m);
    EXPECT_EQ(cusp.position.side, m.assembly);
    EXPECT_LT(relative_gradient(m, cusp.at), 1e-9) << PrintToString(m);
    // A cusp is one of the three double points, and comes without inflections and loops of its own.
    EXPECT_LE(features->double_points.size(), 2) << PrintToString(m);
    for (const CurvePoint& point : features->inflections) {
      EXPECT_GT(norm(point.at - cusp.at), 1e-9) << PrintToString(m);
    }
  }
  EXPECT_GT(checked, 100);
}

TEST(CurveFeatures, WattsCurveCrossesItselfHalfWay) {
  // Equal cranks on opposite sides and the coupler's middle: a figure of eight about the middle of
  // the frame, where it has inflections of both branches.
  const FourBar watt{{0, 0}, {4, 0}, 2, 1.2, 2, Assembly::open, Vec2d{0.6, 0}};
  const auto features = curve_features(watt);
  ASSERT_TRUE(features);
  const auto centre =
      std::ranges::min_element(features->double_points, {}, [](const DoublePoint& p) {
        return norm(p.at - Vec2d{2, 0});
      });
  ASSERT_NE(centre, features->double_points.end());
  EXPECT_LT(norm(centre->at - Vec2d{2, 0}), 1e-14);
  const auto at_centre = std::ranges::count_if(features->inflections, [](const CurvePoint& p) {
    return norm(p.at - Vec2d{2, 0}) < 1e-12;
  });
  EXPECT_EQ(at_centre, 2);
}

TEST(CurveFeatures, OfOneCircuitAreThoseWithAPositionOnIt) {
  std::mt19937_64 random(31);
  std::size_t inflections = 0, double_points = 0, on_two_ranges = 0;
  for (int k = 0; k < 200; ++k) {
    const FourBar m = random_linkage(random);
    if (!is_plain(m)) continue;
    const auto links = lengths(m);
    const auto all = curve_features(m);
    ASSERT_TRUE(all.has_value());
    const bool two_ranges = crank_ranges(links).size() > 1;
    for (const CircuitChoice circuit :
         {CircuitChoice{Assembly::open, 1}, CircuitChoice{Assembly::crossed, -1}}) {
      const auto is_on = [&](const CurvePoint& point) {
        if (crank_rotates(links)) return point.position.side == circuit.assembly;
        const bool left = std::sin(point.position.crank_angle - frame_angle(m)) > 0;
        return !two_ranges || left == (circuit.half > 0);
      };
      const auto are_on = [&](const DoublePoint& p) { return is_on(p.first) && is_on(p.second); };
      const auto found = curve_features(m, circuit);
      ASSERT_TRUE(found.has_value());
      EXPECT_EQ(std::ssize(found->inflections), std::ranges::count_if(all->inflections, is_on));
      EXPECT_EQ(std::ssize(found->double_points), std::ranges::count_if(all->double_points, are_on))
          << PrintToString(m);
      inflections += found->inflections.size();
      double_points += found->double_points.size();
      on_two_ranges += two_ranges ? found->inflections.size() : 0;
    }
  }
  EXPECT_GT(inflections, 100U);
  EXPECT_GT(double_points, 50U);
  EXPECT_GT(on_two_ranges, 10U);
}

TEST(CurveFeatures, DoNotDependOnTheUnitOfLength) {
  int tested = 0;
  std::mt19937_64 random(84);
  for (int i = 0; i < 20; ++i) {
    const FourBar m = random_linkage(random);
    const auto features = curve_features(m);
    for (const double scale : {0x1p-400, 0x1p+400}) {
      const FourBar scaled{scale * m.pivot_a,       scale * m.pivot_d, scale * m.crank,
                           scale * m.coupler,       scale * m.rocker,  m.assembly,
                           scale * *m.coupler_point};
      const auto same = curve_features(scaled);
      ASSERT_EQ(features.has_value(), same.has_value());
      if (!same) continue;
      ++tested;
      ASSERT_EQ(features->inflections.size(), same->inflections.size());
      for (std::size_t k = 0; k < same->inflections.size(); ++k) {
        EXPECT_EQ(scale * features->inflections[k].at, same->inflections[k].at);
      }
      EXPECT_EQ(features->double_points.size(), same->double_points.size());
    }
  }
  EXPECT_GE(tested, 36);
}

TEST(CurveFeatures, WhereThereAreNoneItIsSaid) {
  const FourBar m{{0, 0}, {3, 0}, 1, 2.5, 2, Assembly::open, Vec2d{0.3, 0.4}};
  const auto with_point = [&](std::optional<Vec2d> point) {
    FourBar changed = m;
    changed.coupler_point = point;
    return curve_features(changed);
  };
  EXPECT_TRUE(with_point(Vec2d{0.3, 0.4}));
  EXPECT_FALSE(with_point({}) || with_point(Vec2d{0, 0}) || with_point(Vec2d{2.5, 0}));
  EXPECT_FALSE(curve_features({{0, 0}, {9, 0}, 1, 2.5, 2, Assembly::open, Vec2d{0.3, 0.4}}));
  // A parallelogram's coupler point goes in a circle too, and what inflections there are belong to
  // the antiparallelogram.
  const auto features = curve_features({{0, 0}, {3, 0}, 1, 3, 1, Assembly::open, Vec2d{1, 0.5}});
  ASSERT_TRUE(features);
  EXPECT_TRUE(features->cusps.empty());
  for (const CurvePoint& point : features->inflections) {
    EXPECT_GT(std::abs(norm(point.at - Vec2d{1, 0.5}) - 1), 1e-3);
  }
}

TEST(CurveFeatures, AreFiniteForLinkagesOfWholeLengthsWhichHaveChangePoints) {
  int change_points = 0;
  for (int i = 0; i < 81; ++i) {
    const FourBar m{{0, 0},
                    {1.0 + i % 3, 0},
                    1.0 + i / 3 % 3,
                    1.0 + i / 9 % 3,
                    1.0 + i / 27,
                    Assembly::open,
                    i % 2 == 0 ? Vec2d{0.5, 0.75} : Vec2d{0.5, 0}};
    const auto features = curve_features(m);
    EXPECT_EQ(features.has_value(), can_assemble(lengths(m)));
    if (!features) continue;
    change_points += is_change_point(lengths(m));
    EXPECT_LE(features->double_points.size(), 3) << PrintToString(m);
    EXPECT_LE(features->inflections.size(), 12) << PrintToString(m);
    for (const auto& p : features->inflections) EXPECT_TRUE(std::isfinite(norm(p.at)));
    for (const auto& p : features->double_points) {
      EXPECT_TRUE(std::isfinite(norm(p.at)));
      // A change point is a double point of its own, where links in line leave both ways open.
      EXPECT_LT(relative_gradient(m, p.at), 1e-6) << PrintToString(m);
    }
  }
  EXPECT_GT(change_points, 20);
}

// ---- Cognates share the curve and all that it has.

TEST(Cognates, ShareTheFeaturesOfTheirCurve) {
  std::mt19937_64 random(85);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const FourBar m = random_linkage(random);
    if (!is_plain(m)) continue;
    const auto range = crank_ranges(lengths(m)).front();
    const double angle = frame_angle(m) + 0.4 * range.from + 0.6 * range.to;
    const auto features = curve_features(m);
    const auto second = timed_cognate(m);
    const auto third = coupler_cognate(m, angle);
    ASSERT_TRUE(features && second && third);
    for (const FourBar& cognate : {*second, third->linkage}) {
      const auto same = curve_features(cognate);
      ASSERT_TRUE(same) << PrintToString(m);
      ASSERT_EQ(same->inflections.size(), features->inflections.size()) << PrintToString(m);
      ASSERT_EQ(same->double_points.size(), features->double_points.size()) << PrintToString(m);
      const auto is_among = [](const Vec2d& at, const auto& points) {
        return std::ranges::any_of(points, [&](const auto& p) { return norm(p.at - at) < 1e-9; });
      };
      for (const auto& p : features->inflections) EXPECT_TRUE(is_among(p.at, same->inflections));
      for (const auto& p : features->double_points) {
        EXPECT_TRUE(is_among(p.at, same->double_points)) << PrintToString(m);
      }
    }
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(Cognates, ShareCurvatureAndItsRate) {
  std::mt19937_64 random(86);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const FourBar m = random_linkage(random);
    const double angle = 0.03 * i;
    const auto second = timed_cognate(m);
    const auto third = coupler_cognate(m, angle);
    if (!is_plain(m) || !third) continue;
    const double second_angle = angle - frame_angle(m) + frame_angle(*second);
    const auto path = [](const FourBar& linkage, double at) {
      MechanismMotion<3> motion(as_mechanism(linkage));
      motion.move_to(at);
      return motion.point({2, *linkage.coupler_point});
    };
    const auto a = path(m, angle), b = path(*second, second_angle),
               c = path(third->linkage, third->crank_angle);
    const double slowest = std::min({norm(a[1]), norm(b[1]), norm(c[1])});
    const double fastest = std::max({norm(a[1]), norm(b[1]), norm(c[1])});
    if (slowest < 0.1 || fastest > 3) continue;
    ++checked;
    EXPECT_LT(norm(a[0] - b[0]) + norm(a[0] - c[0]), 1e-12);
    // The second keeps the time, and so all derivatives; the third may run the other way.
    for (std::size_t k = 1; k < 4; ++k) EXPECT_LT(norm(a[k] - b[k]), 1e-9 * (1 + norm(a[k])));
    const double way = dot(a[1], c[1]) < 0 ? -1 : 1;
    EXPECT_NEAR(way * *curvature(c), *curvature(a), 1e-9 * (1 + std::abs(*curvature(a))));
    EXPECT_NEAR(*curvature_rate(c), *curvature_rate(a), 1e-7 * (1 + std::abs(*curvature_rate(a))));
  }
  EXPECT_GT(checked, 50);
}

}  // namespace
}  // namespace cognate::curve_features_test
