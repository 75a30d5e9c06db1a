/// Headings of bodies of chains: derivatives against differences in 113 bits, and fits of motions
/// in lanes to planted designs.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/chain_fit.hpp"
#include "synthesis/chain/heading.hpp"
#include "synthesis/chain/pose_error.hpp"
#include "synthesis/chain/transform.hpp"
#include "tests/support/posed_chain.hpp"
#include "tests/support/six_bars.hpp"

namespace cognate::synthesis::chain_heading_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using test::kTracedLine;
using test::PosedChain;
using test::six_bars_and_sliders;
using test::SixBar;

/// A chain whose traced point's body has a heading.
struct Headed {
  Chain chain;
  ChainDesign design;
  int line;
};

Headed headed(const SixBar& six_bar, double angle) {
  Headed made{six_bar.chain, six_bar.design, static_cast<int>(six_bar.chain.lines.size())};
  made.chain.lines.push_back({LineType::heading, kTracedLine});
  made.design.parameters.push_back(angle);
  made.design.side.push_back(0);
  return made;
}

TEST(ChainHeading, IsTheDirectionFromAPointOfTheBodyToAnother) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    const Headed headed_chain = headed(six_bar, 0.4);
    PosedChain<double> chain(headed_chain.chain, headed_chain.design);
    ASSERT_EQ(six_bar.chain.lines[kTracedLine].type, LineType::attached);
    const auto& [type, first, second] = six_bar.chain.lines[kTracedLine];
    for (int i = 0; i < 90; ++i) {
      const auto& place = chain.at(unit_vector(kTurn * i / 90));
      const double wanted = angle_of(place.at[second] - place.at[first]) + 0.4;
      const double is = angle_of(heading(chain.view(), place, headed_chain.line));
      EXPECT_NEAR(std::remainder(is - wanted, kTurn), 0, 1e-13);
    }
  }
}

TEST(ChainHeading, GradientsAndRatesAreDifferencesIn113Bits) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    const auto [own, design, line] = headed(six_bar, -1.1);
    PosedChain<double> chain(own, design);
    PosedChain<Quad> exact(own, design);
    for (int i = 0; i < 360; i += 5) {
      const double at = kTurn * i / 360;
      const auto& place = chain.at(unit_vector(at));
      std::vector<double> gradient(design.parameters.size(), 0.0);
      std::array<Vec2d, kMostLines> seed{}, velocity{};
      seed_heading(chain.view(), place, line, 1.0, seed.data(), gradient.data());
      const double turn = sweep_back(chain.view(), place, line, seed.data(), gradient.data());
      const Vec2d start = heading(chain.view(), place, line);
      const auto turned = [&](const Quad& crank) {
        const Vec2<Quad> direction{cos(crank), sin(crank)};
        const auto& there = exact.at(direction);
        const Vec2<Quad> is = heading(exact.view(), there, line);
        return Quad(start.x) * is.y - Quad(start.y) * is.x;  // of a small angle
      };
      const auto slope = [](const Quad& above, const Quad& below, const Quad& step) {
        return static_cast<double>((above - below) / (2 * step));
      };
      double size = std::abs(turn);
      for (const double one : gradient) size = std::max(size, std::abs(one));
      const Quad step = 1e-11;
      const double by_crank = slope(turned(at + step), turned(at - step), step);
      EXPECT_NEAR(turn, by_crank, 1e-12 * size);
      move(chain.view(), place, 1.0, static_cast<const double*>(nullptr), velocity.data());
      EXPECT_NEAR(heading_rate(chain.view(), place, line, velocity.data(), 0.0), by_crank,
                  1e-12 * size);
      for (std::size_t k = 0; k < gradient.size(); ++k) {
        const Quad middle = exact.parameters[k];
        exact.parameters[k] = middle + step;
        const Quad above = turned(at);
        exact.parameters[k] = middle - step;
        const Quad below = turned(at);
        exact.parameters[k] = middle;
        EXPECT_NEAR(slope(above, below, step), gradient[k], 1e-12 * size) << k;
      }
    }
  }
}

TEST(ChainHeading, TurnsWithTheChain) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    auto [own, design, line] = headed(six_bar, 0.8);
    PosedChain<double> before(own, design);
    const Vec2d turn = 2.5 * unit_vector(0.6);
    transform(placed_lines(own), turn, {3, -4}, design.parameters);
    PosedChain<double> after(own, design);
    const Vec2d was = heading(before.view(), before.at(unit_vector(1.2)), line);
    const Vec2d is = heading(after.view(), after.at(unit_vector(1.2 + 0.6)), line);
    EXPECT_NEAR(norm(is - unit_vector(0.6) * was), 0, 1e-12);
  }
}

TEST(PoseError, ChordIsTwiceTheSineOfHalfTheAngle) {
  for (double angle = -3.1; angle < 3.14; angle += 0.05) {
    const Chord<double> chord(unit_vector(0.7), unit_vector(0.7 + angle));
    EXPECT_NEAR(chord.length, 2 * std::sin(angle / 2), 1e-8);
    EXPECT_NEAR(chord.slope, std::cos(angle / 2), 1e-8);
  }
}

TEST(PoseError, BasisIsOrthonormal) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> number(0, 1);
  for (int i = 0; i < 1000; ++i) {
    PoseVector<double> n{number(random), number(random), i % 7 == 0 ? -1e-9 : number(random)};
    n = (1 / std::sqrt(dot(n, n))) * n;
    PoseVector<double> first{}, second{};
    across(n, n.turn < 0 ? -1.0 : 1.0, first, second);
    EXPECT_NEAR(dot(first, first), 1, 1e-14);
    EXPECT_NEAR(dot(second, second), 1, 1e-14);
    for (const double product : {dot(first, second), dot(first, n), dot(second, n)}) {
      EXPECT_NEAR(product, 0, 1e-14);
    }
  }
}

/// The motion of a six-bar's traced body, and what is sought of it.
struct PlantedMotion {
  ChainFit fit;
  std::vector<double> angles;
};

PlantedMotion planted(const Headed& headed_chain, int poses, bool timed) {
  PlantedMotion made;
  ChainFit& fit = made.fit;
  fit.chain = headed_chain.chain;
  fit.trace = kTracedLine;
  fit.heading = headed_chain.line;
  fit.angle_weight = 8;  // a slope without it leads nowhere
  fit.closed = true;
  PosedChain<double> chain(headed_chain.chain, headed_chain.design);
  for (int j = 0; j < poses; ++j) {
    made.angles.push_back(kTurn * j / poses);
    const auto& place = chain.at(unit_vector(made.angles.back()));
    const Vec2d wanted = heading(chain.view(), place, headed_chain.line);
    fit.x.push_back(place.at[kTracedLine].x);
    fit.y.push_back(place.at[kTracedLine].y);
    fit.heading_x.push_back(wanted.x);
    fit.heading_y.push_back(wanted.y);
    fit.root_weight.push_back(1 / std::sqrt(double(poses)));
    if (timed) fit.crank_angles.push_back(made.angles.back());
  }
  for (std::size_t i = 0; i < headed_chain.design.parameters.size(); ++i) {
    fit.free.push_back(static_cast<int>(i));
    fit.lower.push_back(-100);
    fit.upper.push_back(100);
  }
  if (timed) made.angles = {0.0};
  return made;
}

TEST(ChainHeading, PlantedMotionsAreFoundAgainOnEveryInstructionSet) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    for (const bool timed : {false, true}) {
      SCOPED_TRACE(std::string(six_bar.name) + (timed ? " timed" : " free"));
      const Headed headed_chain = headed(six_bar, 2.9);  // some bodies turn past 180 degrees
      const PlantedMotion motion = planted(headed_chain, 40, timed);
      for (const InstructionSet set : instruction_sets()) {
        std::mt19937_64 random(3);
        std::normal_distribution<double> error(0, 0.02);
        std::vector<ChainFitState> states(37, {headed_chain.design, motion.angles});
        for (ChainFitState& state : states) {
          for (double& value : state.design.parameters) value += error(random);
          for (double& angle : state.angles) angle += 0.5 * error(random);
        }
        ChainFitOptions options;
        options.set = set;
        options.most_iterations = 300;
        options.tolerance = 1e-12;
        fit_chains(motion.fit, states, options);
        const auto found = std::ranges::count_if(
            states, [](const ChainFitState& state) { return state.cost < 1e-12; });
        EXPECT_GE(found, 25);  // others end in minima of their own
      }
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis::chain_heading_test
