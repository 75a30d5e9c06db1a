/// What the dimensions of the double-slider mechanisms settle, held against their motion in 113
/// bits and against what is known of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "analysis/linkage/double_slider_travel.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::double_slider_test {
namespace {

using test::Quad;
using test::QuadMotion;
constexpr double pi = kPi;

double distance(const Vec2d& a, const Vec2d& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

Vec2d rounded(const Vec2<Quad>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// A slot or second line that leans by 10° at least.
Vec2d random_slot(std::mt19937_64& random) {
  while (true) {
    const Vec2d slot = test::random_direction(random);
    if (std::abs(slot.y) > 0.17) return slot;
  }
}

/// Where the origin of `body` stands along `direction` from `foot`, and how fast it goes there.
struct Along {
  double displacement, slope;
};

template <class M>
Along along(const M& m, const Vec2d& foot, const Vec2d& direction, std::size_t body, double angle) {
  const auto bodies = QuadMotion(as_mechanism(m), m.direction).at(angle);
  const auto& origin = (*bodies)[body].origin;
  const Vec2<Quad> d = test::unit(direction);
  return {static_cast<double>(dot(origin[0] - test::quad(foot), d)),
          static_cast<double>(dot(origin[1], d))};
}

TEST(ScotchYoke, MovesAsTheCosine) {
  const ScotchYoke m{.pivot = {}, .crank = 2};
  EXPECT_DOUBLE_EQ(displacement(m, 1), 2 * std::cos(1));
  EXPECT_EQ(stroke(m), 4);
  EXPECT_EQ(pressure_angle(m), 0);
  const auto [least, greatest] = limits(m);
  EXPECT_EQ(least.displacement, -2);
  EXPECT_DOUBLE_EQ(std::abs(least.crank_angle), pi);
  EXPECT_EQ(greatest.displacement, 2);
  EXPECT_EQ(greatest.crank_angle, 0);
}

TEST(ScotchYoke, WithAnInclinedSlotMovesAsEvaluated) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const ScotchYoke m{test::random_point(random), 1.1 + number(random), number(random),
                       test::random_direction(random), random_slot(random)};
    const double angle = 3 * number(random);
    const auto at = along(m, m.pivot, m.direction, 3, angle);
    EXPECT_NEAR(displacement(m, angle), at.displacement, 1e-14);
    const auto [least, greatest] = limits(m);
    EXPECT_NEAR(greatest.displacement - least.displacement, stroke(m), 1e-14);
    for (const auto& [crank, s] : {least, greatest}) {
      const auto there = along(m, m.pivot, m.direction, 3, crank);
      EXPECT_NEAR(there.displacement, s, 1e-14);
      EXPECT_NEAR(there.slope, 0, 1e-14);
    }
    // The block's force is across the slot.
    EXPECT_NEAR(std::cos(pressure_angle(m)), std::abs(m.slot.y), 1e-15);
  }
}

TEST(TangentGenerator, MovesAsEvaluated) {
  std::mt19937_64 random(62);
  std::uniform_real_distribution<double> number(-1, 1), inside(0.05, pi - 0.05);
  for (int i = 0; i < 200; ++i) {
    const TangentGenerator m{test::random_point(random), number(random),
                             test::random_direction(random)};
    const auto [from, to] = crank_range(m);
    EXPECT_DOUBLE_EQ(to - from, pi);
    const double a = from + inside(random), b = from + inside(random);
    const double s = along(m, m.pivot, m.direction, 3, a).displacement;
    EXPECT_NEAR(*displacement(m, a), s, 1e-13);
    EXPECT_NEAR(crank_angle(m, s), a, 1e-13);
    const CrankRange range{std::min(a, b), std::max(a, b)};
    EXPECT_NEAR(*travel(m, range), std::abs(*displacement(m, b) - s), 1e-13);
    // The lean is that of a right-angled triangle with the offset and the displacement as legs.
    EXPECT_NEAR(*pressure_angle(m, a), std::atan2(std::abs(s), std::abs(m.offset)), 1e-13);
    EXPECT_EQ(*greatest_pressure_angle(m, range),
              std::max(*pressure_angle(m, a), *pressure_angle(m, b)));
    // The other half turn, and any range that reaches into it.
    EXPECT_FALSE(displacement(m, a + pi) || pressure_angle(m, a - pi));
    EXPECT_FALSE(travel(m, {a, a + pi}) || travel(m, {a, a + 2 * pi}));
    EXPECT_FALSE(greatest_pressure_angle(m, {a, a + 2 * pi}));
  }
  // 1 at 45°, √3 at 60°.
  EXPECT_DOUBLE_EQ(*displacement({{}, 1, {1, 0}}, pi / 6), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(*displacement({{}, -1, {1, 0}}, -pi / 4), 1);
}

TEST(EllipticTrammel, PinsMoveAsEvaluated) {
  std::mt19937_64 random(63);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const EllipticTrammel m{test::random_point(random), 1.1 + number(random),
                            test::random_direction(random), random_slot(random)};
    const double angle = 3 * number(random);
    for (int pin = 0; pin < 2; ++pin) {
      const Vec2d line = pin == 0 ? m.direction : m.direction * m.second_line;
      const std::size_t body = pin == 0 ? 2 : 3;
      EXPECT_NEAR(displacements(m, angle)[static_cast<std::size_t>(pin)],
                  along(m, m.centre, line, body, angle).displacement, 1e-14);
      const auto [least, greatest] = limits(m, pin);
      EXPECT_NEAR(greatest.displacement - least.displacement, stroke(m), 1e-14);
      for (const auto& [link, s] : {least, greatest}) {
        const auto there = along(m, m.centre, line, body, link);
        EXPECT_NEAR(there.displacement, s, 1e-14);
        EXPECT_NEAR(there.slope, 0, 1e-14);
        EXPECT_NEAR(pressure_angle(m, 1 - pin, link), pi / 2, 1e-14);
      }
      const Vec2d link = m.direction * Vec2d{std::cos(angle), std::sin(angle)};
      EXPECT_NEAR(std::cos(pressure_angle(m, pin, angle)), std::abs(dot(link, line)), 1e-14);
    }
  }
}

TEST(EllipticTrammel, PointsTraceTheirEllipses) {
  std::mt19937_64 random(64);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const EllipticTrammel m{test::random_point(random), 1.1 + number(random),
                            test::random_direction(random), random_slot(random)};
    const Vec2d point = test::random_point(random);
    const auto [centre, major, minor, axis] = path(m, point);
    MechanismMotion<0> motion(as_mechanism(m));
    double farthest = 0;
    for (int k = 0; k < 400; ++k) {
      ASSERT_TRUE(motion.move_to(2 * pi * k / 400));
      const Vec2d p = conj(axis) * (motion.point({1, point})[0] - centre);
      EXPECT_NEAR(std::pow(p.x * minor, 2) + std::pow(p.y * major, 2), std::pow(major * minor, 2),
                  1e-13 * std::pow(1 + major, 4));
      farthest = std::max(farthest, std::hypot(p.x, p.y));
    }
    EXPECT_NEAR(farthest, major, 1e-3 * major);
  }
  // The textbook's: half axes are the distances of a point of the bar from its pins.
  const EllipticTrammel bar{.centre = {}, .length = 3};
  EXPECT_DOUBLE_EQ(path(bar, {1, 0}).major, 2);
  EXPECT_DOUBLE_EQ(path(bar, {1, 0}).minor, 1);
  EXPECT_EQ(std::abs(path(bar, {1, 0}).direction.x), 1);
  EXPECT_NEAR(path(bar, {1.5, 0}).major, path(bar, {1.5, 0}).minor, 1e-15);
  EXPECT_NEAR(path(bar, {1.5, 1.5}).minor, 0, 1e-15);  // on Cardan's circle: a straight line
}

TEST(EllipticTrammel, RollsOnCardansCircles) {
  std::mt19937_64 random(65);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const EllipticTrammel m{test::random_point(random), 1.1 + number(random),
                            test::random_direction(random), random_slot(random)};
    const auto circles = cardan_circles(m);
    const auto bodies = QuadMotion(as_mechanism(m), m.direction).at(3 * number(random));
    const auto& link = (*bodies)[1];
    // The pole, where the velocity is zero.
    const Vec2<Quad> pole = link.origin[0] + (Quad(1) / link.turn[0]) * perp(link.origin[1]);
    EXPECT_NEAR(distance(rounded(pole), m.centre), circles.fixed_radius, 1e-14);
    const Vec2<Quad> in_link = conj(link.direction) * (pole - link.origin[0]);
    EXPECT_NEAR(distance(rounded(in_link), circles.moving_centre), circles.moving_radius, 1e-14);
    EXPECT_EQ(circles.fixed_radius, 2 * circles.moving_radius);
  }
}

TEST(OldhamCoupling, TurnsBothShaftsAlike) {
  std::mt19937_64 random(66);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const OldhamCoupling m{test::random_point(random), test::random_point(random),
                           random_slot(random)};
    MechanismMotion<1> motion(as_mechanism(m));
    const auto circle = disc_path(m);
    EXPECT_NEAR(distance(circle.centre, m.pivot_a), circle.radius, 1e-13);
    EXPECT_NEAR(distance(circle.centre, m.pivot_d), circle.radius, 1e-13);
    double least = 0, greatest = 0;
    for (int k = 0; k < 400; ++k) {
      ASSERT_TRUE(motion.move_to(2 * pi * k / 400));
      const auto bodies = motion.bodies();
      EXPECT_NEAR(bodies[2].turn[0], 1, 1e-15);
      const Vec2d disc = bodies[3].origin[0];
      EXPECT_NEAR(distance(disc, circle.centre), circle.radius, 1e-13);
      // Twice as fast round the circle.
      EXPECT_NEAR(std::hypot(bodies[3].origin[1].x, bodies[3].origin[1].y), 2 * circle.radius,
                  1e-13);
      const double s = dot(bodies[1].direction, disc - m.pivot_a);
      least = std::min(least, s);
      greatest = std::max(greatest, s);
      EXPECT_NEAR(std::abs(cross(bodies[1].direction, bodies[2].direction)),
                  std::sin(transmission_angle(m)), 1e-14);
    }
    EXPECT_NEAR(greatest - least, stroke(m), 1e-3 * stroke(m));
  }
  const OldhamCoupling m{.pivot_a = {}, .pivot_d = {3, 4}};
  EXPECT_EQ(eccentricity(m), 5);
  EXPECT_EQ(stroke(m), 10);
  EXPECT_DOUBLE_EQ(transmission_angle(m), pi / 2);
}

}  // namespace
}  // namespace cognate::double_slider_test
