/// Dwells on a raster against all combinations, each in every assembly, by circle intersections of
/// the test's own at dense crank angles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/dwell/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems::dwell_raster_test {
namespace {

using Plane = std::complex<double>;

constexpr int kPositions = 1440;
constexpr double kOverDegrees = 100, kSwingDegrees = 20, kTransmissionDegrees = 25;
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// The point at these distances from a and b, to the left (1) or the right (−1) of the way; not a
/// number where there is none.
Plane third(Plane a, Plane b, double from_a, double from_b, double side) {
  const double way = std::abs(b - a);
  const double along = (way * way + from_a * from_a - from_b * from_b) / (2 * way);
  return a + (b - a) / way * Plane{along, side * std::sqrt(from_a * from_a - along * along)};
}

/// The angle at `joint`, folded to at most 90 degrees.
double folded(Plane joint, Plane one, Plane other) {
  const double angle = std::abs(std::arg((one - joint) / (other - joint)));
  return std::min(angle, kPi - angle);
}

struct Dimensions {
  double u = 0, v = 0, ef = 0, gf = 0;
};

constexpr double kCrank = 10, kCoupler = 30, kRocker = 25;
constexpr Plane kD{32, 0}, kG{12, 42};

/// Of one assembly the least half band, in degrees; nothing where a limit is broken.
double half_band(const Dimensions& d, double side_c, double side_f) {
  std::vector<double> output;
  double least = kNothing, greatest = -kNothing, transmission = kNothing;
  for (int i = 0; i < kPositions; ++i) {
    const Plane b = std::polar(kCrank, kTurn * i / kPositions);
    const Plane c = third(b, kD, kCoupler, kRocker, side_c);
    const Plane e = b + Plane{d.u, d.v} * (c - b) / kCoupler;
    const Plane f = third(e, kG, d.ef, d.gf, side_f);
    if (std::isnan(f.real())) return kNothing;
    const double turned =
        output.empty() ? 0 : std::remainder(std::arg(f - kG) - output.back(), kTurn);
    output.push_back(output.empty() ? std::arg(f - kG) : output.back() + turned);
    least = std::min(least, output.back());
    greatest = std::max(greatest, output.back());
    transmission = std::min({transmission, folded(c, b, kD), folded(f, e, kG)});
  }
  if (greatest - least < kSwingDegrees * kDegree) return kNothing;
  if (transmission < kTransmissionDegrees * kDegree) return kNothing;
  double best = kNothing;
  const int window = static_cast<int>(kOverDegrees / 360 * kPositions);
  for (int i = 0; i < kPositions; ++i) {
    double low = kNothing, high = -kNothing;
    for (int k = 0; k <= window; ++k) {
      const double angle = output[static_cast<std::size_t>((i + k) % kPositions)];
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    best = std::min(best, 0.5 * (high - low));
  }
  return best / kDegree;
}

double half_band(const Dimensions& d) {
  double best = kNothing;
  for (const double side_c : {1.0, -1.0}) {
    for (const double side_f : {1.0, -1.0}) best = std::min(best, half_band(d, side_c, side_f));
  }
  return best;
}

constexpr std::array kPoint{-10.0, 5.0, 15.0, 25.0};
constexpr std::array kLinks{15.0, 20.0, 25.0, 30.0, 35.0};

double best_of_all() {
  double best = kNothing;
  for (const double u : kPoint) {
    for (const double v : kPoint) {
      for (const double ef : kLinks) {
        for (const double gf : kLinks) best = std::min(best, half_band({u, v, ef, gf}));
      }
    }
  }
  return best;
}

std::string file(std::string_view raster) {
  return fmt::format(R"(
    kind = "function-generation"
    target = {{dwell = [{{over_deg = {}}}], swing_deg_min = {}, output = ["G", "F"]}}
    mechanism = {{type = "chain"}}
    constraints = {{transmission_angle_deg = [{}, {}]}}
    solve = {{starts = 128}}
    raster = {}
    [[pivot]]
    name = "A"
    at = [0, 0]
    [[pivot]]
    name = "D"
    at = [32, 0]
    [[pivot]]
    name = "G"
    at = [12, 42]
    [crank]
    at = "A"
    pin = "B"
    length = 10
    [[dyad]]
    joins = ["B", "D"]
    new = "C"
    lengths = [30, 25]
    [[point]]
    name = "E"
    on = ["B", "C"]
    [[dyad]]
    joins = ["E", "G"]
    new = "F"
  )",
                     kOverDegrees, kSwingDegrees, kTransmissionDegrees, 180 - kTransmissionDegrees,
                     raster);
}

double fact(const Result& result, std::string_view name) {
  return find_quantity(result.quantities, QuantityKey<double>{name}).value_or(-1);
}

TEST(DwellRaster, IsTheBestOfAllCombinations) {
  const auto problem = parse_task<DwellProblem>(
      file("{coupler_point = [-10, 5, 15, 25], length = [15, 20, 25, 30, 35]}"));
  ASSERT_TRUE(problem) << problem.error().front().message;
  const Result result = solve(*problem, {.threads = 2});
  const double best = best_of_all();
  ASSERT_LT(best, kNothing);
  ASSERT_FALSE(result.designs.empty());
  EXPECT_TRUE(all_satisfied(result.designs.front().constraints));
  EXPECT_EQ(fact(result, "raster_combinations"), 400);
  EXPECT_NEAR(result.designs.front().error.max / kDegree, best, 2e-3 * best);
  EXPECT_NEAR(fact(result, "raster_error"), best, 2e-3 * best);
  EXPECT_LE(fact(result, "continuous_error"), fact(result, "raster_error"));
}

TEST(DwellRaster, RefusesWhatItCannotSearch) {
  const auto fault = [](const std::string& text) {
    const auto problem = parse_task<DwellProblem>(text);
    return problem ? std::string() : problem.error().front().message;
  };
  EXPECT_NE(fault(file("{frame = 1}")).find("\"coupler_point\""), std::string::npos)
      << fault(file("{frame = 1}"));
  EXPECT_NE(fault(file("{crank = 1}")).find("puts no dimension"), std::string::npos)
      << fault(file("{crank = 1}"));
  const std::string open =
      "kind = \"function-generation\"\ntarget = {dwell = [{over_deg = 100}]}\n"
      "mechanism = {type = \"stephenson-3\"}\nraster = {length = 1}\n";
  EXPECT_NE(fault(open).find("bounds.length"), std::string::npos) << fault(open);
}

}  // namespace
}  // namespace cognate::problems::dwell_raster_test
