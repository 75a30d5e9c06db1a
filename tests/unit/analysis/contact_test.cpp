/// Contact of coupler paths with straight lines, held against positions in 113 bits, the theory of
/// the pole and closed forms of parallel cranks.
#include "analysis/coupler_curve/contact.hpp"

#include <gtest/gtest.h>

#include <random>

#include "analysis/coupler_curve/parallel_cranks.hpp"
#include "analysis/coupler_curve/stationary_curvature.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/straight_line/contact_search.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::synthesis::contact_test {
namespace {

using test::Quad;
constexpr double pi = kPi;

Mechanism<double> mechanism_of(const CouplerLinkage& linkage) {
  return std::visit([](const auto& any) { return as_mechanism(any); }, linkage);
}

/// The point (u, v) of the coupler by the crank's angle, in 113 bits.
class QuadPath {
 public:
  QuadPath(const CouplerLinkage& linkage, double at, const Vec2d& point)
      : motion_(mechanism_of(linkage)), at_(at), point_(test::quad(point)) {
    const auto here = point_motion((*motion_.at(at_))[2], point_);
    origin_ = here[0];
    tangent_ = (1 / sqrt(squared_norm(here[1]))) * here[1];
  }

  /// (x, y) along and across the tangent, for a crank turned on by `step`.
  Vec2<Quad> at(const Quad& step) {
    const auto p = point_motion((*motion_.at(at_ + step))[2], point_);
    return conj(tangent_) * (p[0] - origin_);
  }

 private:
  test::QuadMotion motion_;
  Quad at_;
  Vec2<Quad> point_;
  Vec2<Quad> origin_, tangent_;
};

/// Whether the deviation from the tangent goes as `contact` says: y/size = coefficient·(x/size)ᵏ.
void expect_contact(const CouplerLinkage& linkage, double at, const StraightPoint& point,
                    double size) {
  QuadPath path(linkage, at, point.coupler_point);
  const Quad step("1e-4");
  const Vec2<Quad> before = path.at(-step), after = path.at(step);
  const auto measured = [&](const Vec2<Quad>& p) {
    return static_cast<double>(p.y / size / pow(p.x / size, point.contact.points));
  };
  // The mean of both sides, so that the next order falls out. Up to sense of the tangent.
  const bool even = point.contact.points % 2 == 0;
  const double mean = 0.5 * (measured(before) + measured(after));
  const double expected = point.contact.coefficient;
  EXPECT_NEAR(even ? std::abs(mean) : mean, even ? std::abs(expected) : expected,
              1e-4 * std::abs(expected))
      << "contact of " << point.contact.points << " at " << at;
}

FourBar random_four_bar(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.3, 1.3);
  const Vec2d a = test::random_point(random), d = test::random_point(random);
  const Assembly side = random() % 2 == 0 ? Assembly::open : Assembly::crossed;
  return {a, d, length(random), length(random), length(random), side, {}};
}

bool is_gentle(const StraightPoint& point, double size) {
  // What changes over the step of the differences would blow up their error.
  return norm(point.coupler_point) < 5 * size && std::abs(point.contact.coefficient) > 1e-3 &&
         std::abs(point.contact.coefficient) < 20;
}

TEST(StraightPoints, OfRandomPositionsTouchAsTheySay) {
  int tested = 0;
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> angle(-3, 3), length(0.3, 1.3);
  int checked[5] = {};
  for (int i = 0; i < 400; ++i) {
    CouplerLinkage linkage = random_four_bar(random);
    if (i % 3 == 0) {
      linkage = SliderCrank{test::random_point(random), length(random), length(random), 0.3,
                            test::random_direction(random)};
    }
    const double at = angle(random);
    const auto position = coupler_position(linkage, at);
    if (!position || std::abs(position->series.crank_rate) < 0.1) continue;
    for (const StraightPoint& point : straight_points(linkage, at, 3).points) {
      EXPECT_LT(point.contact.residual, 1e-13);
      if (!is_gentle(point, position->size)) continue;
      ++tested;
      expect_contact(linkage, at, point, position->size);
      ++checked[point.contact.points];
    }
  }
  EXPECT_GT(checked[3], 200);
  EXPECT_GT(checked[4], 50);
  EXPECT_GE(tested, 440);
}

TEST(StraightPoints, FivePointPositionsTouchAsTheySay) {
  std::mt19937_64 random(32);
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const FourBar linkage = random_four_bar(random);
    for (const auto& found : straight_positions(linkage, 5)) {
      const auto position = coupler_position(linkage, found.crank_angle);
      ASSERT_TRUE(position);
      EXPECT_GE(found.point.contact.points, 5);
      EXPECT_LT(found.point.contact.residual, 1e-11);
      if (!is_gentle(found.point, position->size) || found.point.condition > 100) continue;
      if (std::abs(position->series.crank_rate) < 0.1) continue;
      expect_contact(linkage, found.crank_angle, found.point, position->size);
      ++checked;
    }
  }
  EXPECT_GT(checked, 30);
}

TEST(FourPointContact, IsBallsPointByThePole) {
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> angle(-3, 3);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const FourBar linkage = random_four_bar(random);
    const double at = angle(random);
    const auto position = coupler_position(linkage, at);
    MechanismMotion<3> motion(as_mechanism(linkage));
    if (!position || !motion.move_to(at)) continue;
    const auto found_pole = pole(motion.bodies()[2]);
    const auto cubic = found_pole ? circling_points(*found_pole) : std::nullopt;
    const auto expected = cubic ? ball_point(*cubic) : std::nullopt;
    const auto four = four_point_contact(position->series, position->size);
    const auto ball = finite(four.ball, 10);
    if (!expected || !ball) continue;
    const Vec2d pin = motion.bodies()[2].origin[0];
    const double size = 1 + norm(*ball) + norm(found_pole->at) + norm(found_pole->rate);
    EXPECT_LT(norm(pin + *ball - *expected), 1e-10 * size * size) << i;
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

ParallelCranks random_parallel(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.4, 2), angle(-1.2, 1.2);
  return {length(random), length(random), length(random), angle(random),
          random() % 2 == 0 ? CrankSides::same : CrankSides::opposite};
}

TEST(ParallelCranks, ClosedFormsAreTheLocalTheory) {
  int tested = 0;
  std::mt19937_64 random(34);
  for (int i = 0; i < 200; ++i) {
    const ParallelCranks cranks = random_parallel(random);
    const auto x = inflection_line_x(cranks);
    ASSERT_TRUE(x);
    if (std::abs(*x) > 20) continue;
    ++tested;
    const auto position = coupler_position(*four_bar(cranks), 0.5 * pi);
    ASSERT_TRUE(position) << i;
    const CircleOrLine locus = contact_locus(position->series, 2);
    const auto line = as_line(locus, position->size);
    ASSERT_TRUE(line) << i;
    EXPECT_NEAR(line->through.x, *x, 1e-13 * (1 + std::abs(*x)));
    EXPECT_NEAR(line->direction.x, 0, 1e-13);
    const Vec2d on_bc = *coupler_line_point(cranks);
    EXPECT_LT(norm(*constructed_point(cranks) - on_bc), 1e-12 * (1 + norm(on_bc)));
    EXPECT_NEAR(value(locus, on_bc), 0, 1e-13 * norm(locus.linear) * (1 + norm(on_bc)));
    // κ = 2 P₁ × P₂/|P₁|³ of any point, positive to the left of a motion along +x.
    const Vec2d z{1.7, -0.4};
    const auto path = path_series(position->series, z);
    const double speed = norm(path[1]), sense = path[1].x > 0 ? 1 : -1;
    EXPECT_NEAR(sense * 2 * cross(path[1], path[2]) / (speed * speed * speed),
                path_curvature(cranks, z.x), 1e-12 * (1 + std::abs(path_curvature(cranks, z.x))));
    // On the line dκ/ds = 6 P₁ × P₃/|P₁|⁴, and no Ball's point.
    const auto at_line = path_series(position->series, on_bc);
    const double square = squared_norm(at_line[1]);
    const double rate = 6 * cross(at_line[1], at_line[3]) / (square * square);
    EXPECT_NEAR(rate, curvature_rate(cranks), 1e-11 * (1 + std::abs(rate)));
    EXPECT_EQ(straight_points(*position, 4).why, NoStraightPoint::at_infinity) << i;
  }
  EXPECT_GE(tested, 170);
}

TEST(ParallelCranks, AcrossOnePointHasFivePointContact) {
  int tested = 0;
  std::mt19937_64 random(35);
  for (int i = 0; i < 100; ++i) {
    ParallelCranks cranks = random_parallel(random);
    cranks.coupler_angle = 0;
    const Vec2d expected = *five_point_contact(cranks);
    if (norm(expected) > 50) continue;
    ++tested;
    const auto found = straight_points(*four_bar(cranks), 0.5 * pi, 5);
    ASSERT_EQ(found.points.size(), 1U) << i;
    EXPECT_LT(norm(found.points[0].coupler_point - expected), 1e-12 * (1 + norm(expected)));
    EXPECT_EQ(found.points[0].contact.points, 5);
    // Every point of the line has four.
    const auto position = coupler_position(*four_bar(cranks), 0.5 * pi);
    const Vec2d other{expected.x, 0.3};
    EXPECT_EQ(contact(position->series, other, position->size).points, 4);
    // Turned a little, Ball's point comes from there.
    const auto near = coupler_position(*four_bar(cranks), 0.5 * pi + 1e-5);
    const auto ball = finite(four_point_contact(near->series, near->size).ball, 1e3);
    ASSERT_TRUE(ball);
    EXPECT_LT(norm(*ball - expected), 0.1 * (1 + squared_norm(expected)));
  }
  EXPECT_GE(tested, 77);
}

TEST(ParallelCranks, InflectionLocusPassesSmoothlyIntoALine) {
  int tested = 0;
  std::mt19937_64 random(36);
  for (int i = 0; i < 50; ++i) {
    const ParallelCranks cranks = random_parallel(random);
    const FourBar linkage = *four_bar(cranks);
    const double expected = norm(*coupler_line_point(cranks));
    if (expected > 5) continue;
    ++tested;
    const double direction = *inflection_line_x(cranks) > 0 ? 1 : -1;
    double before = 0;
    for (const double turn : {1e-3, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15}) {
      const auto position = coupler_position(linkage, 0.5 * pi + turn);
      ASSERT_TRUE(position);
      const CircleOrLine locus = contact_locus(position->series, 2);
      double error = 1e9;
      for (const auto& t : meet(locus, {}, position->series.direction[0])) {
        if (t) error = std::min(error, std::abs(direction * *t - expected));
      }
      EXPECT_LT(error, 300 * turn + 1e-13) << i << " at " << turn;
      if (turn == 1e-4) {
        EXPECT_LT(error, 0.2 * before + 1e-12);
      }
      before = error;
    }
  }
  EXPECT_GE(tested, 40);
}

TEST(StraightPoints, DoNotDependOnUnitOrPlace) {
  const FourBar plain{{0, 0}, {4, 0}, 1.3, 3.1, 2.7, Assembly::open, {}};
  const auto expected = straight_points(plain, 1, 4);
  ASSERT_EQ(expected.points.size(), 1U);
  for (const double unit : {1e-12, 1e-3, 1e12}) {
    const Vec2d shift = (1e3 * unit) * Vec2d{0.6, 0.8};
    const FourBar scaled{
        shift,       shift + Vec2d{4 * unit, 0}, 1.3 * unit, 3.1 * unit, 2.7 * unit, Assembly::open,
        std::nullopt};
    const auto found = straight_points(scaled, 1, 4);
    ASSERT_EQ(found.points.size(), 1U) << unit;
    const Vec2d point = (1 / unit) * found.points[0].coupler_point;
    EXPECT_LT(norm(point - expected.points[0].coupler_point), 1e-11) << unit;
  }
}

TEST(StraightPoints, DegeneratePositionsAreNamed) {
  const FourBar parallelogram{{0, 0}, {3, 0}, 1, 3, 1, Assembly::open, {}};
  EXPECT_EQ(straight_points(parallelogram, 0.9, 3).why, NoStraightPoint::parallel_motion);
  EXPECT_EQ(straight_points(parallelogram, 0, 4).why, NoStraightPoint::change_point);
  const FourBar short_links{{0, 0}, {9, 0}, 1, 3, 2, Assembly::open, {}};
  EXPECT_EQ(straight_points(short_links, 0, 4).why, NoStraightPoint::not_closed);
  const SliderCrank slider{.pivot = {}, .crank = 2, .coupler = 3};
  EXPECT_EQ(straight_points(slider, 0.9, 4).why, NoStraightPoint::at_slider);
  EXPECT_EQ(straight_points(slider, 0.9, 3).points.size(), 2U);
  // In a limit position the slider's pin is the pole: Evans' point, BC² = AB·BP.
  const auto limit = straight_points(slider, 0, 4);
  ASSERT_FALSE(limit.points.empty());
  EXPECT_LT(norm(limit.points[0].coupler_point - Vec2d{-4.5, 0}), 1e-13);
}

/// By trigonometry alone, in the slide's axes: how far a point at the height h over the slider's
/// pin comes down where the crank has turned by δ from across the slide.
double fall_of(const SliderCrank& slider, double side, double height, double turned) {
  const auto sine = [&](double turn) {
    return (slider.offset - side * slider.crank * std::cos(turn)) / slider.coupler;
  };
  return height * (1 - std::cos(std::asin(sine(turned)) - std::asin(sine(0))));
}

// Crank across the slide line: the pole is at infinity, the inflection circle the line through the
// slider's pin across the slide, and all of it has contact of four points.
TEST(StraightPoints, SliderCrankWithItsPoleAtInfinity) {
  int tested = 0;
  std::mt19937_64 random(37);
  std::uniform_real_distribution<double> length(0.3, 1.3), share(-0.9, 0.9), height(-2, 2);
  for (int i = 0; i < 200; ++i) {
    const double side = random() % 2 == 0 ? 1 : -1, slide = 3 * share(random);
    SliderCrank slider{test::random_point(random), length(random), length(random), 0,
                       unit_vector(slide)};
    slider.offset = side * slider.crank + share(random) * slider.coupler;
    slider.assembly = random() % 2 == 0 ? Assembly::open : Assembly::crossed;
    const double at = slide + side * 0.5 * pi;
    const auto position = coupler_position(slider, at);
    ASSERT_TRUE(position) << i;
    const Vec2d along = slider.direction, across = perp(along), pin = *position->slider;
    const auto line = as_line(contact_locus(position->series, 2), position->size);
    ASSERT_TRUE(line) << i;
    EXPECT_NEAR(cross(line->direction, across), 0, 1e-11) << i;
    EXPECT_NEAR(dot(line->through - pin, along), 0, 1e-11) << i;

    const double h = height(random);
    if (std::abs(h) < 0.05) continue;
    const Contact on_line = contact(position->series, pin + h * across, position->size);
    EXPECT_EQ(on_line.points, 4) << i;
    constexpr double kTurn4 = 1e-2;
    const double coupler = (slider.offset - side * slider.crank) / slider.coupler;
    const double rate = slider.crank / (2 * slider.coupler * std::sqrt(1 - coupler * coupler));
    const double fall = fall_of(slider, side, h, kTurn4) / std::pow(kTurn4, 4);
    EXPECT_NEAR(fall, 0.5 * h * rate * rate, 1e-2 * std::abs(fall)) << i;

    for (const int wanted : {3, 4}) {
      const auto found = straight_points(slider, at, wanted);
      EXPECT_EQ(found.why, NoStraightPoint::none) << i;
      ASSERT_EQ(found.points.size(), 1U) << i;
      EXPECT_EQ(found.points[0].kind, StraightPointKind::inflection_line);
      EXPECT_EQ(found.points[0].contact.points, 4);
      const Vec2d level = position->series.direction[0] * found.points[0].coupler_point;
      EXPECT_NEAR(dot(level, across), 0, 1e-11) << i;
      EXPECT_NEAR(dot(level - pin, along), 0, 1e-11) << i;
    }
    EXPECT_TRUE(straight_points(slider, at, 5).points.empty()) << i;
    // A little beside it Ball's point is the pin again.
    EXPECT_EQ(straight_points(slider, at + 1e-3, 4).why, NoStraightPoint::at_slider) << i;
    // Both the position and its opposite, where they can be reached, are found without an angle.
    const auto all = straight_positions(slider, 4);
    const auto here = [&](const StraightLineSolution& one) {
      return std::abs(std::sin(0.5 * (one.crank_angle - at))) < 1e-9;
    };
    EXPECT_EQ(std::ranges::count_if(all, here), 1) << i;
    ++tested;
  }
  EXPECT_GT(tested, 170);
}

// The crank's pin on the slide line: the point level with it is the slider's pin, another is taken.
TEST(StraightPoints, SliderCrankWithItsPinsOnTheSlideLine) {
  const SliderCrank slider{.pivot = {}, .crank = 1, .coupler = 3, .offset = 1};
  const auto found = straight_points(slider, 0.5 * pi, 4);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].contact.points, 4);
  EXPECT_NEAR(found.points[0].coupler_point.x, 3, 1e-12);
  EXPECT_NEAR(std::abs(found.points[0].coupler_point.y), 3, 1e-12);
}

TEST(StraightPoints, EllipticMotionHasExactLines) {
  const SliderCrank scott_russell{.pivot = {}, .crank = 2, .coupler = 2};
  const auto found = straight_points(scott_russell, 0.8, 3);
  ASSERT_FALSE(found.points.empty());
  EXPECT_LT(norm(found.points[0].coupler_point - Vec2d{-2, 0}), 1e-13);
  for (const auto& point : found.points) EXPECT_EQ(point.contact.points, kContactOrder + 1);
}

TEST(ContactSearch, FindsTheClassicalLengths) {
  const FourBar hoeken{{0, 0}, {1, 0}, 1, 4, 4, Assembly::open, {}};
  const auto frames = straight_lengths(hoeken, &Lengths<double>::frame, pi);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_NEAR(lengths(std::get<FourBar>(frames[0].linkage)).frame, 3, 1e-8);
  EXPECT_EQ(frames[0].point.contact.points, 6);
  const auto arms = symmetric_lengths(0, 2, 6, Assembly::crossed, &Lengths<double>::crank);
  ASSERT_EQ(arms.size(), 1U);
  EXPECT_NEAR(std::get<FourBar>(arms[0].linkage).crank, 8, 1e-12);
  EXPECT_LT(norm(arms[0].point.coupler_point - Vec2d{1, 0}), 1e-12);
}

}  // namespace
}  // namespace cognate::synthesis::contact_test
