/// Precision points spaced anew: level peaks, and the best errors known for classical functions.
#include "synthesis/exact/respacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/chebyshev.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"

namespace cognate::synthesis::respacing_test {
namespace {

constexpr double degree = kPi / 180;

/// y = f(x) on a domain, carried to the angles of two links.
struct Classic {
  std::string name;
  double (*y)(double);
  double first, last;
  double input, output;  ///< ranges, degrees

  double angle(double turned) const {
    const double x = first + (last - first) * turned / (input * degree);
    return output * degree * (y(x) - y(first)) / (y(last) - y(first));
  }
};

/// By trigonometry of the two triangles, which the exchange does not use.
double error_at(const GeneratingFourBar& linkage, const Classic& classic, double turned) {
  const auto& [l1, l2, l3, l4] = linkage.links;
  const double input = linkage.input_start + turned;
  const double x = l4 - l1 * std::cos(input), y = -l1 * std::sin(input);  // B→D
  const double d = std::hypot(x, y);
  const double at_d = std::acos((d * d + l3 * l3 - l2 * l2) / (2 * d * l3));
  const double side = linkage.assembly == Assembly::open ? -1 : 1;
  const double rocker = std::atan2(y, x) + kPi + side * at_d;
  return std::remainder(rocker - linkage.output_start - classic.angle(turned), kTurn);
}

double greatest_error(const GeneratingFourBar& linkage, const Classic& classic) {
  double most = 0;
  for (int i = 0; i <= 20000; ++i) {
    most = std::max(most, std::abs(error_at(linkage, classic, classic.input * degree * i / 20000)));
  }
  return most;
}

RespacingTask task_of(const Classic& classic, bool input_free, bool output_free) {
  return {[=](double turned) { return classic.angle(turned); }, 0, classic.input * degree,
          input_free, output_free};
}

/// Both assemblies of every four-bar through Chebyshev's points.
std::vector<GeneratingFourBar> chebyshev(const Classic& classic, const GivenStart& start) {
  const int count = 3 + !start.input + !start.output;
  std::vector<PrecisionPoint> points;
  for (const double turned : chebyshev_spacing(0, classic.input * degree, count)) {
    points.push_back({turned, {classic.angle(turned)}, 1});
  }
  std::vector<GeneratingFourBar> all;
  for (const FourBarFunction& found : four_bar_functions(points, start).solutions) {
    if (found.outcome != FourBarOutcome::linkage) continue;
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      all.push_back({found.links, assembly, found.input_start, found.output_start});
    }
  }
  return all;
}

void expect_level(const Respacing& found, const Classic& classic, int precision_points) {
  EXPECT_EQ(found.precision_inputs.size(), std::size_t(precision_points)) << classic.name;
  ASSERT_EQ(found.peaks.size(), std::size_t(precision_points + 1)) << classic.name;
  for (std::size_t i = 0; i < found.peaks.size(); ++i) {
    const double error = error_at(found.linkage, classic, found.peaks[i]);
    const double first = error_at(found.linkage, classic, found.peaks[0]);
    EXPECT_NEAR(error, i % 2 == 0 ? first : -first, 1e-9 * std::abs(first) + 1e-14)
        << classic.name << ", peak " << i;
  }
  for (const double input : found.precision_inputs) {
    EXPECT_NEAR(error_at(found.linkage, classic, input), 0, 1e-13) << classic.name;
  }
  const double scanned = greatest_error(found.linkage, classic);
  EXPECT_LE(scanned, found.greatest * (1 + 1e-9)) << classic.name;
}

const Classic kLog10{"log10 60-90", [](double x) { return std::log10(x); }, 1, 2, 60, 90};

/// Li & Xu 2011, example 3-7: largest error 0.58 degrees with Chebyshev's points.
TEST(Respacing, LevelsThePublishedExample) {
  const auto starts = chebyshev(kLog10, {86 * degree, 23.5 * degree});
  int level = 0;
  for (const GeneratingFourBar& start : starts) {
    const double before = greatest_error(start, kLog10);
    const Respacing found = equal_peaks(task_of(kLog10, false, false), start);
    if (found.outcome != RespacingOutcome::level) continue;
    ++level;
    EXPECT_NEAR(before / degree, 0.5829139524285558, 1e-10);
    EXPECT_LT(found.greatest, before);
    expect_level(found, kLog10, 3);
  }
  EXPECT_EQ(level, 1);
}

/// The best that minimax search over thousands of starts has found, degrees; its optima are good to
/// 0.3 %.
struct Known {
  Classic classic;
  double greatest;
};

const Known kKnown[] = {
    {{"log10 60-90 against", [](double x) { return std::log10(x); }, 1, 2, 60, -90},
     0.023536794106476987},
    {{"sqrt against", [](double x) { return std::sqrt(x); }, 1, 10, 90, -90}, 0.09245228407441722},
    {{"sqrt", [](double x) { return std::sqrt(x); }, 1, 10, 90, 90}, 0.018721935120204813},
    {{"sin", [](double x) { return std::sin(x); }, 0, kRightAngle, 90, 90}, 0.1903377706046579},
    {{"1/x", [](double x) { return 1 / x; }, 1, 2, 90, 90}, 0.012815564605462178},
    {{"1/x against", [](double x) { return 1 / x; }, 1, 2, 90, -90}, 0.00819067014869068},
    {{"log10 60-60", [](double x) { return std::log10(x); }, 1, 2, 60, 60}, 0.003671916024670183},
    {{"log10 60-60 against", [](double x) { return std::log10(x); }, 1, 2, 60, -60},
     0.00101874201888303},
    {{"log10 to 10", [](double x) { return std::log10(x); }, 1, 10, 60, 60}, 0.04215987181610361},
    {{"log10 to 10 against", [](double x) { return std::log10(x); }, 1, 10, 60, -60},
     0.02777308792314818},
};

TEST(Respacing, ReachesTheBestKnownFromFiveChebyshevPoints) {
  int reached = 0;
  for (const auto& [classic, known] : kKnown) {
    double best = 1e9;
    for (const GeneratingFourBar& start : chebyshev(classic, {})) {
      const double before = greatest_error(start, classic);
      const Respacing found = equal_peaks(task_of(classic, true, true), start);
      if (found.outcome == RespacingOutcome::not_closing) continue;
      if (found.outcome == RespacingOutcome::not_alternating) continue;
      EXPECT_LE(greatest_error(found.linkage, classic), before * (1 + 1e-9)) << classic.name;
      if (found.outcome != RespacingOutcome::level) continue;
      expect_level(found, classic, 5);
      best = std::min(best, found.greatest);
    }
    reached += best / degree <= known * 1.000001;
  }
  EXPECT_EQ(reached, 10);
}

TEST(Respacing, OneStartAngleGiven) {
  int level = 0;
  for (const GeneratingFourBar& start : chebyshev(kLog10, {86 * degree, {}})) {
    const Respacing found = equal_peaks(task_of(kLog10, false, true), start);
    if (found.outcome != RespacingOutcome::level) continue;
    EXPECT_EQ(found.linkage.input_start, start.input_start);
    expect_level(found, kLog10, 4);
    ++level;
  }
  EXPECT_GT(level, 0);
}

/// The links do not reach over 3e-4 of a radian about the frame's line, between two samples of the
/// exchange.
TEST(Respacing, SeesAGapBetweenSamples) {
  const GeneratingFourBar gap{{1, 2.5, 1.5 - 1e-7, 2}, Assembly::open, -30.1 * degree, 0};
  const GeneratingFourBar none{{1, 2.5, 1.5 + 1e-7, 2}, Assembly::open, -30.1 * degree, 0};
  EXPECT_EQ(equal_peaks(task_of(kLog10, false, false), gap).outcome, RespacingOutcome::not_closing);
  EXPECT_NE(equal_peaks(task_of(kLog10, false, false), none).outcome,
            RespacingOutcome::not_closing);
}

TEST(Respacing, Refusals) {
  const GeneratingFourBar rigid{{1, 1, 1, 10}};
  EXPECT_EQ(equal_peaks(task_of(kLog10, false, false), rigid).outcome,
            RespacingOutcome::not_closing);
  const GeneratingFourBar far_off{{1, 3, 3, 3}};
  EXPECT_EQ(equal_peaks(task_of(kLog10, false, false), far_off).outcome,
            RespacingOutcome::not_alternating);
}

}  // namespace
}  // namespace cognate::synthesis::respacing_test
