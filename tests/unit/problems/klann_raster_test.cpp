/// Klann's leg on whole hole pitches: its path against the patent's, both by circle intersections
/// of the test's own. Nothing but the numbers of the design and of its placement is taken from the
/// program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::klann_raster_test {
namespace {

using Plane = std::complex<double>;

Plane plane(const Vec2d& p) {
  return {p.x, p.y};
}

/// The point at these distances from a and b, to the left (1) or the right (−1) of the way.
Plane third(Plane a, Plane b, double from_a, double from_b, double side) {
  const double way = std::abs(b - a);
  const double along = (way * way + from_a * from_a - from_b * from_b) / (2 * way);
  return a + (b - a) / way * Plane{along, side * std::sqrt(from_a * from_a - along * along)};
}

/// US 6,260,862.
Plane patent_foot(double crank) {
  const Plane m = Plane{1.599, 0.75} + std::polar(0.268, crank);
  const Plane c = third(m, {1.009, 0.574}, 0.59, 0.3206, -1);
  const Plane d = third(m, c, 1.1051, 0.5221, -1);
  const Plane e = third(d, {1.366, 1.366}, 0.8966, 0.5177, 1);
  return third(d, e, 0.8966, 1.732, -1);
}

struct Leg {
  Plane o, a, b, d, f;  ///< d and f in the axes of their links
  double crank, mc, ac, de, be, side_c, side_e;
};

Plane foot(const Leg& leg, double crank) {
  const Plane m = leg.o + std::polar(leg.crank, crank);
  const Plane c = third(m, leg.a, leg.mc, leg.ac, leg.side_c);
  const Plane d = m + leg.d * (c - m) / leg.mc;
  const Plane e = third(d, leg.b, leg.de, leg.be, leg.side_e);
  return d + leg.f * (e - d) / leg.de;
}

double distance(Plane p, const std::vector<Plane>& closed) {
  double least = 1e9;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const Plane from = closed[i], way = closed[(i + 1) % closed.size()] - from;
    const double share = std::real((p - from) * std::conj(way)) / std::norm(way);
    least = std::min(least, std::abs(p - from - std::clamp(share, 0.0, 1.0) * way));
  }
  return least;
}

double farthest(const std::vector<Plane>& of, const std::vector<Plane>& from) {
  double most = 0;
  for (const Plane p : of) most = std::max(most, distance(p, from));
  return most;
}

Leg leg_of(const Design& design) {
  const auto& chain = std::get<ChainDescription>(design.mechanism.description);
  const auto& points = design.mechanism.extra_points;
  const auto side = [&](int k) { return chain.dyads[k].assembly == Assembly::open ? 1.0 : -1.0; };
  return {.o = plane(chain.pivots[0].at),
          .a = plane(chain.pivots[1].at),
          .b = plane(chain.pivots[2].at),
          .d = plane(points[0].at),
          .f = plane(points[1].at),
          .crank = std::get<CrankDescription>(chain.drive).length,
          .mc = chain.dyads[0].lengths[0],
          .ac = chain.dyads[0].lengths[1],
          .de = chain.dyads[1].lengths[0],
          .be = chain.dyads[1].lengths[1],
          .side_c = side(0),
          .side_e = side(1)};
}

double number(const std::vector<Quantity>& quantities, std::string_view name) {
  return find_quantity(quantities, QuantityKey<double>{name}).value_or(NAN);
}

/// The hand-made leg on whole pitches is 4.1 % of the diagonal off.
TEST(KlannRaster, FollowsThePatentWithinTwoPerCentOfTheDiagonal) {
  const auto problem = read_task<ChainPathProblem>(std::filesystem::path(kLibraryFolder) / "chain" /
                                                   "klann-on-holes.toml");
  ASSERT_TRUE(problem);
  const Result result = solve(*problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& design = result.designs.front();
  const Leg leg = leg_of(design);
  for (const double value : {leg.o.real(), leg.o.imag(), leg.a.real(), leg.a.imag(), leg.b.real(),
                             leg.b.imag(), leg.d.real(), leg.d.imag(), leg.f.real(), leg.f.imag(),
                             leg.crank, leg.mc, leg.ac, leg.de, leg.be}) {
    EXPECT_EQ(value, std::round(value));
  }
  ASSERT_TRUE(design.placement);
  const Plane turn = std::polar(1 / design.placement->scale, -design.placement->turn);
  std::vector<Plane> patent, made;
  for (int k = 0; k < 1440; ++k) {
    patent.push_back(patent_foot(kTurn * k / 1440));
    made.push_back(turn * (foot(leg, kTurn * k / 1440) - plane(design.placement->shift)));
  }
  const double diagonal = std::hypot(1.0087, 0.5273);
  EXPECT_LT(std::max(farthest(patent, made), farthest(made, patent)), 0.02 * diagonal);
  EXPECT_LT(number(result.quantities, "raster_error"), 0.005 * diagonal);
  EXPECT_LE(number(result.quantities, "continuous_error"),
            number(result.quantities, "raster_error"));
  EXPECT_GT(number(result.quantities, "raster_covered"), 0);
  EXPECT_GT(number(result.quantities, "raster_combinations"), 1e16);
  EXPECT_GE(design.metrics.transmission_acute_min, 25 * kTurn / 360);
}

std::string fault_of(const std::string& text) {
  const auto problem = parse_task(text);
  return problem ? "" : problem.error().front().message;
}

TEST(KlannRaster, PathsThatMayBeMovedNeedARasterAndBounds) {
  const std::string target =
      "kind = \"path-generation\"\n[target]\nplace = \"similar\"\npoints = [[0, 0], [1, 0], [1, "
      "1], "
      "[0, 1]]\nclosed = ";
  const std::string rest =
      "[mechanism]\ntype = \"watt-1\"\n[bounds]\nlength = [1, 9]\npivots = [[-9, -9], [9, 9]]\n";
  EXPECT_NE(fault_of(target + "true\n" + rest).find("without [raster]"), std::string::npos);
  EXPECT_NE(fault_of(target + "true\n" + rest + "[raster]\nlength = 1\n").find("without bounds"),
            std::string::npos);
  const std::string bounded = rest + "point = [[-9, -9], [9, 9]]\n[raster]\nlength = 1\n";
  EXPECT_NE(fault_of(target + "false\n" + bounded).find("open or timed"), std::string::npos);
  EXPECT_EQ(fault_of(target + "true\n" + bounded), "");
}

}  // namespace
}  // namespace cognate::problems::klann_raster_test
