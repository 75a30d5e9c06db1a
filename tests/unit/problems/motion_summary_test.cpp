// What an analysis says of a motion as a whole, against closed forms from the dimensions alone and
// published numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"
#include "tests/support/named_mechanisms.hpp"

namespace cognate::problems::motion_summary_test {
namespace {

AnalysisResult analyse(const AnalysisProblem& problem) {
  return problems::analyse(problem, problems::Run{.threads = 1});
}

AnalysisResult over_a_turn(const NamedMechanism& mechanism) {
  return analyse(analysis_of(mechanism, 36));
}

const Quantity* find(const AnalysisResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.quantities, name, &Quantity::name);
  return found == result.quantities.end() ? nullptr : &*found;
}

double number(const AnalysisResult& result, const std::string& name) {
  const Quantity* quantity = find(result, name);
  EXPECT_NE(quantity, nullptr) << "no fact " << name;
  return quantity ? std::get<double>(quantity->value) : std::nan("");
}

std::vector<Landmark> landmarks(const AnalysisResult& result, const std::string& kind) {
  std::vector<Landmark> all;
  std::ranges::copy_if(result.landmarks, std::back_inserter(all),
                       [&](const Landmark& landmark) { return landmark.kind == kind; });
  return all;
}

const std::vector<double>& values(const AnalysisResult& result, const std::string& name) {
  return std::ranges::find(result.columns, name, &Column::name)->values;
}

TEST(MotionSummary, FourBarAsItsLengthsSay) {
  const FourBar linkage{{1, 2}, {5, 3}, 1, 4, 3, Assembly::open, std::nullopt};
  const auto links = lengths(linkage);
  const auto result = over_a_turn(named(linkage));
  EXPECT_EQ(std::get<std::string>(find(result, "class")->value), "crank-rocker");
  EXPECT_EQ(number(result, "mobility"), 1);
  EXPECT_TRUE(std::get<bool>(find(result, "crank_turns_fully")->value));
  EXPECT_FALSE(std::get<bool>(find(result, "change_point")->value));
  const auto angles = transmission_angles(links);
  EXPECT_NEAR(number(result, "transmission_angle_deg.min") * kDegree, angles.min, 1e-14);
  EXPECT_NEAR(number(result, "transmission_angle_deg.max") * kDegree, angles.max, 1e-14);
  EXPECT_NEAR(number(result, "time_ratio"), *time_ratio(links), 1e-14);

  const auto outer = *outer_limit(links), inner = *inner_limit(links);
  const double frame = frame_angle(linkage);
  const auto limits = landmarks(result, "limit position");
  ASSERT_EQ(limits.size(), 2u);
  for (const auto& limit : {outer, inner}) {
    const auto same = [&](const Landmark& landmark) {
      const double apart = landmark.drive - frame - limit.crank_angle;
      return std::abs(std::remainder(apart, kTurn)) < 1e-12;
    };
    const auto found = std::ranges::find_if(limits, same);
    ASSERT_NE(found, limits.end());
    const double apart = found->value - frame - limit.rocker_angle;
    EXPECT_NEAR(std::remainder(apart, kTurn), 0, 1e-12);
  }
  EXPECT_NEAR(number(result, "output_swing_deg") * kDegree,
              std::abs(std::remainder(outer.rocker_angle - inner.rocker_angle, kTurn)), 1e-12);
}

TEST(MotionSummary, SliderCrankAndGuideBarAsTheirDimensionsSay) {
  const SliderCrank slider{.crank = 1, .coupler = 3, .offset = 0.5};
  const auto slides = over_a_turn(named(slider));
  EXPECT_EQ(std::get<std::string>(find(slides, "class")->value), "rotating-crank");
  EXPECT_NEAR(number(slides, "output_stroke"), *stroke(slider), 1e-14);
  EXPECT_NEAR(number(slides, "time_ratio"), *time_ratio(slider), 1e-14);
  EXPECT_NEAR(number(slides, "pressure_angle_max_deg") * kDegree,
              std::abs(pressure_angles(slider)->steepest), 1e-14);

  const GuideBar bar{{0, 0.38}, {0, 0}, 0.12};
  const auto swings = over_a_turn(named(bar));
  EXPECT_EQ(std::get<std::string>(find(swings, "class")->value), "oscillating");
  EXPECT_NEAR(number(swings, "output_swing_deg") * kDegree, *swing(bar), 1e-14);
  EXPECT_NEAR(number(swings, "time_ratio"), *time_ratio(bar), 1e-14);
}

// The course of the motion and the formulas agree where the type has both.
TEST(MotionSummary, ScotchYokeReturnsAsItGoes) {
  const auto result = over_a_turn(named(ScotchYoke{.crank = 2}));
  EXPECT_NEAR(number(result, "output_stroke"), 4, 1e-14);
  EXPECT_NEAR(number(result, "time_ratio"), 1, 1e-12);
  EXPECT_EQ(number(result, "pressure_angle_max_deg"), 0);
}

TEST(MotionSummary, ALimitedSweepCountsOnItsOwnRange) {
  const FourBar linkage{{0, 0}, {4, 0}, 1, 3, 3, Assembly::open, std::nullopt};
  auto problem = analysis_of(named(linkage), 30);
  problem.drive.start = 60 * kDegree;
  problem.drive.end = 120 * kDegree;
  const auto result = analyse(problem);
  const auto angles = transmission_angles(lengths(linkage), {60 * kDegree, 120 * kDegree});
  EXPECT_NEAR(number(result, "transmission_angle_deg.min") * kDegree, angles.min, 1e-14);
  EXPECT_NEAR(number(result, "transmission_angle_deg.max") * kDegree, angles.max, 1e-14);
  EXPECT_TRUE(landmarks(result, "limit position").empty());
  EXPECT_NEAR(number(result, "output_swing_deg"),
              values(result, "rocker_deg").back() - values(result, "rocker_deg").front(), 1e-12);
}

TEST(MotionSummary, DeadPointsEndTheRanges) {
  const FourBar rocker{{0, 0}, {2, 0}, 2, 1.5, 2, Assembly::open, std::nullopt};
  const auto dead = landmarks(over_a_turn(named(rocker)), "dead point");
  const auto ranges = crank_ranges(lengths(rocker));
  ASSERT_EQ(ranges.size(), 2u);
  ASSERT_EQ(dead.size(), 4u);
  EXPECT_NEAR(dead[0].drive, std::max(ranges[0].from, ranges[1].from), 1e-12);
  EXPECT_NEAR(dead[1].drive, std::max(ranges[0].to, ranges[1].to), 1e-12);
  EXPECT_EQ(dead[0].of, "C");
}

// With d² = 3² + 4² the ends of coupler and rocker, 2 + 3 long, are stretched at 90° exactly: the
// rocker stands, and its speed is infinite.
TEST(MotionSummary, ARowOnADeadPointHasAPositionButNoRates) {
  const FourBar linkage{{0, 0}, {4, 0}, 3, 2, 3, Assembly::open, std::nullopt};
  auto problem = analysis_of(named(linkage), 9);
  problem.drive.end = 90 * kDegree;
  problem.inertias[2].mass = 1;
  problem.output.torque = problem.output.reactions = true;
  const auto result = analyse(problem);
  EXPECT_EQ(result.closed_rows, 10);
  EXPECT_NEAR(values(result, "rocker_deg")[9], 180 - std::asin(0.6) / kDegree, 1e-6);
  for (const char* rate : {"rocker_omega_rad_s", "rocker_alpha_rad_s2", "torque_N_m"}) {
    EXPECT_TRUE(std::isfinite(values(result, rate)[8])) << rate;
    EXPECT_TRUE(std::isnan(values(result, rate)[9])) << rate;
  }
}

// A parallelogram keeps its coupler parallel to the frame through its change points, on which rows
// of the table lie.
TEST(MotionSummary, AParallelogramGoesOnThroughItsChangePoints) {
  const FourBar parallelogram{{0, 0}, {3, 0}, 1, 3, 1, Assembly::open, std::nullopt};
  auto problem = analysis_of(named(parallelogram), 72);
  problem.drive.start = 30 * kDegree;
  problem.drive.end = 30 * kDegree + 2 * kTurn;
  const auto result = analyse(problem);
  EXPECT_EQ(result.closed_rows, 73);
  EXPECT_TRUE(std::get<bool>(find(result, "change_point")->value));
  EXPECT_EQ(std::get<std::string>(find(result, "moves_as")->value), "parallelogram");
  EXPECT_EQ(find(result, "time_ratio"), nullptr);
  EXPECT_EQ(landmarks(result, "change point").size(), 4u);
  for (std::size_t row = 0; row <= 72; ++row) {
    EXPECT_NEAR(values(result, "coupler_deg")[row], 0, 1e-9) << row;
    EXPECT_NEAR(values(result, "rocker_deg")[row], values(result, "crank_deg")[row], 1e-9) << row;
    EXPECT_NEAR(values(result, "rocker_omega_rad_s")[row], 1, 1e-9) << row;
  }
}

// A kite folds on its frame: with l₁ = l₄ the joints B and D meet, and the coupler and rocker may
// turn about them.
TEST(MotionSummary, AnUndeterminedPositionIsEmptyAndSaidSo) {
  const FourBar kite{{0, 0}, {1, 0}, 1, 2, 2, Assembly::open, std::nullopt};
  auto problem = analysis_of(named(kite), 8);
  problem.drive.start = -90 * kDegree;
  problem.drive.end = 90 * kDegree;
  const auto result = analyse(problem);
  EXPECT_TRUE(std::isnan(values(result, "rocker_deg")[4]));
  EXPECT_EQ(result.closed_rows, 8);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("at crank angle 0° the position is not determined"),
            std::string::npos)
      << result.notes[0];
  EXPECT_EQ(landmarks(result, "undetermined change point").size(), 1u);
}

// Li & Xu 2011, example 2-4, recomputed with 30 digits: the shaper at crank angle 0, without
// gravity; its stroke is the chord l₃·2 sin(swing/2), of which the load leaves out 5 % at each end.
TEST(MotionSummary, TheShaperWithALoadWithinItsStroke) {
  const auto problem = parse_task<AnalysisProblem>(R"(
kind = "analysis"
load = [{on = "E", force = [5880, 0], when = "advance", stroke = [0.05, 0.95]}]
link = [{name = "CB", mass = 20, centre = [0.3, 0], inertia = 0.12},
        {name = "DE", mass = 3, centre = [0.075, 0], inertia = 0.00025},
        {name = "E", mass = 62, centre = [0.15, 0]}]
[mechanism]
type = "chain"
pivot = [{name = "A", at = [0, 0.275]}, {name = "C", at = [0, 0]}]
crank = {at = "A", pin = "B", length = 0.125}
dyad = [{type = "RPR", joins = ["B", "C"]},
        {type = "RRP", joins = "D", length = 0.15, new = "E", slide = {through = [0, 0.575], direction_deg = 180}}]
point = [{name = "D", on = "CB", at = [0.6, 0]}]
)");
  ASSERT_TRUE(problem.has_value());
  const auto result = analyse(*problem);
  const double swing = 2 * std::asin(0.125 / 0.275);
  EXPECT_NEAR(number(result, "output_stroke"), 2 * 0.6 * std::sin(swing / 2), 1e-13);
  EXPECT_NEAR(number(result, "time_ratio"), (kPi + swing) / (kPi - swing), 1e-12);
  // Where the load acts the driving torque is that without it plus F·v/ω.
  auto unloaded = *problem;
  unloaded.loads.clear();
  const auto& with = values(result, "torque_N_m");
  const auto bare = analyse(unloaded);
  const auto& without = values(bare, "torque_N_m");
  EXPECT_NEAR(without[0], 1.0000627839411942, 1e-12);
  const auto& s = values(result, "E_s");
  const auto& v = values(result, "E_v_per_s");
  const auto [least, greatest] =
      std::ranges::minmax(landmarks(result, "limit position"), {}, &Landmark::value);
  const double length = greatest.value - least.value;
  int loaded = 0;
  for (std::size_t row = 0; row < with.size(); ++row) {
    const double part = (s[row] - least.value) / length;
    const bool acts = v[row] > 0 && part > 0.05 && part < 0.95;
    loaded += acts ? 1 : 0;
    // The slide is directed against the x axis: advancing, the slider moves against the load.
    EXPECT_NEAR(with[row] - without[row], acts ? 5880 * v[row] : 0, 1e-9) << row;
  }
  EXPECT_GT(loaded, 150);
  EXPECT_LT(number(result, "power_residual"), 1e-14);
}

/// A four-bar of the first range of its crank that holds `reach`, half of it, about `middle` from
/// the frame, with rocker angles by complex numbers.
struct RockerBySamples {
  double crank, coupler, rocker, frame, side;

  std::complex<double> along_rocker(double crank_angle) const {
    const std::complex<double> pin = std::polar(crank, crank_angle), to_pivot = frame - pin;
    const double apart = std::norm(to_pivot);
    const double along = 0.5 * (apart + coupler * coupler - rocker * rocker);
    const double across = std::sqrt(std::max(0.0, coupler * coupler * apart - along * along));
    return pin + std::complex<double>(along, side * across) / apart * to_pivot - frame;
  }

  double swing(double middle, double reach) const {
    constexpr int kSamples = 4000;
    double angle = 0, least = 0, greatest = 0;
    std::complex<double> last = along_rocker(middle - reach);
    for (int k = 1; k <= kSamples; ++k) {
      const double share = -std::cos(kPi * k / kSamples);
      const std::complex<double> next = along_rocker(middle + share * reach);
      angle += std::arg(next / last);
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
      last = next;
    }
    return greatest - least;
  }
};

// A crank that starts within its only range leaves it at one dead point, comes back from the other,
// and ends where it started: both parts are one range.
TEST(MotionSummary, SwingIsThatOfTheRangeOnBothSidesOfTheStart) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> length(0.3, 3), share(-0.9, 0.9), angle(-3, 3);
  int tested = 0;
  while (tested < 100) {
    const double a = length(random), b = length(random), c = length(random), f = length(random);
    const bool ends_outside = f + a > b + c, ends_inside = std::abs(f - a) < std::abs(b - c);
    if (ends_outside == ends_inside || std::abs(f - a) >= b + c || f + a <= std::abs(b - c)) {
      continue;
    }
    const double end = ends_outside ? b + c : b - c;
    const double reached = std::acos((a * a + f * f - end * end) / (2 * a * f));
    const double middle = ends_outside ? 0 : kPi;
    const double reach = ends_outside ? reached : kPi - reached;
    const bool open = random() % 2 == 0;
    const RockerBySamples rocker{a, b, c, f, open ? 1.0 : -1.0};
    // The start of the turn, the x axis, lies anywhere in the range.
    const double along = -(middle + share(random) * reach);
    const FourBar linkage{
        {angle(random), 1}, {}, a, b, c, open ? Assembly::open : Assembly::crossed, std::nullopt};
    FourBar placed = linkage;
    placed.pivot_d = linkage.pivot_a + f * Vec2d{std::cos(along), std::sin(along)};
    const double wanted = rocker.swing(middle, reach) / kDegree;
    AnalysisProblem problem = analysis_of(named(placed), 36);
    for (const double turns : {1.0, -1.0, 2.0}) {
      problem.drive.end = problem.drive.start + turns * kTurn;
      const auto result = analyse(problem);
      EXPECT_NEAR(number(result, "output_swing_deg"), wanted, 1e-3 + 1e-5 * wanted)
          << a << " " << b << " " << c << " " << f << " turns " << turns;
    }
    ++tested;
  }
  EXPECT_EQ(tested, 100);
}

}  // namespace
}  // namespace cognate::problems::motion_summary_test
