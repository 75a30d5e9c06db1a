/// Models of chains: their derivatives against differences, and what they say of planted designs.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/chain/model.hpp"
#include "problems/chain/starts/heading.hpp"
#include "problems/chain_function/model.hpp"
#include "problems/dwell/model.hpp"
#include "synthesis/optimise/check_derivatives.hpp"
#include "tests/support/six_bars.hpp"

namespace cognate::problems::chain_model_test {
namespace {

using test::six_bars;
using test::SixBar;

Topology topology_of(const SixBar& six_bar) {
  Topology topology{.name = std::string(six_bar.name), .trace = test::kTracedLine};
  for (const auto& line : six_bar.chain.lines) {
    topology.lines.push_back(
        {.name = std::string(1, char('a' + topology.lines.size())), .line = line});
  }
  return topology;
}

/// The path of a six-bar, its points moved by some hundredths.
ChainPathProblem path_of(const SixBar& six_bar, bool timed) {
  ChainPathProblem problem;
  problem.topologies = {topology_of(six_bar)};
  problem.closed = !timed;
  problem.constraints.transmission_angle = {kPi / 5, kPi - kPi / 5};
  const auto lines = placed_lines(six_bar.chain);
  const std::vector<double> side(six_bar.design.side.begin(), six_bar.design.side.end());
  synthesis::ChainPlace<double> place;
  for (int j = 0; j < 12; ++j) {
    const double angle = kTurn * j / 12;
    synthesis::place(synthesis::ChainView<double>{lines.data(), static_cast<int>(lines.size()),
                                                  six_bar.design.parameters.data(), side.data()},
                     unit_vector(angle), place);
    const Vec2d off{0.03 * std::sin(5.0 * j), 0.02 * std::cos(3.0 * j)};
    problem.points.push_back(place.at[test::kTracedLine] + off);
    if (timed) problem.crank_angles.push_back(angle);
  }
  return problem;
}

TEST(ChainPathModel, DerivativesAreThoseOfTheValues) {
  int checked = 0;
  for (const SixBar& six_bar : six_bars()) {
    for (const bool timed : {false, true}) {
      SCOPED_TRACE(std::string(six_bar.name) + (timed ? " timed" : " free"));
      const ChainPathProblem problem = path_of(six_bar, timed);
      const ScaledChain scaled(problem, problem.topologies.front(), TargetScale{});
      std::vector<double> angles;
      for (int j = 0; j < (timed ? 1 : 12); ++j) angles.push_back(0.02 + kTurn * j / 12);
      const ChainPathModel model(scaled, six_bar.design, angles, {},
                                 {{six_bar.first_joint, 0.7}, {six_bar.second_joint, 3.1}}, 0.01);
      const auto x = model.start();
      const auto error = synthesis::check_derivatives(model, x);
      ASSERT_TRUE(error.has_value);
      EXPECT_LT(error.relative, 1e-8) << error.describe(model);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 8);
}

TEST(ChainPathModel, DerivativesOfAPathThatMayBeMovedAreThoseOfTheValues) {
  for (const SixBar& six_bar : six_bars()) {
    SCOPED_TRACE(std::string(six_bar.name));
    ChainPathProblem problem = path_of(six_bar, false);
    problem.is_movable = true;
    const ScaledChain scaled(problem, problem.topologies.front(), TargetScale{});
    std::vector<double> angles;
    for (int j = 0; j < 12; ++j) angles.push_back(0.02 + kTurn * j / 12);
    const ChainPathModel model(scaled, six_bar.design, angles, {{0.7, -0.4}, {0.3, 1.1}},
                               {{six_bar.first_joint, 0.7}, {six_bar.second_joint, 3.1}}, 0.01);
    const auto error = synthesis::check_derivatives(model, model.start());
    ASSERT_TRUE(error.has_value);
    EXPECT_LT(error.relative, 1e-8) << error.describe(model);
  }
}

TEST(ChainPathModel, DerivativesOfAMotionAreThoseOfTheValues) {
  for (const SixBar& six_bar : six_bars()) {
    for (const bool timed : {false, true}) {
      SCOPED_TRACE(std::string(six_bar.name) + (timed ? " timed" : " free"));
      const ChainPathProblem problem = path_of(six_bar, timed);
      ScaledChain scaled(problem, problem.topologies.front(), TargetScale{});
      std::vector<double> wanted, angles;
      for (int j = 0; j < 12; ++j) wanted.push_back(0.9 * std::sin(2.0 * j));
      for (int j = 0; j < (timed ? 1 : 12); ++j) angles.push_back(0.02 + kTurn * j / 12);
      scaled.add_headings(wanted, 0.7);
      synthesis::ChainDesign design = six_bar.design;
      design.parameters.push_back(0.3);
      design.side.push_back(0);
      const ChainPathModel model(scaled, design, angles, {}, {{six_bar.first_joint, 0.7}}, 0.01);
      EXPECT_EQ(model.residual_count(), 36);
      const auto error = synthesis::check_derivatives(model, model.start());
      ASSERT_TRUE(error.has_value);
      EXPECT_LT(error.relative, 1e-8) << error.describe(model);
    }
  }
}

/// What is left of a body turned by `turn` in its link where its directions are `wanted`.
double missed(const ScaledChain& problem, const synthesis::ChainDesign& design, double turn,
              std::span<const double> cranks) {
  synthesis::ChainDesign turned = design;
  turned.parameters.back() = turn;
  const std::vector<double> side(design.side.begin(), design.side.end());
  FreeChain chain(problem, turned.parameters, side);
  double square = 0;
  for (std::size_t j = 0; j < cranks.size(); ++j) {
    chain.at(cranks[j]);
    const double off = chain.turned(problem.headings.line, problem.headings.directions[j]);
    square += 4 * std::sin(off / 2) * std::sin(off / 2) / double(cranks.size());
  }
  return square * problem.headings.weight * problem.headings.weight;
}

TEST(TurnBody, IsTheLeastOfAllTurns) {
  for (const SixBar& six_bar : six_bars()) {
    SCOPED_TRACE(std::string(six_bar.name));
    const ChainPathProblem path = path_of(six_bar, false);
    ScaledChain problem(path, path.topologies.front(), TargetScale{});
    std::vector<double> wanted, cranks;
    std::vector<std::size_t> which;
    for (std::size_t j = 0; j < 12; ++j) {
      wanted.push_back(2.5 + 1.5 * std::sin(2.0 * double(j)));
      cranks.push_back(kTurn * double(j) / 12);
      which.push_back(j);
    }
    problem.add_headings(wanted, 0.7);
    synthesis::ChainDesign design = six_bar.design;
    design.parameters.push_back(0);
    design.side.push_back(0);
    const double least = turn_body(problem, which, cranks, design);
    EXPECT_NEAR(least, missed(problem, design, design.parameters.back(), cranks), 1e-12);
    for (double turn = -3.1; turn < 3.2; turn += 0.01) {
      EXPECT_GE(missed(problem, design, turn, cranks), least - 1e-12);
    }
  }
}

/// A dwell of 100 degrees with a known design: half band 0.001863°, window from 211.23°.
struct KnownDwell {
  DwellProblem problem;
  DwellDesign design{{{0, 0, 4.983729, 0, 1, 1.325787, 4.907122, 1.321734, 0.059699, -1.136236,
                       1.848067, 2.208432, 1.478421},
                      {0, 0, 0, 1, 0, 0, 1}},
                     {211.23 * kPi / 180}};

  KnownDwell() {
    problem.topologies = function_topologies("stephenson-3");
    problem.dwells = {{100 * kPi / 180, {}, {}}};
    problem.swing_min = 59.9 * kPi / 180;
    problem.constraints.transmission_angle = {39.9 * kPi / 180, 140.1 * kPi / 180};
  }
};

TEST(DwellModel, HalfBandOfAKnownDesign) {
  const KnownDwell known;
  const DwellSpace space(known.problem, known.problem.topologies.front());
  ASSERT_EQ(space.given.size(), known.design.chain.parameters.size());
  const DwellModel model(space, known.design, {}, 65, kPi / 180);
  std::vector<double> residuals(static_cast<std::size_t>(model.residual_count()));
  ASSERT_TRUE(model.residuals(model.start(), residuals, {}, {}));
  double half_band = 0;
  for (const double residual : residuals) half_band = std::max(half_band, std::abs(residual));
  EXPECT_NEAR(half_band, 0.001863, 2e-5);
}

TEST(DwellModel, DerivativesAreThoseOfTheValues) {
  const KnownDwell known;
  const DwellSpace space(known.problem, known.problem.topologies.front());
  const DwellModel model(space, known.design, {{{3, 1.0}, {6, 4.0}}, 2.0, 5.0}, 17, 0.01);
  const auto error = synthesis::check_derivatives(model, model.start());
  ASSERT_TRUE(error.has_value);
  EXPECT_LT(error.relative, 1e-7) << error.describe(model);
}

/// A function that the known design errs from by some degrees.
ChainFunctionProblem some_function() {
  ChainFunctionProblem problem;
  problem.topologies = function_topologies("stephenson-3");
  problem.objective = FunctionObjective::minimax;
  problem.target = AnglePairs{{-0.3, 0.5}, {0.2, 0.2}, {0.9, -0.1}, {1.4, -0.3}, {2.1, -0.35}};
  return problem;
}

TEST(ChainFunctionModel, DerivativesAreThoseOfTheValues) {
  const auto problem = some_function();
  const ChainFunctionSpace space(problem, problem.topologies.front(), function_samples(problem));
  const ChainFunctionDesign design{KnownDwell().design.chain, 0.4};
  const ChainFunctionModel model(space, design, {{3, 1.0}, {6, 1.9}}, space.fine,
                                 synthesis::Objective::sum_of_squares);
  auto x = model.start();
  x.back() += 0.02;
  const auto error = synthesis::check_derivatives(model, x);
  ASSERT_TRUE(error.has_value);
  EXPECT_LT(error.relative, 1e-7) << error.describe(model);
}

TEST(ChainFunctionModel, HasNoValueWhereItBeganWithAChainThatDoesNotClose) {
  const auto problem = some_function();
  const ChainFunctionSpace space(problem, problem.topologies.front(), function_samples(problem));
  const ChainFunctionDesign sound{KnownDwell().design.chain, 0.4};
  const auto has_value = [&](std::size_t parameter, double value) {
    ChainFunctionDesign begun = sound;
    begun.chain.parameters[parameter] = value;
    const auto model_of = [&](const ChainFunctionDesign& design) {
      return ChainFunctionModel(space, design, {}, space.fine, synthesis::Objective::max_abs);
    };
    std::vector<double> errors(space.fine.size());
    return model_of(begun).residuals(model_of(sound).start(), errors, {}, {});
  };
  EXPECT_TRUE(has_value(5, 1.4));
  EXPECT_FALSE(has_value(5, 0.1));   // BC, with DC of 4.9 and D at 5: far too short
  EXPECT_FALSE(has_value(11, 1e9));  // EF: its bound is 8
}

TEST(ChainFunctionModel, LimitsTurnWithTheCranksStart) {
  const auto problem = some_function();
  const ChainFunctionSpace space(problem, problem.topologies.front(), function_samples(problem));
  const ChainFunctionDesign design{KnownDwell().design.chain, 0.4};
  const auto limits_at = [&](double start, double crank) {
    const ChainFunctionModel model(space, design, {{6, crank}}, space.fine,
                                   synthesis::Objective::sum_of_squares);
    auto x = model.start();
    x[x.size() - 2] = start;
    std::vector<double> limits(static_cast<std::size_t>(model.constraint_count()));
    model.constraints(x, limits, {});
    return limits;
  };
  const auto turned = limits_at(0.4 + 0.25, 1.0), asked = limits_at(0.4, 1.25);
  EXPECT_NEAR(turned[0], asked[0], 1e-12);
  EXPECT_GT(std::abs(turned[0] - limits_at(0.4, 1.0)[0]), 1e-3);
}

}  // namespace
}  // namespace cognate::problems::chain_model_test
