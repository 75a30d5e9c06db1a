/// The smallest cams by half planes against closed forms and brute force.
#include "synthesis/exact/cam/smallest_cam.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "analysis/numbers/constants.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::smallest_cam_test {
namespace {

using cam::ArmSide;
using cam::MotionLaw;
using cam::MotionProgramme;
using cam::MotionSegment;
using cam::programme_of;
using synthesis::PressureLimit;
using synthesis::PressureLimits;
using synthesis::smallest_oscillating;
using synthesis::smallest_translating;

constexpr double kFree = std::numeric_limits<double>::infinity();

double draw(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A harmonic rise, a harmonic return, a dwell.
struct HarmonicCam {
  double stroke = 30, rise_over = 120 * kDegree, return_over = 90 * kDegree;

  MotionProgramme programme() const {
    return *programme_of({segment(MotionLaw::harmonic, rise_over / kDegree, stroke),
                          segment(MotionLaw::harmonic, return_over / kDegree, -stroke),
                          segment(MotionLaw::dwell, 360 - (rise_over + return_over) / kDegree)});
  }
  /// The greatest of ±s′ − T s over a stroke: (h/2)(√(ω² + T²) − T), without cancellation.
  double depth(double over, double tangent) const {
    const double rate = kPi / over;
    return 0.5 * stroke * rate * rate / (std::hypot(rate, tangent) + tangent);
  }
  double rise_depth(double tangent) const { return depth(rise_over, tangent); }
  double return_depth(double tangent) const { return depth(return_over, tangent); }
  /// Where they are greatest.
  double rise_place(double tangent) const {
    const double rate = kPi / rise_over;
    return std::atan2(rate, tangent) / rate;
  }
  double return_place(double tangent) const {
    const double rate = kPi / return_over;
    return rise_over + return_over - std::atan2(rate, tangent) / rate;
  }
};

/// The offset and the height of the base circle's centre below the roller.
void expect_cam(const synthesis::SmallestCam& found, double offset, double height, double share) {
  const double base = std::hypot(offset, height);
  EXPECT_NEAR(found.dimensions.base_radius, base, share * base);
  EXPECT_NEAR(found.dimensions.offset, offset, share * base);
}

TEST(SmallestTranslating, HarmonicStrokesGiveTheirVertex) {
  const HarmonicCam made;
  const double up = std::tan(30 * kDegree), down = std::tan(50 * kDegree);
  const double rise = made.rise_depth(up), fall = made.return_depth(down);
  const double height = (rise + fall) / (up + down);
  const auto found = smallest_translating(made.programme(),
                                          {{}, {}, {}, 30 * kDegree, 50 * kDegree}, -kFree, kFree);
  ASSERT_TRUE(found);
  expect_cam(*found, rise - up * height, height, 1e-13);
  ASSERT_EQ(found->binding.size(), 2);
  for (const auto& binding : found->binding) {
    ASSERT_NE(binding.limit, PressureLimit::whole);
    const bool rises = binding.limit == PressureLimit::rise_working;
    EXPECT_NEAR(binding.angle, rises ? made.rise_place(up) : made.return_place(down), 1e-6);
  }
  // One limit at every position is the same limit on either side.
  const auto whole = smallest_translating(made.programme(), {30 * kDegree, {}, {}}, -kFree, kFree);
  const double either = made.return_depth(up);
  ASSERT_TRUE(whole);
  expect_cam(*whole, 0.5 * (rise - either), 0.5 * (rise + either) / up, 1e-13);
  for (const auto& binding : whole->binding) EXPECT_EQ(binding.limit, PressureLimit::whole);
}

TEST(SmallestTranslating, OneHarmonicStrokeGivesItsFoot) {
  const HarmonicCam made;
  const double tangent = std::tan(35 * kDegree);
  for (const bool rises : {true, false}) {
    const double depth = rises ? made.rise_depth(tangent) : made.return_depth(tangent);
    const double share = depth / (1 + tangent * tangent);
    PressureLimits limits;
    (rises ? limits.rise_working : limits.fall_working) = 35 * kDegree;
    const auto found = smallest_translating(made.programme(), limits, -kFree, kFree);
    ASSERT_TRUE(found);
    expect_cam(*found, (rises ? 1 : -1) * share, tangent * share, 1e-13);
    ASSERT_EQ(found->binding.size(), 1);
    EXPECT_NEAR(found->binding[0].angle,
                rises ? made.rise_place(tangent) : made.return_place(tangent), 1e-6);
  }
}

TEST(SmallestTranslating, BoundsOfTheOffsetBind) {
  const HarmonicCam made;
  const double up = std::tan(30 * kDegree), down = std::tan(40 * kDegree);
  const double rise = made.rise_depth(up), fall = made.return_depth(down);
  const PressureLimits both{{}, {}, {}, 30 * kDegree, 40 * kDegree},
      rises{{}, {}, {}, 30 * kDegree, {}};
  const auto height = [&](double offset) {
    return std::max((rise - offset) / up, (fall + offset) / down);
  };
  const double best = rise - up * (rise + fall) / (up + down);
  for (const double offset : {-20.0, -4.0, 0.0, 1e-3, 7.0, 30.0, 300.0}) {
    SCOPED_TRACE(offset);
    const auto given = smallest_translating(made.programme(), both, offset, offset);
    ASSERT_TRUE(given);
    expect_cam(*given, offset, height(offset), 1e-13);
    EXPECT_EQ(given->binding.size(), 1);
    const auto most = smallest_translating(made.programme(), both, -kFree, offset);
    ASSERT_TRUE(most);
    expect_cam(*most, std::min(best, offset), height(std::min(best, offset)), 1e-13);
    const auto least = smallest_translating(made.programme(), both, offset, kFree);
    ASSERT_TRUE(least);
    expect_cam(*least, std::max(best, offset), height(std::max(best, offset)), 1e-13);
  }
  // So far to the side that the rise needs no height: the follower starts beside the centre.
  const auto beside = smallest_translating(made.programme(), rises, 2 * rise, 3 * rise);
  ASSERT_TRUE(beside);
  expect_cam(*beside, 2 * rise, 0, 1e-14);
  EXPECT_TRUE(beside->binding.empty());
}

TEST(SmallestTranslating, ExtremeLimitsKeepTheClosedForm) {
  const HarmonicCam made;
  for (const double limit : {0.001, 0.1, 89.0, 89.9, 89.99}) {
    SCOPED_TRACE(limit);
    const double tangent = std::tan(limit * kDegree);
    const double rise = made.rise_depth(tangent), fall = made.return_depth(tangent);
    const auto given = smallest_translating(made.programme(), {limit * kDegree, {}, {}}, 0, 0);
    ASSERT_TRUE(given);
    expect_cam(*given, 0, std::max(rise, fall) / tangent, 1e-8);
    const auto foot =
        smallest_translating(made.programme(), {{}, {}, {}, limit * kDegree, {}}, -kFree, kFree);
    ASSERT_TRUE(foot);
    const double share = rise / (1 + tangent * tangent);
    expect_cam(*foot, share, tangent * share, 1e-8);
  }
}

// The same half plane comes from each of them.
TEST(SmallestTranslating, EqualLimitsAreOneLimit) {
  const HarmonicCam made;
  for (int degrees = 5; degrees < 85; ++degrees) {
    SCOPED_TRACE(degrees);
    const double limit = degrees * kDegree, tangent = std::tan(limit);
    const double rise = made.rise_depth(tangent), fall = made.return_depth(tangent);
    const auto found = smallest_translating(made.programme(), {limit, limit, limit}, 0, 0);
    ASSERT_TRUE(found);
    expect_cam(*found, 0, std::max(rise, fall) / tangent, 1e-12);
    EXPECT_LE(found->rounds, 3);
  }
}

TEST(SmallestTranslating, LittleStrokeAsksForLittle) {
  const PressureLimits limits{{}, {}, {}, 30 * kDegree, 30 * kDegree};
  const auto still =
      smallest_translating(*programme_of({segment(MotionLaw::dwell, 360)}),
                           {20 * kDegree, 30 * kDegree, 30 * kDegree}, -kFree, kFree);
  ASSERT_TRUE(still);
  EXPECT_EQ(still->dimensions.base_radius, 0);
  EXPECT_TRUE(still->binding.empty());
  for (const double stroke : {1e-12, 1e-100, 1e100}) {
    SCOPED_TRACE(stroke);
    const HarmonicCam made{.stroke = stroke};
    const double tangent = std::tan(30 * kDegree);
    const double rise = made.rise_depth(tangent), fall = made.return_depth(tangent);
    const auto found = smallest_translating(made.programme(), limits, -kFree, kFree);
    ASSERT_TRUE(found);
    expect_cam(*found, 0.5 * (rise - fall), 0.5 * (rise + fall) / tangent, 1e-13);
  }
}

/// A position of the follower and the segment that it is in.
struct Position {
  double s = 0, v = 0;
  bool rises = false, falls = false;
};

/// Positions in each segment, at its ends, and where laws of two to eight parts join.
std::vector<Position> positions_of(const std::vector<MotionSegment>& motion, int each) {
  const MotionProgramme programme = *programme_of(motion);
  std::vector<Position> positions;
  double begin = 0;
  for (const MotionSegment& part : motion) {
    for (int i = 0; i <= each; ++i) {
      const auto m = programme.at(begin + part.over * i / each);
      positions.push_back({m.displacement, m.velocity, part.rise > 0, part.rise < 0});
    }
    begin += part.over;
  }
  return positions;
}

/// Limits on one side, on the other, on both sides or everywhere, between 15° and 60°.
PressureLimits random_limits(std::mt19937_64& random) {
  const auto limit = [&] { return draw(random, 15, 60) * kDegree; };
  PressureLimits limits;
  const auto kind = random() % 6;
  if (random() % 2 == 0) {
    limits.rise_working = limit();
    limits.fall_working = limit();
  }
  if (kind != 1 && kind != 2) limits.rise = limit();
  if (kind != 0 && kind != 2) limits.fall = limit();
  if (kind == 2 || kind == 3) limits.whole = limit();
  return limits;
}

/// The height that the limits ask for at an offset; the pressure angle's tangent is
/// (s′ − e)/(s₀ + s).
double height_for(const std::vector<Position>& positions, const PressureLimits& limits, double e) {
  double height = 0;
  const auto ask = [&](const std::optional<double>& limit, double across, double s) {
    if (limit) height = std::max(height, across / std::tan(*limit) - s);
  };
  for (const Position& at : positions) {
    ask(limits.whole, std::abs(at.v - e), at.s);
    if (at.rises) ask(limits.rise, std::abs(at.v - e), at.s);
    if (at.falls) ask(limits.fall, std::abs(at.v - e), at.s);
    if (at.rises) ask(limits.rise_working, at.v - e, at.s);
    if (at.falls) ask(limits.fall_working, e - at.v, at.s);
  }
  return height;
}

/// The least base radius over a grid of offsets that is drawn ever closer about its best.
double least_base(const std::vector<Position>& positions, const PressureLimits& limits, double low,
                  double high) {
  constexpr int kSteps = 24;
  const auto base = [&](double e) { return std::hypot(e, height_for(positions, limits, e)); };
  const double enough = base(std::clamp(0.0, low, high));
  double from = std::max(low, -enough), to = std::min(high, enough), least = kFree;
  for (int round = 0; round < 6; ++round) {
    const double step = (to - from) / kSteps;
    double best = from;
    for (int i = 0; i <= kSteps; ++i) {
      const double here = base(from + i * step);
      if (here < least) least = here, best = from + i * step;
    }
    from = std::max(from, best - step), to = std::min(to, best + step);
  }
  return least;
}

TEST(SmallestTranslating, RandomMotionsAgreeWithAGrid) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const auto motion = random_motion(random, draw(random, 5, 40));
    const PressureLimits limits = random_limits(random);
    double low = -kFree, high = kFree;
    if (i % 3 == 1) low = draw(random, -20, 10), high = low + draw(random, 0, 20);
    if (i % 3 == 2) low = high = draw(random, -20, 20);
    const auto found = smallest_translating(*programme_of(motion), limits, low, high);
    ASSERT_TRUE(found);
    const double offset = found->dimensions.offset, base = found->dimensions.base_radius;
    EXPECT_GE(offset, low - 1e-13 * base);
    EXPECT_LE(offset, high + 1e-13 * base);
    const auto positions = positions_of(motion, 480);
    EXPECT_GE(base, std::hypot(offset, height_for(positions, limits, offset)) * (1 - 1e-12));
    EXPECT_LE(base, least_base(positions, limits, low, high) * (1 + 1e-4));
  }
}

struct Arm {
  double sigma = 1;  ///< 1: trailing, −1: leading
  double length = 50;
};

/// The tangents of limits.
struct Tangents {
  explicit Tangents(const PressureLimits& limits)
      : whole(of(limits.whole)),
        rise(of(limits.rise)),
        fall(of(limits.fall)),
        rise_working(of(limits.rise_working)),
        fall_working(of(limits.fall_working)) {}
  std::optional<double> whole, rise, fall, rise_working, fall_working;

 private:
  static std::optional<double> of(const std::optional<double>& limit) {
    return limit ? std::optional(std::tan(*limit)) : std::nullopt;
  }
};

/// How far, as a length, a cam centre at `x` breaks the limits, seen from the pivot with the first
/// axis along the arm in its lowest position. The pressure angle's tangent is
/// (l φ′ − σ(a cos ψ − l)) / (a sin ψ), ψ = ψ₀ + φ.
double breach(const std::vector<Position>& positions, const Tangents& limits, const Arm& arm,
              const Vec2d& x) {
  const double a = norm(x), start = std::atan2(x.y, x.x);
  double most = -kFree;
  for (const Position& at : positions) {
    const double psi = start + at.s, along = a * std::sin(psi);
    const double across = arm.length * at.v - arm.sigma * (a * std::cos(psi) - arm.length);
    most = std::max(most, -along);
    if (limits.whole) most = std::max(most, std::abs(across) - *limits.whole * along);
    const auto limit = [&](bool holds, const std::optional<double>& tangent, double side) {
      if (holds && tangent) most = std::max(most, side - *tangent * along);
    };
    limit(at.rises, limits.rise, std::abs(across));
    limit(at.falls, limits.fall, std::abs(across));
    limit(at.rises, limits.rise_working, across);
    limit(at.falls, limits.fall_working, -across);
  }
  return most;
}

/// The least breach on the circle of base radius `base`: over a whole turn, then ever closer about
/// the best.
double least_breach(const std::vector<Position>& positions, const Tangents& limits, const Arm& arm,
                    double base) {
  constexpr int kDirections = 120, kCloser = 8;
  double centre = kPi, half = kPi, least = kFree;
  for (int round = 0; round < 6; ++round) {
    const int steps = round == 0 ? kDirections : kCloser;
    const double from = centre - half, step = 2 * half / steps;
    for (int i = 0; i <= steps; ++i) {
      const double angle = from + i * step;
      const Vec2d x{arm.length + base * std::cos(angle), base * std::sin(angle)};
      const double here = breach(positions, limits, arm, x);
      if (here < least) least = here, centre = angle;
    }
    half = step;
  }
  return least;
}

/// The cam's centre for base radius and centre distance, by the law of cosines.
Vec2d centre_of(const cam::CamDimensions<double>& d) {
  const double a = d.centre_distance, l = d.arm, r = d.base_radius;
  const double x = (a * a + l * l - r * r) / (2 * l);
  return {x, std::sqrt(std::max(0.0, a * a - x * x))};
}

TEST(SmallestOscillating, RandomMotionsAgreeWithAGrid) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const auto side = i % 2 == 0 ? ArmSide::trailing : ArmSide::leading;
    const Arm arm{i % 2 == 0 ? 1.0 : -1.0, draw(random, 10, 100)};
    const auto motion = random_motion(random, draw(random, 2, 25) * kDegree);
    const PressureLimits limits = random_limits(random);
    const Tangents tangents(limits);
    const auto found = smallest_oscillating(*programme_of(motion), limits, side, arm.length);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->dimensions.arm, arm.length);
    const double base = found->dimensions.base_radius;
    EXPECT_LE(breach(positions_of(motion, 240), tangents, arm, centre_of(found->dimensions)),
              1e-10 * (base + arm.length));
    EXPECT_GT(least_breach(positions_of(motion, 64), tangents, arm, base * (1 - 2e-3)), 0);
  }
}

TEST(SmallestOscillating, EqualLimitsAreOneLimit) {
  const Arm arm{.sigma = -1};
  std::mt19937_64 random(6);
  for (int degrees = 20; degrees < 60; degrees += 2) {
    SCOPED_TRACE(degrees);
    const double limit = degrees * kDegree;
    const PressureLimits limits{limit, limit, limit};
    const auto motion = random_motion(random, 20 * kDegree);
    const auto found =
        smallest_oscillating(*programme_of(motion), limits, ArmSide::leading, arm.length);
    ASSERT_TRUE(found);
    const double base = found->dimensions.base_radius;
    const Tangents tangents(limits);
    EXPECT_LE(breach(positions_of(motion, 64), tangents, arm, centre_of(found->dimensions)),
              1e-10 * (base + arm.length));
    EXPECT_GT(least_breach(positions_of(motion, 64), tangents, arm, base * (1 - 2e-3)), 0);
    EXPECT_LT(found->rounds, 20);
  }
}

// An arm that swings little is a translating follower: the offset is along the arm.
TEST(SmallestOscillating, LittleSwingIsATranslatingFollower) {
  const double arm = 50, swing = 1e-7;
  const HarmonicCam made{.stroke = swing};
  const double up = std::tan(30 * kDegree), down = std::tan(50 * kDegree);
  const double rise = arm * made.rise_depth(up), fall = arm * made.return_depth(down);
  const double height = (rise + fall) / (up + down), offset = rise - up * height;
  for (const auto side : {ArmSide::trailing, ArmSide::leading}) {
    const double sigma = side == ArmSide::trailing ? 1 : -1;
    const auto found =
        smallest_oscillating(made.programme(), {{}, 30 * kDegree, 50 * kDegree}, side, arm);
    ASSERT_TRUE(found);
    const double base = std::hypot(offset, height);
    EXPECT_NEAR(found->dimensions.base_radius, base, 1e-6 * base);
    EXPECT_NEAR(found->dimensions.centre_distance - arm, sigma * offset, 1e-6 * base);
    EXPECT_EQ(found->binding.size(), 2);
  }
}

}  // namespace
}  // namespace cognate::smallest_cam_test
