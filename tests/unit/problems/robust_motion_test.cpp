/// Robust body guidance judged by samples and corners of the test's own: triangles by the law of
/// cosines, a generator and a search for the nearest crank angle that share nothing with the
/// program's.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/guidance/design.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/support/changed_four_bar.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::robust_motion_test {
namespace {

using Numbers = std::vector<double>;

constexpr std::size_t kDimensions = 6;

double fact(const Result& result, std::string_view name) {
  return find_quantity(result.quantities, QuantityKey<double>{name}).value_or(-1);
}

/// A design, its poses, and how far the crank may go to meet one; at the first and the last it may
/// have to stand as designed.
struct Judged {
  const MotionProblem& problem;
  const Design& design;
  double reach = 0.1;
  bool holds_ends = false;

  double miss(const Numbers& changes, std::size_t pose, double angle) const {
    const auto body = test::changed_body(four_bar(design), changes, angle);
    const double turned = body.angle + *find_quantity(design.metrics.quantities, kBodyAngleKey) -
                          problem.poses[pose].angle;
    return std::hypot(body.at.x - problem.poses[pose].at.x, body.at.y - problem.poses[pose].at.y,
                      problem.angle_weight * std::remainder(turned, 2 * std::acos(-1.0)));
  }

  /// The greatest error over the poses, the crank following within its reach; infinite where the
  /// linkage cannot be assembled.
  double error(const Numbers& changes) const {
    constexpr double kGolden = 0.3819660112501051;
    double greatest = 0;
    for (std::size_t j = 0; j < problem.poses.size(); ++j) {
      const bool is_end = j == 0 || j + 1 == problem.poses.size();
      const double follows = holds_ends && is_end ? 0 : reach;
      double low = design.crank_angles[j] - follows, high = design.crank_angles[j] + follows;
      double one = low + kGolden * (high - low), two = high - kGolden * (high - low);
      double at_one = miss(changes, j, one), at_two = miss(changes, j, two);
      for (int i = 0; i < 18; ++i) {
        if (at_one < at_two) {
          high = two, two = one, at_two = at_one;
          one = low + kGolden * (high - low), at_one = miss(changes, j, one);
        } else {
          low = one, one = two, at_one = at_two;
          two = high - kGolden * (high - low), at_two = miss(changes, j, two);
        }
      }
      const double least = std::min(at_one, at_two);
      if (!(least <= greatest)) greatest = least;
    }
    return std::isnan(greatest) ? std::numeric_limits<double>::infinity() : greatest;
  }
};

/// A quantile of the errors of samples, and its standard error by the spread of the ranks near it.
struct Quantile {
  double value = 0, standard_error = 0;
};

Quantile quantile(const Judged& judged, double tolerance, double share) {
  constexpr std::size_t kSamples = 40'000;
  std::mt19937_64 random(4711);
  std::normal_distribution<double> normal(0, tolerance / 3);
  Numbers errors;
  for (std::size_t k = 0; k < kSamples; ++k) {
    Numbers changes(kDimensions);
    for (double& change : changes) change = normal(random);
    errors.push_back(judged.error(changes));
  }
  std::ranges::sort(errors);
  const double rank = share * double(kSamples);
  const double spread = std::sqrt(rank * (1 - share));
  const auto at = [&](double place) { return errors[static_cast<std::size_t>(place)]; };
  return {at(rank), 0.5 * (at(rank + spread) - at(rank - spread))};
}

/// The greatest error at the corners of the box of ±`tolerance`, the rocker's ±`of_rocker`.
double at_corners(const Judged& judged, double tolerance, double of_rocker) {
  double worst = 0;
  for (unsigned corner = 0; corner < 1U << kDimensions; ++corner) {
    Numbers changes(kDimensions);
    for (std::size_t i = 0; i < kDimensions; ++i) {
      const double most = i == 2 ? of_rocker : tolerance;
      changes[i] = (corner >> i & 1U) != 0 ? most : -most;
    }
    worst = std::max(worst, judged.error(changes));
  }
  return worst;
}

std::filesystem::path tray_file() {
  return std::filesystem::path(kLibraryFolder) / "motion/tipping-tray-robust.toml";
}

MotionProblem tray(int starts) {
  auto problem = read_task<MotionProblem>(tray_file()).value();
  problem.solve.starts = starts;
  problem.tolerances->samples = 0;  // of the figures that every design has
  return problem;
}

void expect_front(const Result& result, std::string_view figure) {
  ASSERT_EQ(result.families.size(), 1U);
  const auto& columns = result.families.front().columns;
  EXPECT_EQ(columns[1].name, figure);
  EXPECT_TRUE(std::ranges::is_sorted(columns[0].values));
  EXPECT_TRUE(std::ranges::is_sorted(columns[1].values, std::ranges::greater{}));
  EXPECT_EQ(columns[0].values.size(), result.designs.size());
}

TEST(RobustMotion, TrayErrsFarLessThanTheNominalOptimum) {
  const MotionProblem problem = tray(100);
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_quantile"), nominal = fact(result, "nominal_quantile");
  EXPECT_LT(robust, 0.65 * nominal);
  EXPECT_EQ(fact(result, "robust_samples"), 1e6);
  expect_front(result, "quantile");
  const Quantile of_robust = quantile({problem, result.designs.front()}, 0.6, 0.99);
  const Quantile of_nominal = quantile({problem, result.designs.back()}, 0.6, 0.99);
  EXPECT_NEAR(of_robust.value, robust, 4 * of_robust.standard_error);
  EXPECT_NEAR(of_nominal.value, nominal, 4 * of_nominal.standard_error);
  EXPECT_LT(of_robust.standard_error, 0.01 * robust);
  EXPECT_LT(of_robust.value, of_nominal.value);
  for (const Design& design : result.designs) {
    EXPECT_TRUE(all_satisfied(design.constraints));
    EXPECT_EQ(design.origin, "robust");
    // Without changes the test's own errors are those of the design.
    const Judged judged{problem, design, 0};
    double squares = 0;
    for (std::size_t j = 0; j < problem.poses.size(); ++j) {
      squares += std::pow(judged.miss(Numbers(kDimensions), j, design.crank_angles[j]), 2);
    }
    EXPECT_NEAR(std::sqrt(squares / 6), design.error.rms, 1e-9);
  }
}

/// The tray of least worst case.
MotionProblem worst_tray() {
  MotionProblem problem = tray(60);
  problem.solve.robust = 1;
  return problem;
}

TEST(RobustMotion, SameForAnyNumberOfThreads) {
  const MotionProblem problem = worst_tray();
  const Result one = solve(problem, {.threads = 1}), two = solve(problem, {.threads = 2});
  ASSERT_EQ(one.designs.size(), two.designs.size());
  ASSERT_GT(one.designs.size(), 1U);
  EXPECT_EQ(fact(one, "robust_worst_case"), fact(two, "robust_worst_case"));
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(four_bar(one.designs[i]).crank, four_bar(two.designs[i]).crank);
    EXPECT_EQ(one.designs[i].crank_angles, two.designs[i].crank_angles);
  }
}

/// A pivot given, which either link may have, a length without tolerance, and a limit between the
/// ends of the motion, at which the crank then stands.
TEST(RobustMotion, KeepsWhatIsGivenAndLimitedInTheWorstCase) {
  const auto read = parse_task<MotionProblem>(
      "kind = \"motion-generation\"\n[target]\nmethod = \"least-squares\"\n"
      "poses = [[0, 0, 0], [12, 9, 8], [23, 14, 21], [32, 15, 38], [41, 12, 55], [48, 6, 70]]\n"
      "angle_weight = 20\n[mechanism]\nfixed_pivots = [[18, -27]]\n"
      "[bounds]\nlength = [3, 120]\n[constraints]\ntransmission_angle_deg = [40, 140]\n"
      "[tolerance]\nlength = 0.5\nrocker = 0\n[solve]\nrobust = \"worst\"\nstarts = 120\n");
  ASSERT_TRUE(read) << read.error().front().message;
  const Result result = solve(*read, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_worst_case");
  const double nominal = fact(result, "nominal_worst_case");
  EXPECT_LE(robust, nominal);
  expect_front(result, "worst_case");
  for (const Design& design : result.designs) {
    const FourBar& bar = four_bar(design);
    const bool is_a = bar.pivot_a == Vec2d{18, -27}, is_d = bar.pivot_d == Vec2d{18, -27};
    EXPECT_TRUE(is_a || is_d);
    EXPECT_GE(design.metrics.transmission_min, 40 * kDegree - 1e-9);
    EXPECT_LE(design.metrics.transmission_max, 140 * kDegree + 1e-9);
    EXPECT_TRUE(design.metrics.defects.empty());
    EXPECT_EQ(mobility_class(lengths(bar)), MobilityClass::triple_rocker);
    const double worst =
        *find_quantity(design.metrics.quantities, QuantityKey<double>{"worst_case"});
    EXPECT_NEAR(at_corners({*read, design, 0.1, true}, 0.5, 0), worst, 1e-3 * worst);
  }
}

/// A number from −1 to 1.
double share(std::mt19937_64& random) {
  return 2 * static_cast<double>(random() >> 11U) * 0x1p-53 - 1;
}

/// Links, body and pivots moved by up to `by` of the frame.
Design moved(Design design, double by, std::mt19937_64& random) {
  FourBar bar = four_bar(design);
  const double step = by * std::hypot(bar.pivot_d.x - bar.pivot_a.x, bar.pivot_d.y - bar.pivot_a.y);
  for (double* length : {&bar.crank, &bar.coupler, &bar.rocker}) *length += step * share(random);
  for (Vec2d* place : {&bar.pivot_a, &bar.pivot_d, &*bar.coupler_point}) {
    *place = *place + step * Vec2d{share(random), share(random)};
  }
  design.mechanism.description = bar;
  return design;
}

TEST(RobustMotion, WorstCaseIsThatOfItsCornersAndNoNeighbourHasLess) {
  const MotionProblem problem = worst_tray();
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_worst_case");
  const double nominal = fact(result, "nominal_worst_case");
  EXPECT_LT(robust, 0.8 * nominal);
  expect_front(result, "worst_case");
  const Design& first = result.designs.front();
  EXPECT_NEAR(at_corners({problem, first}, 0.6, 0.6), robust, 1e-4 * robust);
  EXPECT_NEAR(at_corners({problem, result.designs.back()}, 0.6, 0.6), nominal, 1e-4 * nominal);
  std::mt19937_64 random(11);
  int judged = 0;
  for (int k = 0; k < 600; ++k) {
    const Design near = moved(first, 0.01 * std::pow(10, -double(k % 3)), random);
    const FourBar& bar = four_bar(near);
    const double frame = std::hypot(bar.pivot_d.x - bar.pivot_a.x, bar.pivot_d.y - bar.pivot_a.y);
    if (std::max({bar.crank, bar.coupler, bar.rocker, frame}) > 80) continue;
    EXPECT_GE(at_corners({problem, near, 0.2}, 0.6, 0.6), robust * (1 - 1e-3));
    ++judged;
  }
  EXPECT_GT(judged, 100);
}

/// A stop that comes while robust designs are sought: what is known by then.
TEST(RobustMotion, ASearchThatIsStoppedJudgesByFewerSamples) {
  const MotionProblem problem = tray(40);
  std::atomic<bool> stop = false;
  Numbers shares;
  const Result result =
      solve(problem, {.threads = 1, .interrupted = &stop, .progress = [&](double share, double) {
                        shares.push_back(share);
                        stop = share > 0.8;
                      }});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_TRUE(std::ranges::is_sorted(shares)) << testing::PrintToString(shares);
  EXPECT_LE(shares.back(), 1);
  EXPECT_EQ(fact(result, "robust_samples"), 30'000);
  EXPECT_FALSE(result.designs.empty());
  stop = true;
  EXPECT_EQ(solve(problem, {.threads = 1, .interrupted = &stop}).status, Status::interrupted);
}

TEST(RobustMotion, SaysWhereGradesHaveNoTolerance) {
  MotionProblem problem = worst_tray();
  problem.tolerances->length = ToleranceGrade::it8;
  problem.length_unit = LengthUnit::m;  // links of 80 m
  const Result result = solve(problem, {});
  EXPECT_EQ(result.status, Status::no_solution);
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes.front().find("grades"), std::string::npos) << result.notes.front();
}

std::string fault(const std::string& text) {
  const auto problem = parse_task<MotionProblem>(text);
  return problem ? std::string() : problem.error().front().message;
}

TEST(RobustMotion, RefusesWhatMakesNoSense) {
  const std::string poses =
      "kind = \"motion-generation\"\n[target]\n"
      "poses = [[0, 0, 0], [12, 9, 8], [23, 14, 21], [32, 15, 38], [41, 12, 55], [48, 6, 70]]\n";
  const std::string off = "[tolerance]\nlength = 0.1\n", robust = "[solve]\nrobust = 0.9\n";
  EXPECT_EQ(fault(poses + off + robust), "");
  const std::pair<std::string, std::string> wrong[] = {
      {poses + robust, "tolerance"},
      {poses + "[tolerance]\nclearance = {B = 0.02}\n" + robust, "no length has a tolerance"},
      {poses + "[tolerance]\nlength = 0\nclearance = {B = 0.02}\n" + robust,
       "no length has a tolerance"},
      {poses + off + "[solve]\nrobust = 0.4\n", "0.5 to 0.9999"},
      {poses + off + "[solve]\nrobust = \"best\"\n", "\"worst\""},
      {poses + off + "pivots = 0.1\n" + robust, "tolerance.pivots"},
      {poses + off + "[raster]\nlength = 1\n" + robust, "raster"},
      {poses + off + "[mechanism]\ndyads = [\"RR\", \"PR\"]\n" + robust, "RR"},
      {poses + off + robust + "objectives = [\"error\", \"size\"]\n", "objectives"},
      {poses + off + robust + "certify = true\n", "certify"},
      {"kind = \"motion-generation\"\n[target]\nposes = [[0, 0, 0], [2, 1, 20], [4, 1, 50]]\n" +
           off + robust,
       "least-squares"}};
  int refused = 0;
  for (const auto& [text, word] : wrong) {
    EXPECT_NE(fault(text).find(word), std::string::npos) << text << fault(text);
    ++refused;
  }
  EXPECT_EQ(refused, 11);
  const auto problem = parse_task<MotionProblem>(poses + off + robust);
  EXPECT_EQ(problem->dyads, std::vector{synthesis::DyadKind::rr});
  EXPECT_TRUE(KindTraits<MotionProblem>::checked(*problem));
}

}  // namespace
}  // namespace cognate::problems::robust_motion_test
