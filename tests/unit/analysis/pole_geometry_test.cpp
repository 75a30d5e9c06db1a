/// Poles, centrodes, circles and cubics of moving bodies, held against differences of their motion
/// in 113 bits, known motions and published facts.
#include <gtest/gtest.h>

#include <array>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/coupler_curve/pole.hpp"
#include "analysis/coupler_curve/stationary_curvature.hpp"
#include "analysis/linkage/double_slider_travel.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::pole_geometry_test {
namespace {

using test::Quad;
using test::QuadMotion;
constexpr double pi = kPi;
using Body = BodyMotion<double, 3>;
using QuadBody = BodyMotion<Quad, 2>;

Vec2d rounded(const Vec2<Quad>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

Vec2d unit_vector(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

Vec2d in_body(const Body& body, const Vec2d& point) {
  return conj(body.direction) * (point - body.origin[0]);
}

/// A body of a mechanism at one position, and what is next to it.
struct Sample {
  Mechanism<double> mechanism;
  std::size_t body;
  double at;
  Body motion;
  Pole pole;

  QuadBody near(const Quad& step) const {
    return (*QuadMotion(mechanism).at(Quad(at) + step))[body];
  }
};

/// dy/dq and d²y/dq² of a function of the drive in 113 bits, to about 1e-14.
template <class Function>
std::array<Vec2d, 2> derivatives(Function f) {
  const Quad h("1e-8");
  const Vec2<Quad> before = f(-h), here = f(Quad(0)), after = f(h);
  return {rounded((1 / (2 * h)) * (after - before)),
          rounded((1 / (h * h)) * (after - here - here + before))};
}

Vec2<Quad> pole_of(const QuadBody& body) {
  return body.origin[0] + (1 / body.turn[0]) * perp(body.origin[1]);
}

/// The curvature of the path of a point, positive to the left, in 113 bits.
Quad curvature_of(const QuadBody& body, const Vec2d& at) {
  const auto p = point_motion(body, test::quad(at));
  const Quad square = squared_norm(p[1]);
  return cross(p[1], p[2]) / (square * sqrt(square));
}

/// Calls `check` for turning bodies of random mechanisms, with poles neither far off nor nearly
/// fixed, which would blow up what is compared; at least 150.
template <class Check>
void at_random_bodies(unsigned seed, Check check) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> length(0.3, 1.3), angle(-3, 3);
  int checked = 0;
  for (int i = 0; i < 800; ++i) {
    const Vec2d a = test::random_point(random), d = test::random_point(random);
    std::array<std::pair<Mechanism<double>, std::size_t>, 3> choices{
        std::pair{as_mechanism(FourBar{a, d, length(random), length(random), length(random)}), 2},
        std::pair{as_mechanism(SliderCrank{a, length(random), length(random), 0.3,
                                           test::random_direction(random)}),
                  2},
        std::pair{as_mechanism(OscillatingBlock{a, d, length(random), 0.2}), 3}};
    const auto& [mechanism, body] = choices[static_cast<std::size_t>(i) % 3];
    const double at = angle(random);
    MechanismMotion<3> motion(mechanism);
    if (!motion.move_to(at)) continue;
    const Body& state = motion.bodies()[body];
    const auto found = pole(state);
    if (!found || std::abs(found->turn) < 0.1 || std::abs(found->turn) > 10) continue;
    const double size = norm(found->at) + norm(found->rate) + norm(found->second);
    if (size > 20 || norm(found->rate) < 0.05) continue;
    check(Sample{mechanism, body, at, state, *found});
    ++checked;
  }
  EXPECT_GT(checked, 150);
}

TEST(Pole, StandsStillAndMovesAsDifferencesSay) {
  at_random_bodies(71, [](const Sample& s) {
    const auto still = point_motion(s.motion, in_body(s.motion, s.pole.at));
    EXPECT_LT(norm(still[1]), 1e-13);
    const auto [first, second] = derivatives([&](const Quad& h) { return pole_of(s.near(h)); });
    EXPECT_LT(norm(pole_velocity(s.pole) - first), 1e-11 * (1 + norm(first)));
    const double turn = s.pole.turn;
    const Vec2d expected = (turn * turn) * (s.pole.second + s.pole.spin * s.pole.rate);
    EXPECT_LT(norm(expected - second), 1e-9 * (1 + norm(second)));
  });
}

TEST(Pole, CentrodesRollOnEachOther) {
  at_random_bodies(72, [](const Sample& s) {
    const Centrode fixed = fixed_centrode(s.pole), moving = moving_centrode(s.motion, s.pole);
    ASSERT_TRUE(fixed.tangent && moving.tangent);
    // One tangent and, per angle turned, one speed: δ is the difference of the curvatures.
    EXPECT_LT(norm(s.motion.direction * *moving.tangent - *fixed.tangent), 1e-14);
    EXPECT_NEAR(*fixed.curvature - *moving.curvature, 1 / norm(s.pole.rate),
                1e-12 * (1 + std::abs(*fixed.curvature)));
    // Both by differences of the pole's place, in the plane and in the body.
    const auto compare = [&](const Centrode& centrode, const auto& place) {
      const auto [v, a] = derivatives(place);
      const double sense = s.pole.turn > 0 ? 1 : -1;
      EXPECT_LT(norm((sense / norm(v)) * v - *centrode.tangent), 1e-10);
      EXPECT_NEAR(*centrode.curvature, sense * cross(v, a) / std::pow(norm(v), 3),
                  1e-9 * (1 + std::abs(*centrode.curvature)) / std::min(1.0, norm(v)));
    };
    compare(fixed, [&](const Quad& h) { return pole_of(s.near(h)); });
    compare(moving, [&](const Quad& h) {
      const QuadBody body = s.near(h);
      return conj(body.direction) * (pole_of(body) - body.origin[0]);
    });
  });
}

TEST(PathCurvature, VanishesOnTheInflectionCircle) {
  int points = 0;
  at_random_bodies(73, [&](const Sample& s) {
    const Circle circle = inflection_circle(s.pole);
    for (const double angle : {0.3, 1.7, 2.9, 4.4}) {
      const Vec2d point = circle.centre + circle.radius * unit_vector(angle);
      const double r = norm(point - s.pole.at);
      if (r < 0.05 * circle.radius) continue;
      const double bend =
          static_cast<double>(curvature_of(s.near(Quad(0)), in_body(s.motion, point)));
      EXPECT_NEAR(bend * r, 0, 1e-11 / r);
      ++points;
    }
    const Vec2d at_top = inflection_pole(s.pole);
    EXPECT_NEAR(norm(at_top - circle.centre), circle.radius, 1e-13);
    EXPECT_NEAR(norm(at_top - s.pole.at), 2 * circle.radius, 1e-13);
  });
  EXPECT_GT(points, 450);
}

TEST(PathCurvature, IsThatOfEulerAndSavary) {
  std::mt19937_64 random(74);
  int points = 0;
  at_random_bodies(74, [&](const Sample& s) {
    const Vec2d point = test::random_point(random) + s.pole.at;
    const Vec2d local = in_body(s.motion, point);
    const auto path = point_motion(s.motion, local);
    const double bend = static_cast<double>(curvature_of(s.near(Quad(0)), local));
    const double r = norm(point - s.pole.at);
    if (r < 0.1 || std::abs(bend) < 0.05 || std::abs(bend) > 20) return;
    ++points;
    EXPECT_NEAR(*curvature(path), bend, 1e-11 * (1 + 1 / (r * r)));
    const auto centre = conjugate_centre(s.pole, point);
    ASSERT_TRUE(centre);
    EXPECT_LT(norm(*centre - *centre_of_curvature(path)), 1e-9 / (r * r));
    EXPECT_NEAR(norm(*centre - point), 1 / std::abs(bend), 1e-9 / (r * r));
    // (1/r − 1/c) sin ψ = 1/δ, signed along the ray from the pole to the point.
    const Vec2d ray = (1 / r) * (point - s.pole.at);
    const double c = dot(ray, *centre - s.pole.at);
    EXPECT_LT(norm(*conjugate_point(s.pole, *centre) - point), 1e-9 / std::min(1.0, c * c * r * r));
    const double sine = cross(ray, s.pole.rate) / norm(s.pole.rate);
    EXPECT_NEAR((1 / r - 1 / c) * sine * norm(s.pole.rate), 1, 1e-8 / std::min(1.0, std::abs(c)));
    // dκ/ds by differences.
    const Quad h("1e-8");
    const Quad change = curvature_of(s.near(h), local) - curvature_of(s.near(-h), local);
    const double rate = static_cast<double>(change / (2 * h)) / norm(path[1]);
    EXPECT_NEAR(*curvature_rate(path), rate, 1e-10 * (1 + std::pow(r, -4)) * (1 + std::abs(rate)));
  });
  EXPECT_GT(points, 100);
}

TEST(PathCurvature, OfFarPointsIsCentredOnTheReturnCircle) {
  at_random_bodies(75, [](const Sample& s) {
    const Circle circle = return_circle(s.pole);
    for (const double angle : {0.2, 1.1, 2.5}) {
      const auto centre = conjugate_centre(s.pole, s.pole.at + 1e9 * unit_vector(angle));
      EXPECT_NEAR(norm(*centre - circle.centre), circle.radius, 1e-6);
    }
    const Vec2d on_circle = circle.centre + circle.radius * unit_vector(1);
    const auto far = conjugate_point(s.pole, on_circle);
    EXPECT_TRUE(!far || norm(*far) > 1e9 * std::pow(norm(on_circle - s.pole.at), 2));
  });
}

TEST(PathCurvature, BressesCirclesMeetInTheAccelerationPole) {
  at_random_bodies(76, [](const Sample& s) {
    // A drive that itself accelerates: P̈ = P″ q̇² + P′ q̈.
    for (const double acceleration : {0.0, 0.7}) {
      const double spin = s.pole.spin + acceleration / s.pole.turn;
      const auto acceleration_of = [&](const Vec2d& point) {
        const auto path = point_motion(s.motion, in_body(s.motion, point));
        return path[2] + acceleration * path[1];
      };
      const double scale = 1e-12 * (1 + norm(s.motion.origin[2])) * (1 + 1 / (spin * spin));
      const Vec2d still = acceleration_pole(s.pole, spin);
      EXPECT_LT(norm(acceleration_of(still)), scale);
      const Circle normal = inflection_circle(s.pole);
      const auto tangential = tangential_circle(s.pole, spin);
      ASSERT_TRUE(tangential);
      EXPECT_NEAR(norm(still - normal.centre), normal.radius, scale);
      EXPECT_NEAR(norm(still - tangential->centre), tangential->radius, scale);
      const Vec2d point = tangential->centre + tangential->radius * unit_vector(0.8);
      const Vec2d v = point_motion(s.motion, in_body(s.motion, point))[1];
      EXPECT_NEAR(dot(v, acceleration_of(point)), 0, scale * (1 + norm(v)) * (1 + norm(point)));
    }
    EXPECT_FALSE(tangential_circle(s.pole, 0));
  });
}

TEST(StationaryCurvature, HoldsOnTheCirclingPointCurve) {
  int points = 0, centres_near = 0;
  at_random_bodies(77, [&](const Sample& s) {
    const auto cubic = circling_points(s.pole);
    ASSERT_TRUE(cubic);
    const auto centres = centre_points(*cubic);
    for (const Vec2d& point : sample(*cubic, 7, 3)) {
      const double r = norm(point - s.pole.at);
      if (r < 0.1) continue;
      ++points;
      EXPECT_NEAR(cubic->value(point), 0, 1e-12 * (1 + r * r * r));
      const Vec2d local = in_body(s.motion, point);
      const Quad h("1e-8");
      const Quad change = curvature_of(s.near(h), local) - curvature_of(s.near(-h), local);
      const double size = norm(s.pole.rate) + norm(s.pole.second);
      EXPECT_NEAR(static_cast<double>(change / (2 * h)), 0,
                  1e-10 * (1 + size) * std::abs(s.pole.turn) / std::pow(std::min(1.0, r), 4));
      const auto centre = conjugate_centre(s.pole, point);
      if (!centre || norm(*centre - s.pole.at) > 5) continue;
      ++centres_near;
      EXPECT_NEAR(centres.value(*centre), 0, 1e-9 * (1 + norm(*centre)) / (r * r));
    }
    EXPECT_LE(sample(*cubic, 7, 0.5).size(), sample(*cubic, 7, 3).size());
  });
  EXPECT_GT(points, 500);
  EXPECT_GT(centres_near, points / 4);
}

TEST(StationaryCurvature, BallsPointMovesStraightLongest) {
  int checked = 0;
  at_random_bodies(78, [&](const Sample& s) {
    const auto cubic = circling_points(s.pole);
    const auto ball = ball_point(*cubic);
    ASSERT_TRUE(ball);
    const double r = norm(*ball - s.pole.at);
    if (r < 0.1) return;
    ++checked;
    const Circle circle = inflection_circle(s.pole);
    EXPECT_NEAR(norm(*ball - circle.centre), circle.radius, 1e-12);
    EXPECT_NEAR(cubic->value(*ball), 0, 1e-12);
    const Vec2d local = in_body(s.motion, *ball);
    const Quad h("1e-8");
    EXPECT_NEAR(static_cast<double>(curvature_of(s.near(Quad(0)), local)), 0, 1e-11 / (r * r));
    const Quad change = curvature_of(s.near(h), local) - curvature_of(s.near(-h), local);
    const double size = norm(s.pole.rate) + norm(s.pole.second);
    EXPECT_NEAR(static_cast<double>(change / (2 * h)), 0,
                1e-10 * (1 + size) * std::abs(s.pole.turn) / std::pow(std::min(1.0, r), 4));
  });
  EXPECT_GT(checked, 100);
}

// ---- Known motions.

/// A wheel of radius R that rolls along the x axis, by the angle q that it has turned clockwise.
Body rolling_wheel(double radius, double q) {
  return {unit_vector(-q), {Vec2d{radius * q, radius}, {radius, 0}, {0, 0}, {0, 0}}, {-1, 0, 0}};
}

TEST(KnownMotions, AWheelRollsOnItsRim) {
  const double R = 2;
  const Body wheel = rolling_wheel(R, 0.4);
  const auto contact = pole(wheel);
  ASSERT_TRUE(contact);
  EXPECT_LT(norm(contact->at - Vec2d{R * 0.4, 0}), 1e-15);
  EXPECT_EQ(pole_velocity(*contact), (Vec2d{R, 0}));
  // Against the sense of φ the pole runs along −x; the rim then bends to the right.
  EXPECT_EQ(*fixed_centrode(*contact).curvature, 0);
  EXPECT_DOUBLE_EQ(*moving_centrode(wheel, *contact).curvature, -1 / R);
  // The inflection circle reaches from the ground to the hub, which is Ball's point.
  const Vec2d hub = wheel.origin[0];
  EXPECT_LT(norm(inflection_pole(*contact) - hub), 1e-15);
  EXPECT_LT(norm(*ball_point(*circling_points(*contact)) - hub), 1e-15);
  // A cycloid's radius of curvature is twice the chord from the ground.
  const Vec2d top = hub + Vec2d{0, R};
  EXPECT_LT(norm(*conjugate_centre(*contact, top) - (top - Vec2d{0, 4 * R})), 1e-14);
  // Where the rim touches the ground its point stands in a cusp.
  const auto cusp = point_motion(wheel, in_body(wheel, contact->at));
  EXPECT_LT(norm(cusp[1]), 1e-15);
  EXPECT_FALSE(conjugate_centre(*contact, contact->at));
}

TEST(KnownMotions, OfCardansCirclesTheInnerIsTheInflectionCircle) {
  const EllipticTrammel trammel{.centre = {0.3, -0.2}, .length = 1.7, .second_line = {-0.6, 0.8}};
  const auto circles = cardan_circles(trammel);
  MechanismMotion<3> motion(as_mechanism(trammel));
  for (const double angle : {0.1, 1.2, 2.7, -2.0}) {
    ASSERT_TRUE(motion.move_to(angle));
    const Body& link = motion.bodies()[1];
    const auto at = pole(link);
    ASSERT_TRUE(at);
    EXPECT_NEAR(norm(at->at - trammel.centre), circles.fixed_radius, 1e-14);
    EXPECT_NEAR(*fixed_centrode(*at).curvature, -1 / circles.fixed_radius, 1e-14);
    EXPECT_NEAR(*moving_centrode(link, *at).curvature, -1 / circles.moving_radius, 1e-14);
    const Circle inflections = inflection_circle(*at);
    EXPECT_LT(norm(in_body(link, inflections.centre) - circles.moving_centre), 1e-14);
    EXPECT_NEAR(inflections.radius, circles.moving_radius, 1e-14);
    // All of its points move straight for good: the curve is this circle and the pole normal.
    const auto cubic = circling_points(*at);
    EXPECT_NEAR(cubic->inverse_n, 0, 1e-14);
    EXPECT_NEAR(cubic->inverse_m * cubic->diameter, 1, 1e-14);
    EXPECT_FALSE(ball_point(*cubic));
    EXPECT_NEAR(cubic->value(inflections.centre + inflections.radius * unit_vector(2)), 0, 1e-14);
    EXPECT_NEAR(cubic->value(at->at + 5 * cubic->axis * Vec2d{0, 1}), 0, 1e-13);
  }
}

TEST(KnownMotions, WithParallelCranksTheStraightPointsLieOnALine) {
  // Wang, Zhu, Liao & Yang 2007: cranks a and c along y, the coupler b at φ from x; on the line BC
  // the path is straight at x = b cos φ · c/(c ∓ a) from B.
  const double a = 1, b = 1.2, c = 1.6, phi = 0.35;
  int found = 0;
  for (const double side : {1.0, -1.0}) {
    const Vec2d pin{0, a};
    const Vec2d end = pin + b * unit_vector(phi);
    const Vec2d pivot_d = end - Vec2d{0, side * c};
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      const FourBar linkage{{0, 0}, pivot_d, a, b, c, assembly, {}};
      MechanismMotion<3> motion(as_mechanism(linkage));
      // The direction (0, 1) itself, which no double of an angle gives.
      ASSERT_TRUE(motion.move_to(DrivePosition<double>{{0, 1}, 0}));
      const Body& coupler = motion.bodies()[2];
      if (norm(coupler.direction - unit_vector(phi)) > 1e-9) continue;
      EXPECT_EQ(instant_motion(coupler), InstantMotion::translation);
      EXPECT_FALSE(pole(coupler));
      const auto line = inflection_line(coupler);
      ASSERT_TRUE(line);
      EXPECT_NEAR(line->through.x, b * std::cos(phi) * c / (c - side * a), 1e-12);
      EXPECT_NEAR(line->direction.x, 0, 1e-15);
      const Vec2d on_line = line->through + 0.7 * line->direction;
      EXPECT_NEAR(*curvature(point_motion(coupler, in_body(coupler, on_line))), 0, 1e-12);
      ++found;
    }
  }
  EXPECT_EQ(found, 2);
}

TEST(KnownMotions, WhatHasNoPoleIsNamed) {
  // A crank turns about a pivot for good: no inflection circle, no tangent, no circling points.
  MechanismMotion<3> four_bar(as_mechanism(FourBar{{0, 0}, {4, 0}, 1, 3.5, 2.5}));
  ASSERT_TRUE(four_bar.move_to(0.6));
  const auto pivot = pole(four_bar.bodies()[1]);
  ASSERT_TRUE(pivot);
  EXPECT_LT(norm(pivot->at), 1e-15);
  const Pole exact{.at = {}, .rate = {}, .second = {}, .turn = 1, .spin = 0};
  EXPECT_EQ(inflection_circle(exact).radius, 0);
  EXPECT_FALSE(fixed_centrode(exact).tangent || fixed_centrode(exact).curvature);
  EXPECT_FALSE(circling_points(exact));
  EXPECT_EQ(*conjugate_centre(exact, {3, 1}), (Vec2d{0, 0}));
  // A slider has no pole; at its limit it rests.
  MechanismMotion<3> slider(as_mechanism(SliderCrank{.pivot = {}, .crank = 1, .coupler = 3}));
  ASSERT_TRUE(slider.move_to(1));
  EXPECT_EQ(instant_motion(slider.bodies()[3]), InstantMotion::translation);
  EXPECT_FALSE(inflection_line(slider.bodies()[3]));
  ASSERT_TRUE(slider.move_to(0));
  EXPECT_EQ(instant_motion(slider.bodies()[3]), InstantMotion::rest);
  const auto at_rest = point_motion(slider.bodies()[3], {0, 0});
  EXPECT_FALSE(curvature(at_rest) || curvature_rate(at_rest) || centre_of_curvature(at_rest));
  // The coupler of a parallelogram never turns.
  MechanismMotion<3> parallelogram(as_mechanism(FourBar{{0, 0}, {3, 0}, 1, 3, 1}));
  ASSERT_TRUE(parallelogram.move_to(0.9));
  const Body& coupler = parallelogram.bodies()[2];
  EXPECT_EQ(instant_motion(coupler), InstantMotion::translation);
  EXPECT_FALSE(inflection_line(coupler));
  EXPECT_NEAR(std::abs(*curvature(point_motion(coupler, {1, 1}))), 1, 1e-14);
}

}  // namespace
}  // namespace cognate::pole_geometry_test
