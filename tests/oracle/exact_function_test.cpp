/// Exact function generation from a problem file to its designs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "tests/support/exact_functions.hpp"

namespace cognate::problems::exact_function_test {
namespace {

using namespace exact_functions;

/// The rocker's angle from its start, by the analysis kernel in the design's own assembly.
double output_of(const Design& design, double input) {
  const auto pose = Motion(four_bar(design)).at(*design.metrics.input_start + input);
  return pose ? std::remainder(pose->rocker_angle - *design.metrics.output_start, kTurn) : HUGE_VAL;
}

/// Extremes of the transmission angle by the law of cosines, at many input angles of `sweep`.
Range simulated_transmission(const Design& design, double sweep) {
  const auto [l1, l2, l3, l4] = lengths(four_bar(design));
  constexpr int kSteps = 20000;
  Range range{kPi, 0};
  for (int i = 0; i <= kSteps; ++i) {
    const double input = *design.metrics.input_start + sweep * i / kSteps;
    const double diagonal = l1 * l1 + l4 * l4 - 2 * l1 * l4 * std::cos(input);
    const double angle = std::acos((l2 * l2 + l3 * l3 - diagonal) / (2 * l2 * l3));
    range = {std::min(range.min, angle), std::max(range.max, angle)};
  }
  return range;
}

bool sorted(const Result& result) {
  return std::ranges::is_sorted(result.designs, {},
                                [](const Design& design) { return violation(design.constraints); });
}

TEST(ExactFunction, FivePairsGiveAllLinkagesThePlantedOneAmongThem) {
  int tested = 0;
  const FunctionProblem problem = from_library("five-angle-pairs.toml");
  const Result result = solve(problem, {});
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.designs.size(), 3U);
  EXPECT_TRUE(sorted(result));
  bool planted = false;
  for (const Design& design : result.designs) {
    EXPECT_EQ(design.origin, "exact:freudenstein-5");
    EXPECT_LT(*design.metrics.precision_residual, 1e-14);
    EXPECT_GT(*design.metrics.condition, 1);
    const auto links = lengths(four_bar(design));
    planted = planted || std::abs(links.coupler - 2.8) + std::abs(links.rocker - 2.5) +
                                 std::abs(links.frame - 3) <
                             1e-6;  // the pairs have nine decimals
    if (!design.metrics.defects.empty()) continue;
    ++tested;
    for (const auto& [input, output] : std::get<AnglePairs>(problem.target)) {
      EXPECT_NEAR(output_of(design, input), output, 1e-12);
    }
  }
  EXPECT_TRUE(planted);
  EXPECT_GE(tested, 2);
}

// One start given leaves the other to be found: the planted linkage again.
TEST(ExactFunction, FourPairsWithOneStart) {
  const std::string rows =
      "[[0, 0], [30, 4.23783055], [60, 14.330860419], [90, 26.250533448]]\n"
      "precision_points = 4\n";
  for (const std::string start : {"input_start_deg = 40", "output_start_deg = 93.10234840747"}) {
    const Result result = solve(parsed(pairs_file(rows, "[mechanism]\n" + start + "\n")), {});
    ASSERT_FALSE(result.designs.empty());
    EXPECT_TRUE(std::ranges::any_of(result.designs, [](const Design& design) {
      const auto links = lengths(four_bar(design));
      return std::abs(links.coupler - 2.8) < 1e-5 && std::abs(links.rocker - 2.5) < 1e-5 &&
             std::abs(links.frame - 3) < 1e-5 && design.origin == "exact:freudenstein-4";
    })) << start;
    EXPECT_TRUE(result.families.empty());
  }
}

TEST(ExactFunction, FourPointsAreAFamily) {
  int tested = 0;
  FunctionProblem problem = from_library("sine-four-points.toml");
  const Result by_error = solve(problem, {});
  ASSERT_EQ(by_error.status, Status::solved);
  ASSERT_FALSE(by_error.families.empty());
  for (const Family& family : by_error.families) {
    ASSERT_EQ(family.columns.front().name, "chosen_input_start_deg");
    for (const FamilyColumn& column : family.columns) {
      EXPECT_EQ(column.values.size(), family.columns.front().values.size());
    }
  }
  const Design& best = by_error.designs.front();
  EXPECT_TRUE(all_satisfied(best.constraints));
  // No sample of the family that keeps the limits of transmission is better than the best design.
  for (const Family& family : by_error.families) {
    const auto column = [&](const char* name) -> const std::vector<double>& {
      return std::ranges::find(family.columns, name, &FamilyColumn::name)->values;
    };
    const auto& error = column("max_error_deg");
    const auto& transmission = column("transmission_angle_deg_acute_min");
    for (std::size_t i = 0; i < error.size(); ++i) {
      if (transmission[i] < 30 || !(error[i] > 1e-9)) continue;
      ++tested;
      EXPECT_GE(error[i] * kDegree, best.error.max * (1 - 1e-9)) << i;
    }
  }
  problem.best_by = BestBy::transmission;
  const Result by_angle = solve(problem, {});
  ASSERT_EQ(by_angle.status, Status::solved);
  EXPECT_GE(by_angle.designs.front().metrics.transmission_acute_min,
            best.metrics.transmission_acute_min);
  EXPECT_GE(by_angle.designs.front().error.max, best.error.max * (1 - 1e-9));
  EXPECT_GE(tested, 110);
}

// The precision points are inside the domain: its ends count too.
TEST(ExactFunction, TransmissionIsThatOfTheWholeDomain) {
  int compared = 0;
  for (const char* name : {"log10.toml", "log10-equal-peaks.toml", "sine-four-points.toml"}) {
    const FunctionProblem problem = from_library(name);
    const double sweep = *std::get<FunctionOfX>(problem.target).input_range;
    for (const Design& design : solve(problem, {}).designs) {
      // A crank that turns fully is judged over its full turn.
      if (!design.metrics.defects.empty() || crank_rotates(lengths(four_bar(design)))) continue;
      const Range simulated = simulated_transmission(design, sweep);
      EXPECT_NEAR(design.metrics.transmission_min, simulated.min, 1e-6) << name;
      EXPECT_NEAR(design.metrics.transmission_max, simulated.max, 1e-6) << name;
      ++compared;
    }
  }
  EXPECT_GE(compared, 3);
  FunctionProblem narrow = from_library("log10.toml");
  narrow.constraints.transmission_angle = Range{50 * kDegree, 112 * kDegree};
  EXPECT_EQ(solve(narrow, {}).status, Status::infeasible);
}

// Three points without starts leave two numbers: the best is better than the textbook's guess.
TEST(ExactFunction, ThreePointsChooseTheirStarts) {
  FunctionProblem problem = from_library("log10.toml");
  problem.input_start.reset();
  problem.output_start.reset();
  problem.constraints.transmission_angle = Range{30 * kDegree, 150 * kDegree};
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& best = result.designs.front();
  EXPECT_EQ(best.origin, "exact:freudenstein-3");
  EXPECT_LT(best.error.max / kDegree, 0.1);
  EXPECT_GE(best.metrics.transmission_acute_min / kDegree, 30 - 1e-6);
}

TEST(ExactFunction, ThreePairsWithFreeStarts) {
  const Result result = solve(parsed(pairs_file("[[0, 0], [30, 20], [60, 50]]\n",
                                                "precision_points = 3\n[mechanism]\n"
                                                "start = \"free\"\n[constraints]\n"
                                                "link_ratio_max = 5\n")),
                              {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& best = result.designs.front();
  EXPECT_GT(best.metrics.transmission_acute_min / kDegree, 60);
  for (const double input : {0.0, 30.0, 60.0}) {
    const double wanted = input == 0 ? 0 : input == 30 ? 20 : 50;
    EXPECT_NEAR(output_of(best, input * kDegree) / kDegree, wanted, 1e-9);
  }
}

// Value, slope and curvature of the function are those of the linkage, by differences of its
// motion.
TEST(ExactFunction, DerivativesAreMet) {
  const Result result = solve(from_library("logarithm-by-derivatives.toml"), {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_TRUE(says(result, "found from its values"));
  const Design& design = result.designs.front();
  const double range = 60 * kDegree, unit = range / std::log10(2.0);
  const auto wanted = [&](double input) { return unit * std::log10(1 + input / range); };
  for (const double input : {0.0, 0.5 * range, range}) {
    EXPECT_NEAR(output_of(design, input), wanted(input), 1e-10);
  }
  // The error grows as the cube of the distance from the middle.
  const auto error = [&](double h) {
    return output_of(design, 0.5 * range + h) - wanted(0.5 * range + h);
  };
  EXPECT_NEAR(error(0.02) / error(0.01), 8, 0.5);
  EXPECT_NEAR(error(-0.02) / error(-0.01), 8, 0.5);
}

TEST(ExactFunction, DerivativesOfPairs) {
  int tested = 0;
  const std::string file = pairs_file("[[0, 0], [40, 30]]\n",
                                      "derivatives = [[0.5], [0.9, 0.1]]\nobjective = \"exact\"\n");
  const Result result = solve(parsed(file), {});
  for (const Design& design : result.designs) {
    if (!design.metrics.defects.empty()) continue;
    ++tested;
    const double h = 1e-5, at = 40 * kDegree;
    EXPECT_NEAR((output_of(design, h) - output_of(design, -h)) / (2 * h), 0.5, 1e-8);
    EXPECT_NEAR((output_of(design, at + h) - output_of(design, at - h)) / (2 * h), 0.9, 1e-8);
    const double second =
        (output_of(design, at + 1e-4) - 2 * output_of(design, at) + output_of(design, at - 1e-4)) /
        1e-8;
    EXPECT_NEAR(second, 0.1, 1e-5);
  }
  EXPECT_FALSE(result.designs.empty());
  EXPECT_GE(tested, 1);
}

TEST(ExactFunction, NamesDegeneratePairs) {
  const Result rigid =
      solve(parsed(pairs_file("[[0, 10], [20, 30], [50, 60]]\n", "precision_points = 3\n")), {});
  EXPECT_EQ(rigid.status, Status::no_solution);
  EXPECT_TRUE(rigid.designs.empty());
  EXPECT_TRUE(says(rigid, "turns with the input as one body"));
  // |x| has no slope in its corner.
  const Result corner = solve(
      parsed("kind = \"function-generation\"\n[target]\nfunction = \"abs(x)\"\ndomain = [-1, 2]\n"
             "input_range_deg = 60\noutput_range_deg = 60\nat = [0, 1]\nmultiplicity = [2, 1]\n"
             "[mechanism]\ninput_start_deg = 10\noutput_start_deg = 10\n"),
      {});
  EXPECT_EQ(corner.status, Status::no_solution);
  EXPECT_TRUE(says(corner, "not smooth"));
}

// Any parallelogram turns both links alike; for any number of pairs.
TEST(ExactFunction, EqualTurningIsThatOfAParallelogram) {
  for (const std::string rows : {"[[0, 5], [10, 15], [20, 25]]",
                                 "[[0, 0], [10, 10], [20, 20], "
                                 "[30, 30]]",
                                 "[[0, 0], [10, 10], [20, 20], [30, 30], [40, 40]]"}) {
    const Result result =
        solve(parsed(pairs_file(rows,
                                "objective = \"exact\"\n[mechanism]\nframe = 7\nstart = \"free\"\n"
                                "[constraints]\ntransmission_angle_deg = [45, 135]\n")),
              {});
    ASSERT_EQ(result.status, Status::solved) << rows;
    EXPECT_TRUE(says(result, "any parallelogram"));
    const Design& design = result.designs.front();
    EXPECT_EQ(design.origin, "exact:parallelogram");
    EXPECT_LT(design.metrics.precision_residual.value(), 1e-14);
    EXPECT_DOUBLE_EQ(lengths(four_bar(design)).frame, 7);
    const double ahead = rows.find("[0, 5]") == std::string::npos ? 0 : 5 * kDegree;
    for (double input = 0; input < 20; input += 0.5) {
      EXPECT_NEAR(output_of(design, input * kDegree), input * kDegree + ahead, 1e-12);
    }
  }
}

TEST(ExactFunction, EqualTurningKeepsTheStartThatIsGiven) {
  for (const std::string start : {"input_start_deg = 80\n", "output_start_deg = 80\n"}) {
    const Result result = solve(parsed(pairs_file("[[0, 5], [10, 15], [20, 25]]",
                                                  "objective = \"exact\"\n[mechanism]\n" + start)),
                                {});
    ASSERT_EQ(result.status, Status::solved) << start;
    const Design& design = result.designs.front();
    EXPECT_EQ(design.origin, "exact:parallelogram");
    const auto& metrics = design.metrics;
    EXPECT_NEAR(start[0] == 'i' ? *metrics.input_start : *metrics.output_start, 80 * kDegree,
                1e-14);
    EXPECT_NEAR(output_of(design, 10 * kDegree), 15 * kDegree, 1e-12) << start;
  }
}

TEST(ExactFunction, EqualTurningThatNoParallelogramDoesIsNamed) {
  const std::string head =
      "kind = \"function-generation\"\n[target]\nfunction = \"x\"\ndomain = [0, 1]\n"
      "input_range_deg = 60\noutput_range_deg = ";
  const Result apart = solve(parsed(head + "60\nprecision_points = 3\n[mechanism]\n"
                                           "input_start_deg = 86\noutput_start_deg = 23.5\n"),
                             {});
  EXPECT_EQ(apart.status, Status::no_solution);
  EXPECT_TRUE(says(apart, "three conditions"));
  EXPECT_TRUE(says(apart, "input_start_deg = output_start_deg;"));
  // The other way round there is a limit of long links alone, which does not come first.
  const Result opposite = solve(parsed(head + "-60\nprecision_points = 4\n"), {});
  EXPECT_TRUE(says(opposite, "in the other sense"));
  ASSERT_FALSE(opposite.designs.empty());
  const auto links = lengths(four_bar(opposite.designs.front()));
  EXPECT_LE(std::max(links.coupler, links.frame), 1000.000001);
}

// A crank of negative length is one that starts half a turn off: the start given is not kept.
TEST(ExactFunction, StartsGivenAreChecked) {
  FunctionProblem problem = from_library("log10.toml");
  const auto start_check = [](const Design& design) {
    return *std::ranges::find(design.constraints, "mechanism.input_start_deg",
                              &ConstraintCheck::name);
  };
  const Result kept = solve(problem, {});
  EXPECT_TRUE(start_check(kept.designs.at(0)).satisfied);
  problem.target = parsed(
                       "kind = \"function-generation\"\n[target]\nfunction = \"x\"\n"
                       "domain = [0, 1]\ninput_range_deg = 60\noutput_range_deg = 90\n"
                       "precision_points = 3\n")
                       .target;
  problem.sample_at.clear();
  const Result turned = solve(problem, {});
  EXPECT_EQ(turned.status, Status::infeasible);
  const ConstraintCheck check = start_check(turned.designs.at(0));
  EXPECT_FALSE(check.satisfied);
  EXPECT_NEAR(std::abs(std::get<double>(check.value) - 86), 180, 1e-9);
  EXPECT_TRUE(says(turned, "Design 1: the crank comes out negative"));
}

// A note on one design stands with its number, also where the best one closes.
TEST(ExactFunction, DesignsThatDoNotCloseAreNumbered) {
  const Result result = solve(parsed("kind = \"function-generation\"\n[target]\nfunction = \"x\"\n"
                                     "domain = [0, 1]\ninput_range_deg = 60\n"
                                     "output_range_deg = -60\nprecision_points = 4\n"),
                              {});
  std::string numbers;
  for (const Design& design : result.designs) {
    const FourBar& linkage = four_bar(design);
    bool closes = true;
    for (double input = 0; input <= 60; input += 0.1) {
      closes = closes && Motion(linkage).at(*design.metrics.input_start + input * kDegree);
    }
    if (!closes) numbers += std::to_string(&design - result.designs.data() + 1);
  }
  const auto note = std::ranges::find_if(result.notes, [](const std::string& text) {
    return text.find("the linkage does not close") != std::string::npos;
  });
  ASSERT_NE(note, result.notes.end());
  std::string named;
  for (const char c : note->substr(0, note->find(':'))) {
    if (c >= '0' && c <= '9') named += c;
  }
  EXPECT_EQ(named, numbers);
}

// The textbook's table of seven positions: the fit of Freudenstein's equation leads to the best.
TEST(ExactFunction, SevenPositionsStartFromTheOverlay) {
  const Result result = solve(from_library("seven-positions.toml"), {});
  ASSERT_EQ(result.status, Status::solved);
  const Design& best = result.designs.front();
  EXPECT_EQ(best.origin.rfind("exact:", 0), 0U) << best.origin;
  EXPECT_LT(best.error.max / kDegree, 0.1);
}

// The best of a family lie where they only just close: between the steps of any grid.
TEST(ExactFunction, DesignsOfAFamilyCloseOverTheWholeDomain) {
  const Result result =
      solve(parsed("kind = \"function-generation\"\n[target]\nfunction = \"log(x)\"\n"
                   "domain = [0.8456339139560474, 1.5910067672423553]\ninput_range_deg = 300\n"
                   "output_range_deg = 45\nprecision_points = 3\n"),
            {});
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.designs.size(), 3U);
  for (const Design& design : result.designs) {
    const auto [l1, l2, l3, l4] = lengths(four_bar(design));
    const double start = *design.metrics.input_start, sweep = 300 * kDegree;
    int open = 0;
    for (int i = 0; i <= 30001; ++i) {
      const double d =
          std::sqrt(l1 * l1 + l4 * l4 - 2 * l1 * l4 * std::cos(start + sweep * i / 30001));
      open += d > (l2 + l3) * (1 + 1e-12) || d < std::abs(l2 - l3) * (1 - 1e-12);
    }
    EXPECT_EQ(open, 0);
    // The first two only just close, at a change point.
    const std::string number = "Design " + std::to_string(&design - result.designs.data() + 1);
    EXPECT_EQ(says(result, number + ": the transmission angle is 0 or 180"),
              design.metrics.transmission_acute_min < 1e-3);
  }
}

TEST(ExactFunction, JumpWithinTheDomainIsNoted) {
  const auto noted = [](const char* function) {
    const std::string text =
        std::string("kind = \"function-generation\"\n[target]\nfunction = \"") + function +
        "\"\ndomain = [1, 2]\ninput_range_deg = 60\noutput_range_deg = 40\n"
        "precision_points = 5\n";
    return says(solve(parsed(text), {}), "The function jumps at x = 1.3:");
  };
  EXPECT_TRUE(noted("log(x) + 0.2 * (x > 1.3)"));
  EXPECT_FALSE(noted("log(x)"));
}

}  // namespace
}  // namespace cognate::problems::exact_function_test
