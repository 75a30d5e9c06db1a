// What a motion is where it begins and ends: at dead points, change points, a turn later.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "tests/support/read_problems.hpp"

namespace cognate::problems::motion_ends_test {
namespace {

AnalysisResult analysed(const std::string& mechanism, const std::string& drive) {
  return analyse(test::problem_of<AnalysisProblem>("kind = \"analysis\"\n[mechanism]\n" +
                                                   mechanism + "\n[drive]\nsteps = 7\n" + drive),
                 Run{.threads = 1});
}

template <class T>
std::optional<T> quantity(const AnalysisResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.quantities, name, &Quantity::name);
  if (found == result.quantities.end()) return std::nullopt;
  return std::get<T>(found->value);
}

std::ptrdiff_t landmarks(const AnalysisResult& result, std::string_view kind) {
  return std::ranges::count(result.landmarks, kind, &Landmark::kind);
}

/// A four-bar whose coupler point drives a rocker by a link.
struct SixBar {
  double d[2], e[2], crank, lengths[2];
  const char* assembly;
  double point[2], dyad[2];
};

std::string text_of(const SixBar& s) {
  return fmt::format(R"(type = "chain"
[[pivot]]
name = "A"
at = [0, 0]
[[pivot]]
name = "D"
at = [{:.17g}, {:.17g}]
[[pivot]]
name = "E"
at = [{:.17g}, {:.17g}]
[crank]
at = "A"
pin = "B"
length = {:.17g}
[[dyad]]
type = "RRR"
joins = ["B", "D"]
lengths = [{:.17g}, {:.17g}]
assembly = "{}"
new = "C"
names = ["coupler", "rocker"]
[[point]]
name = "P"
on = ["B", "C"]
at = [{:.17g}, {:.17g}]
[[dyad]]
type = "RRR"
joins = ["P", "E"]
lengths = [{:.17g}, {:.17g}]
assembly = "open"
new = "F"
names = ["link", "output"])",
                     s.d[0], s.d[1], s.e[0], s.e[1], s.crank, s.lengths[0], s.lengths[1],
                     s.assembly, s.point[0], s.point[1], s.dyad[0], s.dyad[1]);
}

// Both numbers by circles in 40 digits. Next to a dead point the output goes with the root of the
// distance from it: half of the digits of an angle are lost where that is rounded.
TEST(MotionEnds, ADeadPointPassedATurnLaterIsOneToAllDigits) {
  const SixBar chain{{0.52054195365253908, -0.56836933841946635},
                     {-0.74949314087532404, -2.6155750526614532},
                     1.2696618399934738,
                     {1.3428681444685844, 1.4742045251117},
                     "crossed",
                     {-0.85984896451478909, 0.31435277895645353},
                     {2.0804393852778551, 1.7731344597679031}};
  const auto result =
      analysed(text_of(chain), "start_deg = -41.935762401090045\nend_deg = 318.06423759890993\n");
  EXPECT_NEAR(quantity<double>(result, "output_swing_deg").value(), 126.704564509123952, 1e-11);
}

TEST(MotionEnds, ADyadBehindOneThatIsDeadHasItsTransmissionAngleToAllDigits) {
  const SixBar chain{{1.1533316039431019, 0.039785358093919143},
                     {1.7239507563976186, 2.2837039654488835},
                     1.2264614781457448,
                     {1.8044047040574913, 2.4443152228899967},
                     "crossed",
                     {1.1894355869221167, 0.98961462621168828},
                     {3.1847645824996915, 1.0150189145058781}};
  const auto result =
      analysed(text_of(chain), "start_deg = 188.92375855793489\nend_deg = 548.92375855793489\n");
  EXPECT_NEAR(quantity<double>(result, "transmission_angle_deg.max").value(), 169.76608880089351,
              1e-11);
}

TEST(MotionEnds, AStrokeWithoutEndIsNoneWhereTheDriveBeginsWithinIt) {
  for (const double start : {83.5, -110.0, 200.0}) {
    for (const double turns : {1.0, -1.0, 2.0}) {
      const auto result =
          analysed("type = \"tangent-generator\"\noffset = -1.35\ndirection_deg = 159.3",
                   fmt::format("start_deg = {}\nend_deg = {}\n", start, start + 360 * turns));
      EXPECT_EQ(quantity<double>(result, "output_stroke"), std::nullopt) << start << " " << turns;
    }
  }
}

// From a change point on: what comes back a turn later does so in the other assembly, and is no
// part of the range.
TEST(MotionEnds, AMotionFromAChangePointOnHasTheSwingOfItsOwnSide) {
  const double a = 2.375, b = 0.46875, c = 1.25, f = 1.59375;
  const auto result = analysed(
      fmt::format("type = \"four-bar\"\nfixed_pivots = [[0, 0], [{}, 0]]\ncrank = {}\ncoupler = "
                  "{}\nrocker = {}\nassembly = \"crossed\"",
                  f, a, b, c),
      "start_deg = 0\nend_deg = 360\n");
  const double in_line = std::acos((f * f + c * c - (a - b) * (a - b)) / (2 * f * c));
  EXPECT_NEAR(quantity<double>(result, "output_swing_deg").value(), 180 - in_line / kDegree, 1e-9);
}

TEST(MotionEnds, ACircuitIsWholeWhereTheMiddleOfTheDriveIsAChangePoint) {
  for (const double crank : {0.5, 1.0, 3.0}) {
    const auto result = analysed(
        fmt::format("type = \"slider-crank\"\ncrank = {0}\ncoupler = {0}\noffset = 0", crank),
        "start_deg = 270\nend_deg = 990\n");
    EXPECT_NEAR(quantity<double>(result, "circuit_stroke").value(), 4 * crank, 1e-12 * crank);
  }
}

// Lengths that make a change point but for a few roundings: class and motion decide alike.
TEST(MotionEnds, TheMotionHasChangePointsWhereTheClassSaysSo) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  std::mt19937_64 random(23);
  const auto dyadic = [&] { return (16 + static_cast<int>(random() % 180)) / 64.0; };
  int at = 0, near = 0;
  while (at + near < 600) {
    const double shorter = dyadic(), offset = dyadic(), parts = static_cast<double>(random() % 40);
    const double longest = shorter + offset, unit = std::ldexp(1.0, std::ilogb(longest));
    std::string mechanism;
    double counted = parts;  // of the tolerance's unit
    switch (random() % 3) {
      case 0:
        mechanism = fmt::format(
            "type = \"slider-crank\"\ncrank = {:.17g}\ncoupler = {:.17g}\n"
            "offset = {:.17g}\nassembly = \"open\"",
            longest + parts * kEps * unit, shorter, offset);
        break;
      case 1:
        mechanism = fmt::format(
            "type = \"guide-bar\"\nfixed_pivots = [[0, 0], [{:.17g}, 0]]\n"
            "crank = {:.17g}\noffset = {:.17g}\nassembly = \"open\"",
            longest + parts * kEps * unit, shorter, offset);
        break;
      default:
        if (shorter == offset) continue;
        counted *= unit / std::max(shorter, offset);
        mechanism = fmt::format(
            "type = \"four-bar\"\nfixed_pivots = [[0, 0], [{:.17g}, 0]]\n"
            "crank = {:.17g}\ncoupler = {:.17g}\nrocker = {:.17g}",
            shorter, shorter, offset, offset - parts * kEps * unit);
    }
    if (counted > 12 && counted < 20) continue;  // the last bit decides
    const auto result = analysed(mechanism, "start_deg = 10\nend_deg = 370\n");
    const auto points =
        landmarks(result, "change point") + landmarks(result, "undetermined change point");
    const bool said = quantity<bool>(result, "change_point").value();
    EXPECT_EQ(said, counted <= 12) << mechanism;
    EXPECT_EQ(said, points > 0) << mechanism;
    ++(said ? at : near);
  }
  EXPECT_GT(at, 100);
  EXPECT_GT(near, 100);
}

}  // namespace
}  // namespace cognate::problems::motion_ends_test
