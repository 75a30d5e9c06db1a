/// Chains with a link of three pins: against all assemblies of the group, against the pole that
/// defines their transmission angles, and derivatives against differences in 113 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "analysis/mechanism/three_pin_link.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/chain_fit.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/chain/sweep.hpp"
#include "tests/support/three_pin_chains.hpp"

namespace cognate::synthesis::three_pin_chain_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using test::PinnedChain;
using test::three_pin_chains;

/// A chain that keeps what its view points to.
template <class T>
class Pinned {
 public:
  explicit Pinned(const PinnedChain& of)
      : lines_(placed_lines(of.chain)),
        parameters(of.parameters.begin(), of.parameters.end()),
        side_(lines_.size(), T(1)) {}

  ChainView<T> view() const {
    return {lines_.data(), static_cast<int>(lines_.size()), parameters.data(), side_.data()};
  }
  const ChainPlace<T>& at(const Vec2<T>& crank) {
    place(view(), crank, place_);
    return place_;
  }
  int trace() const { return static_cast<int>(lines_.size()) - 1; }

 private:
  std::vector<PlacedLine> lines_;

 public:
  std::vector<T> parameters;

 private:
  std::vector<T> side_;
  ChainPlace<T> place_;
};

std::array<Vec2d, 3> holders_of(const PinnedChain& of, const ChainPlace<double>& at) {
  std::array<Vec2d, 3> holders;
  Pinned<double> chain(of);
  points_that_hold(chain.view(), at, of.base, holders.data());
  return holders;
}

TEST(ThreePinChain, StandsInOneOfAllAssemblies) {
  for (const PinnedChain& of : three_pin_chains()) {
    Pinned<double> chain(of);
    for (int i = 0; i < 360; i += 5) {
      const auto& at = chain.at(unit_vector(kTurn * i / 360));
      const auto link = held_link(chain.view(), of.base);
      ThreePinLink all;
      all.pins = {Vec2d{}, Vec2d{link.distance, 0}, link.third};
      all.pivots = holders_of(of, at);
      all.legs = {link.length[0], link.length[1], link.length[2]};
      double nearest = 1e9;
      for (const Placement& one : assemblies(all)) {
        const Vec2d* pins = at.at + of.base + kFirstPin;
        nearest = std::min(nearest, norm(one.origin - pins[0]) +
                                        norm(one.origin + link.distance * one.direction - pins[1]));
      }
      EXPECT_LT(nearest, 1e-9) << "crank " << i;
    }
  }
}

TEST(ThreePinChain, FollowedAndBegunAnewAreTheSame) {
  for (const PinnedChain& of : three_pin_chains()) {
    Pinned<double> chain(of);
    ChainPlace<double> followed;
    for (int i = 0; i < 720; ++i) {
      const Vec2d crank = unit_vector(kTurn * i / 360);
      place_next(chain.view(), crank, followed);
      EXPECT_LT(norm(followed.at[chain.trace()] - chain.at(crank).at[chain.trace()]), 1e-10);
    }
  }
}

/// The crossing of the lines of two links that hold it.
Vec2d pole(const Vec2d& a, const Vec2d& from_a, const Vec2d& b, const Vec2d& from_b) {
  const Vec2d u = a - from_a, v = b - from_b;
  return a + (cross(b - a, v) / cross(u, v)) * u;
}

TEST(ThreePinChain, TransmissionAnglesAreMeasuredToThePole) {
  for (const PinnedChain& of : three_pin_chains()) {
    Pinned<double> chain(of);
    for (int i = 0; i < 360; i += 7) {
      const auto& at = chain.at(unit_vector(kTurn * i / 360));
      const auto holders = holders_of(of, at);
      const Vec2d* pins = at.at + of.base + kFirstPin;
      for (int k = 0; k < 3; ++k) {
        const auto m = static_cast<std::size_t>((k + 1) % 3), n = (m + 1) % 3;
        const Vec2d arm = pins[k] - pole(pins[m], holders[m], pins[n], holders[n]);
        const Vec2d along = pins[k] - holders[static_cast<std::size_t>(k)];
        const double expected = std::abs(dot(along, arm)) / (norm(along) * norm(arm));
        const double cosine = transmission_cosine(chain.view(), at, of.base + kFirstPin + k);
        EXPECT_NEAR(std::abs(cosine), expected, 1e-10);
      }
    }
  }
}

constexpr int kGoals = 4;

/// The goals of the derivatives: the cosines of the pins, and a direction of the traced point.
template <class T>
std::array<T, kGoals> goals_of(Pinned<T>& chain, int base, const Vec2<T>& crank) {
  const auto& at = chain.at(crank);
  const auto cosine = [&](int pin) {
    return transmission_cosine(chain.view(), at, base + kFirstPin + pin);
  };
  const Vec2<T>& traced = at.at[chain.trace()];
  return {cosine(0), cosine(1), cosine(2), T(0.6) * traced.x - T(0.8) * traced.y};
}

std::vector<double> gradient_of(Pinned<double>& chain, int base, const Vec2d& crank, int goal) {
  std::vector<double> gradient(chain.parameters.size(), 0.0);
  std::array<Vec2d, kMostLines> seed{};
  const auto& at = chain.at(crank);
  int last = chain.trace();
  if (goal == kGoals - 1) {
    seed[static_cast<std::size_t>(last)] = {0.6, -0.8};
  } else {
    const int line = base + kFirstPin + goal;
    const double cosine = transmission_cosine(chain.view(), at, line);
    seed_transmission(chain.view(), at, line, cosine, 1.0, seed.data(), gradient.data());
    last = last_seeded(chain.view(), line);
  }
  sweep_back(chain.view(), at, last, seed.data(), gradient.data());
  return gradient;
}

TEST(ThreePinChain, GradientsAreDifferencesIn113Bits) {
  for (const PinnedChain& of : three_pin_chains()) {
    Pinned<double> chain(of);
    Pinned<Quad> exact(of);
    for (int i = 30; i < 360; i += 120) {
      const Vec2d crank = unit_vector(kTurn * i / 360);
      const Quad length = sqrt(Quad(crank.x) * crank.x + Quad(crank.y) * crank.y);
      const Vec2<Quad> wide{crank.x / length, crank.y / length};
      std::array<std::vector<double>, kGoals> gradients;
      for (int goal = 0; goal < kGoals; ++goal) {
        gradients[static_cast<std::size_t>(goal)] = gradient_of(chain, of.base, crank, goal);
      }
      for (std::size_t k = 0; k < of.parameters.size(); ++k) {
        const Quad step = 1e-11, middle = exact.parameters[k];
        exact.parameters[k] = middle + step;
        const auto above = goals_of(exact, of.base, wide);
        exact.parameters[k] = middle - step;
        const auto below = goals_of(exact, of.base, wide);
        exact.parameters[k] = middle;
        for (std::size_t goal = 0; goal < kGoals; ++goal) {
          const double slope = static_cast<double>((above[goal] - below[goal]) / (2 * step));
          const double size = std::abs(
              std::ranges::max(gradients[goal], {}, [](double own) { return std::abs(own); }));
          EXPECT_NEAR(slope, gradients[goal][k], 1e-12 * size);
        }
      }
    }
  }
}

TEST(ThreePinChain, MotionAndGradientSayTheSame) {
  for (const PinnedChain& of : three_pin_chains()) {
    Pinned<double> chain(of);
    const std::size_t count = chain.parameters.size();
    for (int i = 0; i < 360; i += 7) {
      const auto& at = chain.at(unit_vector(kTurn * i / 360));
      std::vector<double> rates(count), gradient(count, 0.0);
      for (std::size_t k = 0; k < count; ++k) rates[k] = std::sin(double(k) + 1 + i);
      std::array<Vec2d, kMostLines> velocity, seed{};
      const auto trace = static_cast<std::size_t>(chain.trace());
      move(chain.view(), at, 0.7, rates.data(), velocity.data());
      seed[trace] = {0.6, -0.8};
      double expected =
          0.7 * sweep_back(chain.view(), at, chain.trace(), seed.data(), gradient.data());
      for (std::size_t k = 0; k < count; ++k) expected += gradient[k] * rates[k];
      EXPECT_NEAR(dot(velocity[trace], {0.6, -0.8}), expected, 1e-11 * (1 + std::abs(expected)));
    }
  }
}

TEST(ThreePinChain, IsNotANumberBeyondItsDeadPoint) {
  PinnedChain of = three_pin_chains().front();
  of.parameters[6] = 9;  // a crank that no link can follow
  Pinned<double> chain(of);
  const auto is_closed = [&](int degree) {
    return std::isfinite(chain.at(unit_vector(kTurn * degree / 360)).at[chain.trace()].x);
  };
  EXPECT_FALSE(is_closed(90) && is_closed(180) && is_closed(270));
}

TEST(ThreePinChain, BodiesAndJointsAreThoseOfFourMoreLinks) {
  const PinnedChain of = three_pin_chains().front();
  const auto all = bodies(of.chain);
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[2], (std::vector<int>{3, 7, 10}));
  EXPECT_EQ(all[4], (std::vector<int>{2, 9}));
  EXPECT_EQ(all[5], (std::vector<int>{7, 8, 9}));
  EXPECT_EQ(joints(of.chain), (std::vector<int>{7, 8, 9}));
}

/// The path of a chain is fitted again from dimensions nearby, in every instruction set.
TEST(ThreePinChain, FitsReturnToTheChainOfTheTarget) {
  for (const InstructionSet set : instruction_sets()) {
    for (const PinnedChain& of : three_pin_chains()) {
      Pinned<double> chain(of);
      ChainFit problem{.chain = of.chain, .trace = chain.trace(), .closed = true};
      ChainFitState state{{of.parameters, std::vector<int>(of.chain.lines.size(), 1)}, {}};
      constexpr int kTargets = 48;
      for (int i = 0; i < kTargets; ++i) {
        state.angles.push_back(kTurn * i / kTargets);
        const Vec2d p = chain.at(unit_vector(state.angles.back())).at[chain.trace()];
        problem.x.push_back(p.x);
        problem.y.push_back(p.y);
        problem.root_weight.push_back(1 / std::sqrt(double(kTargets)));
      }
      problem.joints = joints(of.chain);
      for (const auto& [line, parameter] : placed_lines(of.chain)) {
        for (int i = 0; has_dimensions(line.type) && i < parameter_count(line.type); ++i) {
          const int own = parameter + i;
          problem.free.push_back(own);
          problem.lower.push_back(has_lengths(line.type) ? 0.01 : -20);
          problem.upper.push_back(20);
          state.design.parameters[static_cast<std::size_t>(own)] *= 1 + 0.01 * std::sin(own);
        }
      }
      draw_anew(placed_lines(of.chain), {1, 0}, state.design);
      std::vector<ChainFitState> states{state};
      ChainFitOptions options{.most_iterations = 400, .tolerance = 0};
      options.set = set;
      fit_chains(problem, states, options);
      EXPECT_LT(states.front().cost, 1e-12);
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis::three_pin_chain_test
