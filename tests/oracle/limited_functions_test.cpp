/// Functions that a planted four-bar generates exactly within limits: the search finds it,
/// whichever its seed.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "problems/linkage/result.hpp"
#include "problems/read.hpp"

namespace cognate::problems::limited_functions_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A triple rocker: links, and the input from which it is driven.
struct Planted {
  double crank, coupler, rocker, frame, start, sweep;

  /// The law of cosines at D, C to the left of B -> D.
  double output(double input) const {
    const double bx = crank * std::cos(start + input) - frame, by = crank * std::sin(start + input);
    const double d = std::hypot(bx, by);
    return std::atan2(by, bx) -
           std::acos((rocker * rocker + d * d - coupler * coupler) / (2 * rocker * d));
  }
};

std::string file(const Planted& planted, const std::string& constraints) {
  std::string pairs;
  double last = planted.output(0);
  const double first = last;
  for (int i = 0; i <= 40; ++i) {
    const double input = planted.sweep * i / 40;
    last += std::remainder(planted.output(input) - last, 2 * std::numbers::pi);
    pairs +=
        fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", input / kDegree, (last - first) / kDegree);
  }
  return "kind = \"function-generation\"\n[target]\npairs_deg = [" + pairs +
         "]\nobjective = \"least-squares\"\n[bounds]\ncoupler = [0.05, 20]\n"
         "rocker = [0.05, 20]\nframe = [0.05, 20]\n[constraints]\n" +
         constraints;
}

// Starts whose cranks turn fully reach the same linkage. Had they been limited over a full turn,
// which no triple rocker makes, most seeds would leave it again.
TEST(LimitedFunctions, OfTripleRockersAreLimitedOverTheirOwnMotion) {
  const Planted wide{1,
                     0.39939605872983,
                     0.92566122998717,
                     0.446491120000113,
                     0.0426194268,
                     91.36588896 * kDegree};
  const Planted narrow{1, 0.9377989662952, 1.1471577774542, 0.9631843157649, 1.1, 55 * kDegree};
  int solved = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    for (const bool first : {true, false}) {
      const auto problem =
          parse_task(file(first ? wide : narrow,
                          std::string("class = \"triple-rocker\"\ntransmission_angle_deg = ") +
                              (first ? "[14.440, 111.128]\nlink_ratio_max = 2.754\n"
                                     : "[40, 130]\nlink_ratio_max = 1.346\n")));
      ASSERT_TRUE(problem);
      const Result result =
          solve(std::get<FunctionProblem>(*problem), {.seed = std::uint64_t(seed)});
      ASSERT_EQ(result.status, Status::solved) << seed;
      EXPECT_LT(result.designs.front().error.rms, 1e-9) << seed << first;
      ++solved;
    }
  }
  EXPECT_EQ(solved, 12);
}

}  // namespace
}  // namespace cognate::problems::limited_functions_test
