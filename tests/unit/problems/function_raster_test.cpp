/// Function generators on a raster against all combinations: searched with all lengths given, and
/// by triangles and scans of the test's own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/read_problems.hpp"

namespace cognate::problems::function_raster_test {
namespace {

using test::flag;
using test::number;
using test::problem_of;

/// max over α, φ starts by scans of its own would be long: the objective at the optimum of each
/// combination comes from a second search, with all lengths given.
TEST(FunctionRaster, IsTheBestOfAllCombinations) {
  const std::string head =
      "kind = \"function-generation\"\n[target]\nfunction = \"log10(x)\"\ndomain = [1, 2]\n"
      "input_range_deg = 60\noutput_range_deg = 90\nobjective = \"least-squares\"\nsamples = 9\n"
      "[mechanism]\nframe = 4\n";
  const auto problem = problem_of<FunctionProblem>(
      head +
      "[raster]\ncrank = [2.5, 3, 3.5]\ncoupler = [2, 3]\nrocker = [1.5, 2]\n[bounds]\nlength = "
      "[0.5, 9]\n[solve]\ndesigns = 1\nstarts = 60\n");
  const Result result = solve(problem, {.threads = 1});
  ASSERT_EQ(result.status, Status::solved);
  double best = std::numeric_limits<double>::infinity();
  for (const double crank : {2.5, 3.0, 3.5}) {
    for (const double coupler : {2.0, 3.0}) {
      for (const double rocker : {1.5, 2.0}) {
        const auto one = problem_of<FunctionProblem>(
            head + fmt::format("crank = {}\ncoupler = {}\nrocker = {}\n[solve]\nstarts = 100\n",
                               crank, coupler, rocker));
        const Result alone = solve(one, {.threads = 1});
        if (alone.status != Status::solved) continue;
        best = std::min(best, alone.designs.front().error.sum_of_squares);
      }
    }
  }
  EXPECT_NEAR(result.designs.front().error.sum_of_squares, best, 1e-6 * best);
  EXPECT_EQ(number(result, "raster_combinations"), 12);
}

/// Largest error at the samples for one linkage, by the textbook's triangle, over both assemblies,
/// a grid of input angles made finer and finer, and the output angle in the middle of the errors.
class FunctionScan {
 public:
  FunctionScan(std::array<double, 4> lengths, int side) : lengths_(lengths), side_(side) {}

  double at(double start) const {
    double least = 1e9, greatest = -1e9, before = 0;
    for (int i = 0; i < 9; ++i) {
      const double share = i / 8.0;
      const auto output = output_at(start + share * 60 * kRadian);
      if (!output) return 1e9;
      const double near = i == 0 ? *output : before + std::remainder(*output - before, kTurn);
      before = near;
      const double error = near - 90 * kRadian * std::log10(1 + share) / std::log10(2.0);
      least = std::min(least, error);
      greatest = std::max(greatest, error);
    }
    return 0.5 * (greatest - least);
  }

  double best() const {
    double best = 1e9, where = 0;
    for (int k = 0; k < 7200; ++k) look(kTurn * k / 7200, best, where);
    for (double step = kTurn / 7200; step > 1e-12; step *= 0.5) {
      const double from = where;
      look(from - step, best, where);
      look(from + step, best, where);
    }
    return best;
  }

 private:
  static constexpr double kRadian = kTurn / 360;

  void look(double start, double& best, double& where) const {
    const double value = at(start);
    if (value >= best) return;
    best = value;
    where = start;
  }

  std::optional<double> output_at(double input) const {
    const auto [crank, coupler, rocker, frame] = lengths_;
    const double x = crank * std::cos(input) - frame, y = crank * std::sin(input);
    const double square = x * x + y * y;
    const double cosine =
        (square + rocker * rocker - coupler * coupler) / (2 * rocker * std::sqrt(square));
    if (std::abs(cosine) > 1) return std::nullopt;
    return std::atan2(y, x) + side_ * std::acos(cosine);
  }

  std::array<double, 4> lengths_;
  int side_;
};

TEST(FunctionRaster, OfLeastLargestErrorIsTheBestOfAllCombinations) {
  const auto problem = problem_of<FunctionProblem>(
      "kind = \"function-generation\"\n[target]\nfunction = \"log10(x)\"\ndomain = [1, 2]\n"
      "input_range_deg = 60\noutput_range_deg = 90\nobjective = \"minimax\"\nsamples = 9\n"
      "[mechanism]\nframe = 4\n"
      "[raster]\ncrank = [2.5, 3, 3.5]\ncoupler = [2, 3]\nrocker = [1.5, 2]\n[bounds]\nlength = "
      "[0.5, 9]\n[constraints]\nno_branch_defect = false\nno_order_defect = false\n"
      "no_circuit_defect = false\n[solve]\ndesigns = 1\nstarts = 60\n");
  const Result result = solve(problem, {.threads = 1});
  ASSERT_EQ(result.status, Status::solved);
  double best = 1e9;
  for (const double crank : {2.5, 3.0, 3.5}) {
    for (const double coupler : {2.0, 3.0}) {
      for (const double rocker : {1.5, 2.0}) {
        for (const int side : {-1, 1}) {
          best = std::min(best, FunctionScan({crank, coupler, rocker, 4}, side).best());
        }
      }
    }
  }
  EXPECT_NEAR(number(result, "raster_error"), best * 360 / kTurn, 1e-6);
  // Between the samples it may be larger.
  EXPECT_GE(result.designs.front().error.max, best - 1e-9);
  EXPECT_TRUE(flag(result, "raster_proven"));
}

TEST(FunctionRaster, LengthsThatStayFreeBesideItAreNoProof) {
  const std::string file =
      "kind = \"function-generation\"\n[target]\nfunction = \"log10(x)\"\ndomain = [1, 2]\n"
      "input_range_deg = 60\noutput_range_deg = 60\n[bounds]\nlength = [0.5, 9]\n[solve]\nstarts = "
      "30\n[raster]\ncrank = [1, 2]\ncoupler = [2, 3]\nrocker = [1.5, 2]\nframe = ";
  const auto proven = [&](const std::string& frame) {
    const Result result = solve(problem_of<FunctionProblem>(file + frame + "\n"), {.threads = 1});
    return flag(result, "raster_proven");
  };
  EXPECT_TRUE(proven("[2, 4]"));
  EXPECT_FALSE(proven("\"free\""));
}

/// The rocker is free: from the minima without a raster its best length is not reached. As good as
/// the better combination given in a file of its own, and by transmission angles within their
/// limit.
TEST(FunctionRaster, LengthsThatStayFreeBesideItAreSearchedForByThemselves) {
  const std::string file =
      "kind = \"function-generation\"\n[target]\nfunction = \"1/x\"\ndomain = [1, 2]\n"
      "input_range_deg = 120\noutput_range_deg = 40\nsamples = 21\n[constraints]\n"
      "transmission_angle_deg = [50, 130]\n[mechanism]\ncrank = 1\n";
  const Result on_raster = solve(
      problem_of<FunctionProblem>(file + "[raster]\nframe = [0.42, 1.56]\ncoupler = [1.13]\n"),
      {.threads = 2});
  const Result given =
      solve(problem_of<FunctionProblem>(file + "frame = 1.56\ncoupler = 1.13\n"), {.seed = 7});
  ASSERT_EQ(on_raster.status, Status::solved);
  ASSERT_EQ(given.status, Status::solved);
  EXPECT_LE(on_raster.designs.front().error.rms, given.designs.front().error.rms * (1 + 1e-6));
}

}  // namespace
}  // namespace cognate::problems::function_raster_test
