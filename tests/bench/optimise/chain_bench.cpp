/// Six-bars in point form: positions, gradients by all parameters, and fits in lanes, beside the
/// general evaluator of mechanisms. Items are positions of one design.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/chain_fit.hpp"
#include "synthesis/chain/sweep.hpp"
#include "tests/support/posed_chain.hpp"
#include "tests/support/six_bars.hpp"
#include "tests/support/three_pin_chains.hpp"

namespace cognate::synthesis {
namespace {

using test::kTracedLine;

constexpr int kPositions = 180;

/// Stephenson III a, and directions of its crank.
struct Posed {
  test::SixBar six_bar = test::six_bars()[0];
  std::vector<PlacedLine> lines = placed_lines(six_bar.chain);
  std::vector<double> side{six_bar.design.side.begin(), six_bar.design.side.end()};
  std::vector<Vec2d> cranks;

  Posed() {
    for (int i = 0; i < kPositions; ++i) cranks.push_back(unit_vector(kTurn * i / kPositions));
  }
  ChainView<double> view() const {
    return {lines.data(), static_cast<int>(lines.size()), six_bar.design.parameters.data(),
            side.data()};
  }
};
const Posed posed;

/// The same linkage body by body: E and P fixed on the couplers of its dyads.
Mechanism<double> stephenson() {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.push_back(Rrr<double>{{1, {1, 0}}, {0, {4, 0}}, 4, 2, Assembly::crossed});
  mechanism.dyads.push_back(Rrr<double>{{2, {1.5, 3}}, {0, {0, 0.5}}, 3, 1.5, Assembly::crossed});
  return mechanism;
}

void general_evaluator(benchmark::State& state) {
  MechanismMotion<0> motion(stephenson());
  for (auto _ : state) {
    for (const Vec2d& crank : posed.cranks) {
      motion.move_to({crank, 0});
      benchmark::DoNotOptimize(motion.point({4, {-1, -2.5}}));
    }
  }
  state.SetItemsProcessed(state.iterations() * kPositions);
}
BENCHMARK(general_evaluator);

void positions(benchmark::State& state) {
  ChainPlace<double> at;
  for (auto _ : state) {
    for (const Vec2d& crank : posed.cranks) {
      place(posed.view(), crank, at);
      benchmark::DoNotOptimize(at.at[kTracedLine]);
    }
  }
  state.SetItemsProcessed(state.iterations() * kPositions);
}
BENCHMARK(positions);

/// The squared distances from a point, with their gradient by all 15 parameters.
void gradients(benchmark::State& state) {
  ChainPlace<double> at;
  std::vector<double> gradient(posed.six_bar.design.parameters.size(), 0.0);
  for (auto _ : state) {
    for (const Vec2d& crank : posed.cranks) {
      place(posed.view(), crank, at);
      Vec2d seed[kMostLines]{};
      seed[kTracedLine] = 2.0 * (at.at[kTracedLine] - Vec2d{3, 4.5});
      sweep_back(posed.view(), at, kTracedLine, seed, gradient.data());
    }
    benchmark::DoNotOptimize(gradient.data());
  }
  state.SetItemsProcessed(state.iterations() * kPositions);
}
BENCHMARK(gradients);

/// The same of a six-bar with a three-pin link, followed from position to position.
void three_pin_positions(benchmark::State& state) {
  const test::PinnedChain of = test::three_pin_chains().front();
  const test::PosedChain<double> pinned(of.chain, of.design);
  ChainPlace<double> at;
  for (auto _ : state) {
    for (const Vec2d& crank : posed.cranks) {
      place_next(pinned.view(), crank, at);
      benchmark::DoNotOptimize(at.at[pinned.last()]);
    }
  }
  state.SetItemsProcessed(state.iterations() * kPositions);
}
BENCHMARK(three_pin_positions);

/// Positions as far apart as those at which limits of a fit are asked, in the order of the crank.
constexpr int kStep = 9;

/// Each led to from angle 0.
void three_pin_checks_from_zero(benchmark::State& state) {
  const test::PinnedChain of = test::three_pin_chains().front();
  const test::PosedChain<double> pinned(of.chain, of.design);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPositions; i += kStep) {
      ChainPlace<double> at;
      place(pinned.view(), posed.cranks[i], at);
      benchmark::DoNotOptimize(at.at[pinned.last()]);
    }
  }
  state.SetItemsProcessed(state.iterations() * (kPositions / kStep));
}
BENCHMARK(three_pin_checks_from_zero);

/// Each led to from the one before.
void three_pin_checks_led_on(benchmark::State& state) {
  const test::PinnedChain of = test::three_pin_chains().front();
  const test::PosedChain<double> pinned(of.chain, of.design);
  ChainPlace<double> at;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPositions; i += kStep) {
      place_next(pinned.view(), posed.cranks[i], at);
      benchmark::DoNotOptimize(at.at[pinned.last()]);
    }
  }
  state.SetItemsProcessed(state.iterations() * (kPositions / kStep));
}
BENCHMARK(three_pin_checks_led_on);

void three_pin_gradients(benchmark::State& state) {
  const test::PinnedChain of = test::three_pin_chains().front();
  const test::PosedChain<double> pinned(of.chain, of.design);
  ChainPlace<double> at;
  std::vector<double> gradient(pinned.parameters.size(), 0.0);
  for (auto _ : state) {
    for (const Vec2d& crank : posed.cranks) {
      place_next(pinned.view(), crank, at);
      Vec2d seed[kMostLines]{};
      seed[pinned.last()] = 2.0 * (at.at[pinned.last()] - Vec2d{3, 4.5});
      sweep_back(pinned.view(), at, pinned.last(), seed, gradient.data());
    }
    benchmark::DoNotOptimize(gradient.data());
  }
  state.SetItemsProcessed(state.iterations() * kPositions);
}
BENCHMARK(three_pin_gradients);

/// A path of the six-bar, its points moved by some hundredths, to be fitted by all its dimensions.
struct DisturbedPath {
  ChainFit fit;
  ChainFitState start{posed.six_bar.design, {}};

  DisturbedPath() {
    fit.chain = posed.six_bar.chain;
    fit.trace = kTracedLine;
    fit.closed = true;
    ChainPlace<double> at;
    for (int j = 0; j < 60; ++j) {
      place(posed.view(), posed.cranks[static_cast<std::size_t>(3 * j)], at);
      fit.x.push_back(at.at[kTracedLine].x + 0.1 * std::sin(7.0 * j));
      fit.y.push_back(at.at[kTracedLine].y + 0.1 * std::cos(5.0 * j));
      fit.root_weight.push_back(1);
      start.angles.push_back(kTurn * j / 60);
    }
    for (int i = 0; i < 15; ++i) add_unknown(i);
    fit.joints = joints(fit.chain);
  }

  void add_unknown(int parameter) {
    fit.free.push_back(parameter);
    fit.lower.push_back(-100);
    fit.upper.push_back(100);
  }

  /// The body of the traced point is to have directions, too.
  void add_headings() {
    fit.heading = static_cast<int>(fit.chain.lines.size());
    fit.chain.lines.push_back({LineType::heading, kTracedLine});
    add_unknown(static_cast<int>(start.design.parameters.size()));
    start.design.parameters.push_back(0.3);
    start.design.side.push_back(0);
    fit.angle_weight = 1;
    for (int j = 0; j < 60; ++j) {
      const Vec2d wanted = unit_vector(0.5 * std::sin(kTurn * j / 60));
      fit.heading_x.push_back(wanted.x);
      fit.heading_y.push_back(wanted.y);
    }
  }
};

void run_iterations(benchmark::State& state, const DisturbedPath& path) {
  ChainFitOptions options;
  options.tolerance = 0;
  options.most_iterations = 20;
  std::int64_t iterations = 0;
  for (auto _ : state) {
    std::vector<ChainFitState> states(64, path.start);
    fit_chains(path.fit, states, options);
    for (const ChainFitState& one : states) iterations += one.iterations;
  }
  state.SetItemsProcessed(iterations * 60);
}

/// Whole iterations of fits in lanes: rows and normal equations of 15 unknowns, 36 positions at
/// which transmission angles are looked at, the attempt and its cost.
void fit_iterations(benchmark::State& state) {
  run_iterations(state, DisturbedPath{});
}
BENCHMARK(fit_iterations);

/// The same of a body's poses: two rows for each, one unknown more.
void motion_fit_iterations(benchmark::State& state) {
  DisturbedPath path;
  path.add_headings();
  run_iterations(state, path);
}
BENCHMARK(motion_fit_iterations);

}  // namespace
}  // namespace cognate::synthesis

BENCHMARK_MAIN();
