/// One gear: its table against the textbook, its measurements against handbooks and geometry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "problems/gear/quantities.hpp"
#include "problems/gear/result.hpp"

namespace cognate::problems::gear_analysis_test {
namespace {

GearProblem spur(double teeth, double module, double shift = 0) {
  GearProblem problem;
  problem.gear.normal.teeth = teeth;
  problem.gear.normal.module = module;
  problem.gear.normal.profile_shift = shift;
  return problem;
}

const std::vector<double>& column(const GearResult& result, const std::string& name) {
  for (const Column& each : result.columns) {
    if (each.name == name) return each.values;
  }
  ADD_FAILURE() << "no column " << name;
  return result.columns.front().values;
}

// Li & Xu 2011, example 5-3: z = 35, m = 5. The book's r_w = 82.5 is below where the involute ends.
TEST(GearAnalysis, TheTableIsThatOfTheTextbook) {
  const auto result = analyse(spur(35, 5), {});
  EXPECT_EQ(result.status, Status::solved);
  const auto &radius = column(result, "radius"), &x = column(result, "x"), &y = column(result, "y"),
             &involute = column(result, "is_involute");
  ASSERT_EQ(radius.size(), 42u);
  EXPECT_NEAR(radius[21], 83.63591216851961, 1e-9);
  EXPECT_EQ(involute[20], 0);
  EXPECT_EQ(involute[21], 1);
  EXPECT_NEAR(x[41], -1.8761278745879413, 1e-9);
  EXPECT_NEAR(y[41], 92.48097179527362, 1e-9);
  EXPECT_NEAR(column(result, "thickness")[41], 3.7525130629275156, 1e-9);
  EXPECT_NEAR(radius[0], 81.25, 1e-9);  // the fillet begins at the root circle…
  EXPECT_NEAR(x[20], x[21], 2e-6);      // …and ends where the involute begins
  EXPECT_NEAR(y[20], y[21], 2e-6);
}

TEST(GearAnalysis, AnUndercutGearIsRefusedWithTheShiftItNeeds) {
  const auto result = analyse(spur(9, 10), {});
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("at least 0.4736"), std::string::npos);
  EXPECT_EQ(analyse(spur(9, 10, 0.4737), {}).status, Status::solved);
}

TEST(GearAnalysis, APointedGearIsRefused) {
  const auto result = analyse(spur(12, 1, 1.1), {});
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_NE(result.notes.at(0).find("pointed"), std::string::npos);
}

TEST(GearAnalysis, AGearThatCannotBeMadeHasNoTable) {
  const auto result = analyse(spur(4, 1, -2), {});
  EXPECT_EQ(result.status, Status::invalid);
  EXPECT_TRUE(result.columns.empty());
}

// Tables of the base tangent length of standard gears, module 1, α = 20°.
TEST(GearAnalysis, SpansAreThoseOfTheHandbook) {
  struct Span {
    double teeth;
    int over;
    double length;
  };
  for (const Span& wanted : {Span{20, 3, 7.6604}, Span{35, 4, 10.8226}, Span{80, 9, 26.2137}}) {
    const auto span = span_measurement(spur(wanted.teeth, 1).gear);
    ASSERT_TRUE(span);
    EXPECT_EQ(span->teeth, wanted.over);
    EXPECT_NEAR(span->length, wanted.length, 1.5e-4);
  }
}

// Machinery's Handbook, chordal thickness and addendum of full-depth teeth; the constant chord of
// 20° and of 14.5°.
TEST(GearAnalysis, ChordsAreThoseOfTheHandbook) {
  struct Row {
    double teeth, thickness, addendum;
  };
  for (const Row& row : {Row{12, 1.5663, 1.0514}, Row{20, 1.5692, 1.0308}, Row{35, 1.5703, 1.0176},
                         Row{55, 1.5706, 1.0112}}) {
    const Chord chord = reference_chord(spur(row.teeth, 1).gear);
    EXPECT_NEAR(chord.thickness, row.thickness, 1e-4) << row.teeth;
    EXPECT_NEAR(chord.addendum, row.addendum, 1e-4) << row.teeth;
  }
  GearProblem steep = spur(40, 10);
  EXPECT_NEAR(constant_chord(steep.gear).thickness, 13.8705, 5e-5);
  EXPECT_NEAR(constant_chord(steep.gear).addendum, 7.4758, 5e-5);
  steep.gear.normal.rack.pressure_angle = 14.5 * kPi / 180;
  EXPECT_NEAR(constant_chord(steep.gear).thickness, 14.723, 5e-4);
}

/// The point of the flank in the table that is nearest to `from`.
Vec2d nearest_of_flank(const GearResult& result, const Vec2d& from) {
  const auto &x = column(result, "x"), &y = column(result, "y");
  Vec2d nearest{HUGE_VAL, HUGE_VAL};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec2d at{x[i], y[i]};
    if (norm(at - from) < norm(nearest - from)) nearest = at;
  }
  return nearest;
}

// On the flank as it was cut: the chord where it crosses the reference circle, and that of the
// points whose normals meet in the pitch point.
TEST(GearAnalysis, ChordsAreThoseOfTheFlank) {
  for (const double shift : {-0.2, 0.0, 0.35}) {
    GearProblem problem = spur(29, 3, shift);
    problem.points = 10000;
    const auto result = analyse(problem, {});
    const double reference = 0.5 * 29 * 3, tip = reference + 3 * (1 + shift);
    const auto &radius = column(result, "radius"), &x = column(result, "x"),
               &y = column(result, "y");
    const auto above = std::ranges::lower_bound(radius, reference) - radius.begin();
    const auto i = static_cast<std::size_t>(above);
    const Chord chord = reference_chord(problem.gear), constant = constant_chord(problem.gear);
    EXPECT_NEAR(chord.thickness, -2 * x[i], 1e-3) << shift;
    EXPECT_NEAR(chord.addendum, tip - y[i], 1e-3) << shift;
    const Vec2d touched = nearest_of_flank(result, {0, reference});
    EXPECT_NEAR(constant.thickness, -2 * touched.x, 2e-3) << shift;
    EXPECT_NEAR(constant.addendum, tip - touched.y, 2e-3) << shift;
  }
}

/// The shortest way between the helices in which the flanks cut the reference cylinder: from a
/// point at height −h on one to that at h on the other, which half a turn about the tooth's middle
/// exchanges.
double shortest_chord(double radius, double half_angle, double helix) {
  double least = HUGE_VAL;
  for (int i = 0; i <= 200000; ++i) {
    const double height = radius * (i * 1e-5 - 1);
    const double angle = half_angle + height * std::tan(helix) / radius;
    least = std::min(least, 2 * std::hypot(radius * std::sin(angle), height));
  }
  return least;
}

// d_n sin(s_n/d_n) stands for that way, to a part in a thousand.
TEST(GearAnalysis, TheChordOfAHelicalToothIsTheWayAcrossIt) {
  for (const double degrees : {8.0, 20.0, 35.0}) {
    GearProblem problem = spur(19, 2, 0.1);
    problem.gear.helix = degrees * kPi / 180;
    const double cosine = std::cos(problem.gear.helix), radius = 19 / cosine;
    const double thickness = 2 * (kPi / 2 + 0.2 * std::tan(kPi / 9));
    const double shortest =
        shortest_chord(radius, 0.5 * thickness / cosine / radius, problem.gear.helix);
    EXPECT_NEAR(reference_chord(problem.gear).thickness, shortest, 1e-3 * shortest) << degrees;
  }
}

TEST(GearAnalysis, SpansOverGivenTeethDifferByTheBasePitch) {
  const GearProblem problem = spur(50, 4, 0.2);
  const auto range = span_range(problem.gear);
  ASSERT_TRUE(range);
  ASSERT_GT((*range)[1], (*range)[0] + 1);
  const double usual = span_measurement(problem.gear).value().teeth;
  EXPECT_TRUE((*range)[0] <= usual && usual <= (*range)[1]);
  EXPECT_FALSE(span_over(problem.gear, (*range)[0] - 1));
  EXPECT_FALSE(span_over(problem.gear, (*range)[1] + 1));
  for (int teeth = (*range)[0]; teeth < (*range)[1]; ++teeth) {
    const double step = span_over(problem.gear, teeth + 1).value().length -
                        span_over(problem.gear, teeth).value().length;
    EXPECT_NEAR(step, 4 * kPi * std::cos(kPi / 9), 1e-12);
  }
  GearProblem asked = problem;
  asked.span_teeth = (*range)[1];
  const auto metrics = analyse(asked, {}).metrics;
  const auto found = std::ranges::find(metrics, "span_teeth", &Quantity::name);
  ASSERT_NE(found, metrics.end());
  EXPECT_EQ(std::get<double>(found->value), (*range)[1]);
}

bool has(const std::vector<Quantity>& quantities, const std::string& name) {
  return std::ranges::find(quantities, name, &Quantity::name) != quantities.end();
}

TEST(GearAnalysis, WhatCannotBeMeasuredIsLeftOut) {
  int tested = 0;
  // Both anvils need b ≥ W sin β_b, here 27.5.
  GearProblem narrow = spur(60, 2);
  narrow.gear.helix = kPi / 6;
  const double length = span_measurement(narrow.gear).value().length;
  EXPECT_NEAR(length, 58.62, 5e-3);
  narrow.gear.face_width = 27.7;
  EXPECT_EQ(span_measurement(narrow.gear).value().teeth, 10);
  narrow.gear.face_width = 27.4;
  EXPECT_EQ(span_measurement(narrow.gear).value().teeth, 9);
  narrow.gear.face_width = 5;
  EXPECT_FALSE(span_measurement(narrow.gear));
  EXPECT_FALSE(has(gear_quantities(narrow.gear, ""), "span_measurement"));
  // A plane on the pin of a gear of 20 teeth cuts the tips beside it when x = 1.2.
  EXPECT_FALSE(pins_can_be_measured(spur(20, 1, 1.2).gear, 1.728));
  EXPECT_FALSE(has(gear_quantities(spur(20, 1, 1.2).gear, ""), "measurement_over_pins"));
  EXPECT_FALSE(pins_can_be_measured(spur(28, 1, 1.5).gear, 1.728));
  EXPECT_TRUE(pins_can_be_measured(spur(20, 1).gear, 1.728));
  // Where a span is reported its anvils touch the involute of the table.
  for (double shift = -1.2; shift < 1.3; shift += 0.01) {
    for (const double teeth : {9.0, 17.0, 26.0, 40.0}) {
      const auto span = span_measurement(spur(teeth, 1, shift).gear);
      if (!span) continue;
      ++tested;
      const auto result = analyse(spur(teeth, 1, shift), {});
      const auto &radius = column(result, "radius"), &involute = column(result, "is_involute");
      const double base = 0.5 * teeth * std::cos(kPi / 9);
      const double touched = std::hypot(base, 0.5 * span->length);
      const auto first = std::ranges::find(involute, 1.0) - involute.begin();
      EXPECT_GE(touched, radius[static_cast<std::size_t>(first)] - 1e-9) << teeth << ' ' << shift;
      EXPECT_LE(touched, radius.back() + 1e-9) << teeth << ' ' << shift;
    }
  }
  EXPECT_GE(tested, 860);
}

/// The least distance of `centre` from the flank in the table, turned to the space at angle 0.
double distance_to_flank(const GearResult& result, double teeth, double centre) {
  const auto &x = column(result, "x"), &y = column(result, "y");
  const double turn = -kPi / teeth;  // the space to the left, onto the y axis
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = x[i] * std::cos(turn) - y[i] * std::sin(turn);
    const double v = x[i] * std::sin(turn) + y[i] * std::cos(turn);
    least = std::min(least, std::hypot(u, v - centre));
  }
  return least;
}

TEST(GearAnalysis, APinTouchesTheFlanksOfItsSpace) {
  for (const double teeth : {24.0, 31.0}) {
    GearProblem problem = spur(teeth, 3, 0.2);
    problem.points = 10000;
    const auto result = analyse(problem, {});
    const double pin = 1.728 * 3, over = measurement_over_pins(problem.gear, pin);
    const double across = over - pin;
    const double share = teeth == 24 ? 1 : std::cos(kPi / (2 * teeth));
    EXPECT_NEAR(distance_to_flank(result, teeth, 0.5 * across / share), 0.5 * pin, 1e-6);
  }
}

}  // namespace
}  // namespace cognate::problems::gear_analysis_test
