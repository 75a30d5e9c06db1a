/// Swings, circuits and classes of four-bars against circle intersections with 113 bits that are
/// followed from position to position and share no code with the analysis.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {
namespace {

using Real = boost::multiprecision::cpp_bin_float_quad;

AnalysisResult over_a_turn(const FourBar& linkage) {
  AnalysisProblem problem;
  problem.mechanism = named(linkage);
  problem.drive.start = 0;
  problem.drive.end = kTurn;
  problem.drive.steps = 36;
  return analyse(problem, Run{.threads = 1});
}

template <class T>
std::optional<T> fact(const AnalysisResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.facts, name, &Fact::name);
  if (found == result.facts.end()) return std::nullopt;
  return std::get<T>(found->value);
}

/// The rocker's angle where circles about B and D meet; `side` +1: C to the left of B→D.
std::optional<Real> rocker(const Lengths<double>& l, const Real& theta, int side) {
  const Real bx = Real(l.crank) * cos(theta), by = Real(l.crank) * sin(theta);
  const Real dx = Real(l.frame) - bx, dy = -by, square = dx * dx + dy * dy, d = sqrt(square);
  const Real l2(l.coupler), l3(l.rocker);
  const Real along = (square + l2 * l2 - l3 * l3) / (2 * d), high = l2 * l2 - along * along;
  if (high < 0) return std::nullopt;
  const Real h = side * sqrt(high);
  const Real cx = bx + (along * dx - h * dy) / d, cy = by + (along * dy + h * dx) / d;
  return atan2(cy, cx - Real(l.frame));
}

struct Hull {
  Real least = 0, greatest = 0, value = 0;
  bool begun = false;
  Real last = 0;

  void add(const Real& angle) {
    if (begun) {
      Real step = angle - last;
      const Real turn = 2 * boost::math::constants::pi<Real>();
      if (step > turn / 2) step -= turn;
      if (step < -turn / 2) step += turn;
      value += step;
    }
    begun = true;
    last = angle;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  double degrees() const { return double(greatest - least) * 180 / kPi; }
};

/// Between a position that closes and one that does not.
Real limit(const Lengths<double>& l, Real closed, Real open) {
  for (int i = 0; i < 110; ++i) {
    const Real middle = (closed + open) / 2;
    (rocker(l, middle, 1) ? closed : open) = middle;
  }
  return closed;
}

struct Truth {
  bool turns = false;
  std::optional<Hull> driven, circuit;
  bool comes_round = false;
};

/// Refines an extreme of the hull that was sampled at the share `at`, `value` its value there.
void refine(Hull& hull, const Lengths<double>& l, const std::function<Real(Real)>& drive, int side,
            Real at, Real width, Real value) {
  const auto reference = rocker(l, drive(at), side);
  for (int level = 0; reference && level < 3; ++level, width /= 8) {
    const Real middle = at;
    for (int i = -8; i <= 8; ++i) {
      const Real share = middle + width * i / 8;
      if (share < 0 || share > 1) continue;
      const auto angle = rocker(l, drive(share), side);
      if (!angle) continue;
      const Real here = value + Real(std::remainder(double(*angle - *reference), kTurn));
      if (here < hull.least || here > hull.greatest) at = share;
      hull.least = std::min(hull.least, here);
      hull.greatest = std::max(hull.greatest, here);
    }
  }
}

/// Adds [from, to], crowded towards the ends, where the rocker is fastest.
void walk(Hull& hull, const Lengths<double>& l, const Real& from, const Real& to, int side) {
  constexpr int kSteps = 700;
  const std::function<Real(Real)> drive = [&](Real share) {
    return from + (to - from) * (1 - cos(share * boost::math::constants::pi<Real>())) / 2;
  };
  Real low_at = -1, high_at = -1;
  for (int i = 0; i <= kSteps; ++i) {
    const Real share = Real(i) / kSteps;
    const Real least = hull.least, greatest = hull.greatest;
    if (const auto angle = rocker(l, drive(share), side)) hull.add(*angle);
    if (hull.least < least) low_at = share;
    if (hull.greatest > greatest) high_at = share;
  }
  const Real low = hull.least, high = hull.greatest;
  if (low_at >= 0) refine(hull, l, drive, side, low_at, Real(1) / kSteps, low);
  if (high_at >= 0) refine(hull, l, drive, side, high_at, Real(1) / kSteps, high);
}

Truth truth(const Lengths<double>& l) {
  constexpr int kCells = 720;
  const Real cell = 2 * boost::math::constants::pi<Real>() / kCells;
  const auto closes = [&](int i) { return rocker(l, cell * Real(i + 0.3), 1).has_value(); };
  int first = 0;
  while (first < kCells && !closes(first)) ++first;
  int end = first;
  while (end < kCells && closes(end)) ++end;
  Truth truth;
  truth.turns = first == 0 && end == kCells;
  const bool at_start = rocker(l, Real(0), 1).has_value();
  const Real begin =
      at_start ? Real(0) : limit(l, cell * Real(first + 0.3), cell * Real(first - 0.7));
  const Real stop =
      truth.turns ? cell * kCells : limit(l, cell * Real(end - 0.7), cell * Real(end + 0.3));
  truth.driven.emplace();
  walk(*truth.driven, l, begin, stop, 1);
  if (truth.turns) return truth;
  // A range about A→D is its own mirror image.
  const Real from = at_start ? -stop : begin;
  truth.circuit.emplace();
  walk(*truth.circuit, l, from, stop, 1);
  walk(*truth.circuit, l, stop, from, -1);
  truth.comes_round = abs(truth.circuit->value) > 1;
  return truth;
}

FourBar linkage_of(const Lengths<double>& l) {
  return {{0, 0}, {l.frame, 0}, l.crank, l.coupler, l.rocker, Assembly::open, {}};
}

TEST(LinkageRanges, SwingsOfRandomFourBarsAreThoseFollowed) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> length(0.3, 3);
  std::array<int, 5> classes{};
  int round = 0, turning = 0;
  for (int i = 0; i < 200; ++i) {
    const Lengths<double> l{length(random), length(random), length(random), length(random)};
    if (!can_assemble(l) || std::abs(grashof_excess(l)) < 0.02) continue;
    const Truth expected = truth(l);
    const auto result = over_a_turn(linkage_of(l));
    const auto driven = fact<double>(result, "output_swing_deg");
    const auto circuit = fact<double>(result, "circuit_swing_deg");
    ++classes[std::size_t(mobility_class(l))];
    ASSERT_EQ(fact<bool>(result, "crank_turns_fully"), expected.turns);
    if (expected.turns && expected.driven->degrees() > 359) {
      EXPECT_FALSE(driven) << testing::PrintToString(l);
      ++turning;
      continue;
    }
    ASSERT_TRUE(driven && circuit) << testing::PrintToString(l);
    EXPECT_NEAR(*driven, expected.driven->degrees(), 2e-3) << testing::PrintToString(l);
    if (expected.turns) {
      EXPECT_NEAR(*circuit, *driven, 1e-9) << testing::PrintToString(l);
    } else if (expected.comes_round) {
      EXPECT_EQ(*circuit, 360) << testing::PrintToString(l);
      ++round;
    } else {
      EXPECT_NEAR(*circuit, expected.circuit->degrees(), 2e-3) << testing::PrintToString(l);
    }
    if (!expected.turns) {
      // A dead point is reached.
      EXPECT_EQ(fact<double>(result, "transmission_angle_deg.acute_min"), 0)
          << testing::PrintToString(l);
    }
  }
  EXPECT_GT(std::ranges::min(classes), 4);
  EXPECT_GT(round, 4);
  EXPECT_GT(turning, 4);
}

TEST(LinkageRanges, ADoubleRockerSwingsWithinItsOwnRange) {
  const auto result = over_a_turn(linkage_of({4.5, 1.5, 3, 5}));
  EXPECT_NEAR(*fact<double>(result, "output_swing_deg"), 37.57, 0.005);
  EXPECT_NEAR(*fact<double>(result, "circuit_swing_deg"), 60.27, 0.005);
}

TEST(LinkageRanges, AParallelogramIsADoubleCrank) {
  FourBar linkage = linkage_of({1, 4, 1, 4});
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    linkage.assembly = assembly;
    const auto result = over_a_turn(linkage);
    EXPECT_EQ(fact<std::string>(result, "class"), "double-crank");
    EXPECT_EQ(fact<std::string>(result, "change_point_kind"),
              assembly == Assembly::open ? "parallelogram" : "antiparallelogram");
    EXPECT_EQ(fact<bool>(result, "rocker_turns_fully"), true);
  }
  EXPECT_EQ(fact<std::string>(over_a_turn(linkage_of({2, 3, 3, 2})), "change_point_kind"), "kite");
  EXPECT_EQ(fact<std::string>(over_a_turn(linkage_of({3, 3, 3, 3})), "change_point_kind"),
            "rhombus");
  EXPECT_EQ(fact<std::string>(over_a_turn(linkage_of({1, 3, 5, 7})), "change_point_kind"),
            "single");
}

}  // namespace
}  // namespace cognate::problems
