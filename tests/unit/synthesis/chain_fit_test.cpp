/// Fits of chains in lanes: planted designs are found again from disturbed ones, by every
/// instruction set, with limits and orders kept.
#include "synthesis/chain/chain_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/sweep.hpp"
#include "tests/support/six_bars.hpp"

namespace cognate::synthesis::chain_fit_test {
namespace {

using test::kTracedLine;
using test::six_bars;
using test::six_bars_and_sliders;
using test::SixBar;

struct Planted {
  ChainFit fit;
  std::vector<double> angles;
};

Planted planted(const SixBar& six_bar, int points, double noise = 0) {
  Planted made;
  ChainFit& fit = made.fit;
  fit.chain = six_bar.chain;
  fit.trace = kTracedLine;
  fit.closed = true;
  const auto lines = placed_lines(six_bar.chain);
  const std::vector<double> side(six_bar.design.side.begin(), six_bar.design.side.end());
  ChainPlace<double> place;
  std::mt19937_64 random(7);
  std::normal_distribution<double> error(0, 1);
  for (int j = 0; j < points; ++j) {
    made.angles.push_back(kTurn * j / points);
    cognate::synthesis::place(ChainView<double>{lines.data(), static_cast<int>(lines.size()),
                                                six_bar.design.parameters.data(), side.data()},
                              unit_vector(made.angles.back()), place);
    fit.x.push_back(place.at[kTracedLine].x + noise * error(random));
    fit.y.push_back(place.at[kTracedLine].y + noise * error(random));
    fit.root_weight.push_back(1 / std::sqrt(double(points)));
  }
  for (std::size_t i = 0; i < six_bar.design.parameters.size(); ++i) {
    fit.free.push_back(static_cast<int>(i));
    fit.lower.push_back(-100);
    fit.upper.push_back(100);
  }
  fit.joints = joints(six_bar.chain);
  return made;
}

std::vector<ChainFitState> disturbed(const SixBar& six_bar, const Planted& from, double by) {
  std::vector<ChainFitState> states;
  std::mt19937_64 random(3);
  std::normal_distribution<double> error(0, by);
  for (int i = 0; i < 37; ++i) {
    ChainFitState state{six_bar.design, from.angles};
    for (double& value : state.design.parameters) value += error(random);
    for (double& angle : state.angles) angle += 0.5 * error(random);
    states.push_back(state);
  }
  return states;
}

TEST(ChainFit, FindsPlantedChainsAgainOnEveryInstructionSet) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    const Planted planted_fit = planted(six_bar, 60);
    for (const InstructionSet set : instruction_sets()) {
      auto states = disturbed(six_bar, planted_fit, 0.02);
      ChainFitOptions options;
      options.set = set;
      options.most_iterations = 300;
      options.tolerance = 1e-12;
      fit_chains(planted_fit.fit, states, options);
      int found = 0;
      for (const ChainFitState& state : states) found += state.cost < 1e-12;
      EXPECT_GE(found, 25);  // others end in minima of their own
    }
  }
}

TEST(ChainFit, ResultsDoNotDependOnThreadsOrNeighbours) {
  const auto bars = six_bars();
  const Planted planted_fit = planted(bars[0], 40, 0.02);
  auto all = disturbed(bars[0], planted_fit, 0.05);
  auto alone = std::vector(all.begin() + 11, all.begin() + 12);
  auto threaded = all;
  fit_chains(planted_fit.fit, all, {});
  fit_chains(planted_fit.fit, alone, {});
  ChainFitOptions two;
  two.threads = 2;
  fit_chains(planted_fit.fit, threaded, two);
  EXPECT_EQ(all[11].cost, alone[0].cost);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].cost, threaded[i].cost);
}

TEST(ChainFit, CrankAnglesStayInOrder) {
  const auto bars = six_bars();
  for (const SixBar& six_bar : bars) {
    const Planted planted_fit = planted(six_bar, 60, 0.2);
    auto states = disturbed(six_bar, planted_fit, 0.02);
    for (ChainFitState& state : states) state.angles = planted_fit.angles;
    fit_chains(planted_fit.fit, states, {});
    int fitted = 0;
    for (const ChainFitState& state : states) {
      if (!std::isfinite(state.cost)) continue;
      ++fitted;
      for (std::size_t j = 1; j < state.angles.size(); ++j) {
        EXPECT_GE(state.angles[j] - state.angles[j - 1], -1e-12);
      }
      EXPECT_LE(state.angles.back() - state.angles.front(), kTurn + 1e-12);
    }
    EXPECT_GE(fitted, 30);
  }
}

TEST(ChainFit, TransmissionIsHeldToItsLimit) {
  const auto bars = six_bars();
  const SixBar& six_bar = bars[0];
  Planted planted_fit = planted(six_bar, 60);
  planted_fit.fit.cosine_limit = std::cos(45 * kPi / 180);
  auto states = disturbed(six_bar, planted_fit, 0.01);
  ChainFitOptions options;
  options.most_iterations = 300;
  options.penalty = 100;
  fit_chains(planted_fit.fit, states, options);
  const auto lines = placed_lines(six_bar.chain);
  int fitted = 0;
  for (const ChainFitState& state : states) {
    if (!(state.cost < 0.02)) continue;
    ++fitted;
    const std::vector<double> side(state.design.side.begin(), state.design.side.end());
    const ChainView<double> view{lines.data(), static_cast<int>(lines.size()),
                                 state.design.parameters.data(), side.data()};
    ChainPlace<double> at;
    for (int i = 0; i < 720; ++i) {
      place(view, unit_vector(kTurn * i / 720), at);
      for (const int joint : planted_fit.fit.joints) {
        EXPECT_LT(std::abs(transmission_cosine(view, at, joint)),
                  planted_fit.fit.cosine_limit + 0.02);
      }
    }
  }
  EXPECT_GE(fitted, 10);
}

}  // namespace
}  // namespace cognate::synthesis::chain_fit_test
