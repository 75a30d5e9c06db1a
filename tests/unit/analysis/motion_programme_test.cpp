// A follower's motion over the whole turn: jumps, strokes and extremes that are known in closed
// form.
#include "analysis/cam/motion_programme.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/cam/piece_bounds.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/count_allocations.hpp"

namespace cognate::cam::motion_programme_test {
namespace {

const double kPi = std::acos(-1.0);

double degrees(double angle) {
  return angle * kPi / 180;
}

MotionSegment segment_of(MotionLaw law, double over, double rise = 0) {
  MotionSegment segment;
  segment.law = law;
  segment.over = over;
  segment.rise = rise;
  return segment;
}

MotionProgramme programme(const std::vector<MotionSegment>& segments) {
  const auto found = programme_of(segments);
  EXPECT_TRUE(found);
  return found.value_or(MotionProgramme());
}

/// Li & Xu's example: up 60 over 100° with constant acceleration, a dwell, down over 90° with
/// harmonic motion, a dwell.
std::vector<MotionSegment> example() {
  return {segment_of(MotionLaw::constant_acceleration, degrees(100), 60),
          segment_of(MotionLaw::dwell, degrees(60)),
          segment_of(MotionLaw::harmonic, degrees(90), -60),
          segment_of(MotionLaw::dwell, degrees(110))};
}

TEST(MotionProgramme, JumpsAreThoseOfTheLaws) {
  const auto found = jumps(programme(example()));
  const double up = 4 * 60 / std::pow(degrees(100), 2),
               down = kPi * kRightAngle * 60 / std::pow(degrees(90), 2);
  const std::vector<Jump> wanted{{0, 2, 0, up},
                                 {degrees(50), 2, up, -up},
                                 {degrees(100), 2, -up, 0},
                                 {degrees(160), 2, 0, -down},
                                 {degrees(250), 2, down, 0}};
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(found[i].angle, wanted[i].angle, 1e-14);
    EXPECT_EQ(found[i].order, wanted[i].order);
    EXPECT_NEAR(found[i].before, wanted[i].before, 1e-12 * up);
    EXPECT_NEAR(found[i].after, wanted[i].after, 1e-12 * up);
  }
}

TEST(MotionProgramme, JumpsOfVelocityAndWhatIsMissingAtTheEnd) {
  const auto found = jumps(programme({segment_of(MotionLaw::constant_velocity, kPi, 5),
                                      segment_of(MotionLaw::cycloidal, kPi, -4)}));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].order, 0);  // the return ends 1 above the rise's begin
  EXPECT_EQ(found[0].before, 1);
  EXPECT_EQ(found[0].after, 0);
  EXPECT_EQ(found[1].order, 1);
  EXPECT_NEAR(found[1].after, 5 / kPi, 1e-15);
  EXPECT_EQ(found[2].order, 1);
  EXPECT_NEAR(found[2].angle, kPi, 1e-15);
  EXPECT_NEAR(found[2].before, 5 / kPi, 1e-15);
}

/// Laws that handbooks call free of jumps; the double harmonic needs its return at once.
TEST(MotionProgramme, SmoothLawsHaveNoJumps) {
  for (const MotionLaw law :
       {MotionLaw::cycloidal, MotionLaw::polynomial_345, MotionLaw::polynomial_4567,
        MotionLaw::modified_sine, MotionLaw::modified_trapezoid,
        MotionLaw::modified_constant_velocity}) {
    std::vector<MotionSegment> segments = example();
    segments[0].law = segments[2].law = law;
    EXPECT_TRUE(jumps(programme(segments)).empty()) << static_cast<int>(law);
  }
  std::vector<MotionSegment> harmonic{segment_of(MotionLaw::double_harmonic, degrees(120), 7),
                                      segment_of(MotionLaw::double_harmonic, degrees(120), -7),
                                      segment_of(MotionLaw::dwell, degrees(120))};
  EXPECT_TRUE(jumps(programme(harmonic)).empty());
  std::swap(harmonic[1], harmonic[2]);
  EXPECT_EQ(jumps(programme(harmonic)).size(), 2U);
  EXPECT_TRUE(jumps(programme({segment_of(MotionLaw::dwell, kTurn)})).empty());
}

TEST(MotionProgramme, StrokesOfMonotoneLawsAreWholePieces) {
  const MotionProgramme motion = programme(example());
  const std::vector<Stroke> wanted{Stroke::rise, Stroke::rise, Stroke::dwell, Stroke::fall,
                                   Stroke::dwell};
  ASSERT_EQ(motion.stroke_parts().size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const StrokePart& part = motion.stroke_parts()[i];
    EXPECT_EQ(part.stroke, wanted[i]);
    EXPECT_EQ(part.piece, static_cast<int>(i));
    EXPECT_EQ(part.from, 0);
    EXPECT_EQ(part.to, 1);
  }
  EXPECT_EQ(motion.lowest(), 0);
  EXPECT_EQ(motion.highest(), 60);
  for (int law = 1; law <= static_cast<int>(MotionLaw::double_harmonic); ++law) {
    for (const double rise : {3.0, -3.0}) {
      const auto parts =
          programme({segment_of(static_cast<MotionLaw>(law), 1, rise)}).stroke_parts();
      for (const StrokePart& part : parts) {
        EXPECT_EQ(part.stroke, rise > 0 ? Stroke::rise : Stroke::fall) << law;
        EXPECT_EQ(part.from, 0) << law;
        EXPECT_EQ(part.to, 1) << law;
      }
    }
  }
}

/// A polynomial whose velocity is u² (u − 0.3)(u − 0.8) · const: it turns at 0.3 and 0.8 and rests
/// at its begin.
TEST(MotionProgramme, PolynomialsAreCutWhereTheyTurn) {
  const auto displacement = [](double u) {
    return 60 * (std::pow(u, 5) / 5 - 1.1 * std::pow(u, 4) / 4 + 0.24 * std::pow(u, 3) / 3);
  };
  MotionSegment segment = segment_of(MotionLaw::polynomial, 2, displacement(1));
  segment.conditions = {{0, 1, 0}, {0, 2, 0}, {0.3, 0, displacement(0.3)}, {0.3, 1, 0}};
  const MotionProgramme motion =
      programme({segment, segment_of(MotionLaw::cycloidal, kTurn - 2, -displacement(1))});
  const auto& parts = motion.stroke_parts();
  ASSERT_EQ(parts.size(), 4U);
  const std::vector<StrokePart> wanted{
      {0, 0, 0.3, Stroke::rise},
      {0, 0.3, 0.8, Stroke::fall},
      {0, 0.8, 1, Stroke::rise},
      {1, 0, 1, displacement(1) > 0 ? Stroke::fall : Stroke::rise}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(parts[i].piece, wanted[i].piece);
    EXPECT_NEAR(parts[i].from, wanted[i].from, 1e-13);
    EXPECT_NEAR(parts[i].to, wanted[i].to, 1e-13);
    EXPECT_EQ(parts[i].stroke, wanted[i].stroke);
  }
  EXPECT_NEAR(motion.lowest(), displacement(0.8), 1e-14);
  EXPECT_NEAR(motion.highest(), std::max(displacement(0.3), displacement(1)), 1e-14);
}

/// Velocities (u − a)² (b − u): the follower only pauses at a, and turns at b.
TEST(MotionProgramme, WhereTheVelocityTouchesZeroThereIsNoTurn) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.05, 0.45);
  for (int trial = 0; trial < 300; ++trial) {
    const double a = share(random), b = 0.5 + share(random);
    const auto displacement = [&](double u) {
      return u * (a * a * b - u * ((a * a + 2 * a * b) / 2 - u * ((2 * a + b) / 3 - u / 4)));
    };
    MotionSegment segment = segment_of(MotionLaw::polynomial, 1, displacement(1));
    segment.conditions = {{a, 1, 0}, {a, 2, 0}, {b, 1, 0}};
    const MotionProgramme motion = programme({segment});
    const auto& parts = motion.stroke_parts();
    ASSERT_EQ(parts.size(), 2U) << trial;
    EXPECT_EQ(parts[0].stroke, Stroke::rise);
    EXPECT_EQ(parts[1].stroke, Stroke::fall);
    EXPECT_EQ(parts[0].from, 0);
    EXPECT_NEAR(parts[0].to, b, 1e-12);
    EXPECT_EQ(parts[1].from, parts[0].to);
    EXPECT_EQ(parts[1].to, 1);
  }
}

TEST(MotionProgramme, AnglesOfAnyTurn) {
  const MotionProgramme motion = programme(example());
  EXPECT_EQ(motion.at(0).displacement, 0);
  EXPECT_EQ(motion.at(degrees(130)).displacement, 60);
  EXPECT_NEAR(motion.at(degrees(25)).displacement, 2 * 60 / 16.0, 1e-13);
  EXPECT_NEAR(motion.at(degrees(205)).displacement, 30, 1e-13);
  EXPECT_NEAR(motion.at(degrees(25 - 720)).velocity, motion.at(degrees(25)).velocity, 1e-12);
  EXPECT_NEAR(motion.at(degrees(205 + 3600)).velocity, motion.at(degrees(205)).velocity, 1e-12);
  EXPECT_EQ(motion.at(-1e-300).displacement, 0);
  EXPECT_EQ(motion.at(std::nextafter(kTurn, 0)).displacement, 0);
  EXPECT_GT(motion.at(0).acceleration, 0);  // of the later piece at a border
  EXPECT_GT(motion.at(kTurn).acceleration, 0);
  EXPECT_EQ(MotionProgramme().at(1).displacement, 0);
}

TEST(MotionProgramme, SegmentsWithoutASolutionGiveNone) {
  MotionSegment segment = segment_of(MotionLaw::polynomial, 1, 1);
  segment.conditions = {{0.5, 1, 1}};
  EXPECT_FALSE(programme_of({segment}));
}

/// A spline through noise: the strokes alternate in step with the signs of the velocity, and the
/// greatest displacement of all is no less than any found by looking.
TEST(MotionProgramme, ManyPiecesThatTurn) {
  constexpr int kCount = 2000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> noise(-1, 1);
  MotionSegment segment = segment_of(MotionLaw::spline, kTurn);
  segment.ends.periodic = true;
  for (int i = 1; i < kCount; ++i) {
    segment.points.push_back({static_cast<double>(i) / kCount, noise(random)});
  }
  const MotionProgramme motion = programme({segment});
  double lowest = 0, highest = 0;
  for (const StrokePart& part : motion.stroke_parts()) {
    const auto& piece = motion.pieces()[static_cast<std::size_t>(part.piece)];
    const double length = part.to - part.from;
    for (const double share : {0.01, 0.3, 0.5, 0.8, 0.99}) {
      const auto here = motion_at(piece, part.from + share * length);
      EXPECT_EQ(here.velocity > 0, part.stroke == Stroke::rise) << part.piece << ' ' << share;
      lowest = std::min(lowest, here.displacement);
      highest = std::max(highest, here.displacement);
    }
  }
  EXPECT_LE(motion.lowest(), lowest);
  EXPECT_GE(motion.highest(), highest);
  EXPECT_LT(motion.highest(), highest + 1e-3);
}

double derivative_of(const FollowerMotion<double>& motion, int order) {
  return order == 0 ? motion.displacement : order == 1 ? motion.velocity : motion.acceleration;
}

/// Bounds hold everywhere; those of a sinusoid alone, and of a straight line, are
/// attained.
TEST(PieceBounds, HoldAndAreAttained) {
  int tested = 0;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 600; ++trial) {
    MotionPiece<double> piece;
    piece.span = 1 + 0.5 * number(random);
    piece.offset = number(random);
    piece.scale = 3 * number(random);
    piece.sinusoid_count = trial % 3;
    piece.terms = piece.sinusoid_count == 1 ? 0 : trial % 11;
    for (double& coefficient : piece.polynomial) coefficient = number(random);
    for (auto& wave : piece.sinusoids) wave = {number(random), 2 * number(random), number(random)};
    for (int order = 0; order < 3; ++order) {
      const Bounds bounds = bounds_of(piece, order);
      double least = derivative_of(motion_at(piece, 0.0), order), greatest = least;
      for (int i = 1; i <= 2000; ++i) {
        const double value = derivative_of(motion_at(piece, i / 2000.0), order);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
      const double rounding = 1e-13 * (1 + greatest - least) * std::pow(3.0, piece.terms);
      EXPECT_LE(bounds.least, least + rounding) << trial << ' ' << order;
      EXPECT_GE(bounds.greatest, greatest - rounding) << trial << ' ' << order;
      const bool is_exact = piece.terms == 0 ? piece.sinusoid_count < 2
                                             : piece.sinusoid_count == 0 && piece.terms - order < 3;
      if (!is_exact) continue;
      ++tested;
      const double near = 1e-5 * (1 + greatest - least);
      EXPECT_NEAR(bounds.least, least, near) << trial << ' ' << order;
      EXPECT_NEAR(bounds.greatest, greatest, near) << trial << ' ' << order;
    }
  }
  EXPECT_GE(tested, 730);
}

/// The Bernstein coefficients of t³ (1 − t) · 4 are 0, 0, 0, 1, 0.
TEST(PieceBounds, OfAPolynomialAreItsBernsteinCoefficients) {
  MotionPiece<double> piece;
  piece.span = 1;
  piece.terms = 5;  // t = (x + 1)/2: (1 + x)³ (1 − x) / 4
  std::ranges::copy(std::array<double, 5>{0.25, 0.5, 0, -0.5, -0.25}, piece.polynomial.begin());
  const Bounds bounds = bounds_of(piece, 0);
  EXPECT_EQ(bounds.least, 0);
  EXPECT_EQ(bounds.greatest, 1);
}

TEST(MotionProgramme, AskingForTheMotionAllocatesNothing) {
  MotionSegment segment = segment_of(MotionLaw::spline, kTurn);
  segment.ends.periodic = true;
  for (int i = 1; i < 100'000; ++i) {
    const double at = i / 100'000.0;
    segment.points.push_back({at, 1 - std::cos(kTurn * at)});
  }
  const MotionProgramme motion = programme({segment});
  EXPECT_NEAR(motion.highest(), 2, 1e-14);
  EXPECT_TRUE(jumps(motion).empty());
  const std::size_t before = test::allocations();
  double sum = 0;
  for (int i = 0; i < 1000; ++i) sum += motion.at(0.1 * i).displacement - (1 - std::cos(0.1 * i));
  EXPECT_EQ(test::allocations(), before);
  EXPECT_NEAR(sum, 0, 1e-10);
}

}  // namespace
}  // namespace cognate::cam::motion_programme_test
