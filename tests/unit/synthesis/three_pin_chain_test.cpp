/// Chains with a link of three pins: against all assemblies of the group, against the pole that
/// defines their transmission angles, and derivatives against differences in 113 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "analysis/mechanism/three_pin_link.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/chain_fit.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/chain/sweep.hpp"
#include "tests/support/posed_chain.hpp"
#include "tests/support/three_pin_chains.hpp"

namespace cognate::synthesis::three_pin_chain_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using test::PinnedChain;
using test::PosedChain;
using test::three_pin_chains;

std::array<Vec2d, 3> holders_of(const PinnedChain& of, const ChainPlace<double>& at) {
  std::array<Vec2d, 3> holders;
  PosedChain<double> chain(of.chain, of.design);
  points_that_hold(chain.view(), at, of.base, holders.data());
  return holders;
}

TEST(ThreePinChain, StandsInOneOfAllAssemblies) {
  for (const PinnedChain& of : three_pin_chains()) {
    PosedChain<double> chain(of.chain, of.design);
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
    PosedChain<double> chain(of.chain, of.design);
    ChainPlace<double> followed;
    for (int i = 0; i < 1440; ++i) {
      // Step by step, and then here and there.
      const Vec2d crank = unit_vector(kTurn * (i < 720 ? i : i * i % 361) / 360);
      place_next(chain.view(), crank, followed);
      EXPECT_LT(norm(followed.at[chain.last()] - chain.at(crank).at[chain.last()]), 1e-10);
    }
  }
}

/// The crossing of the lines of two links that hold it.
Vec2d pole(const Vec2d& a, const Vec2d& from_a, const Vec2d& b, const Vec2d& from_b) {
  const Vec2d u = a - from_a, v = b - from_b;
  return a + (cross(b - a, v) / cross(u, v)) * u;
}

/// |cos μ| of the link that holds pin k: of the angle with the line from the pin to the pole.
double cosine_to_pole(const std::array<Vec2d, 3>& holders, const Vec2d* pins, int k) {
  const int m = (k + 1) % 3, n = (k + 2) % 3;
  const auto holder = [&](int pin) { return holders[static_cast<std::size_t>(pin)]; };
  const Vec2d arm = pins[k] - pole(pins[m], holder(m), pins[n], holder(n));
  const Vec2d along = pins[k] - holder(k);
  return std::abs(dot(along, arm)) / (norm(along) * norm(arm));
}

TEST(ThreePinChain, TransmissionAnglesAreMeasuredToThePole) {
  for (const PinnedChain& of : three_pin_chains()) {
    PosedChain<double> chain(of.chain, of.design);
    for (int i = 0; i < 360; i += 7) {
      const auto& at = chain.at(unit_vector(kTurn * i / 360));
      const auto holders = holders_of(of, at);
      for (int k = 0; k < 3; ++k) {
        const double cosine = transmission_cosine(chain.view(), at, of.base + kFirstPin + k);
        EXPECT_NEAR(std::abs(cosine), cosine_to_pole(holders, at.at + of.base + kFirstPin, k),
                    1e-10);
      }
    }
  }
}

constexpr int kGoals = 4;

/// The goals of the derivatives: the cosines of the pins, and a direction of the traced point.
template <class T>
std::array<T, kGoals> goals_of(PosedChain<T>& chain, int base, const Vec2<T>& crank) {
  const auto& at = chain.at(crank);
  const auto cosine = [&](int pin) {
    return transmission_cosine(chain.view(), at, base + kFirstPin + pin);
  };
  const Vec2<T>& traced = at.at[chain.last()];
  return {cosine(0), cosine(1), cosine(2), T(0.6) * traced.x - T(0.8) * traced.y};
}

std::vector<double> gradient_of(PosedChain<double>& chain, int base, const Vec2d& crank, int goal) {
  std::vector<double> gradient(chain.parameters.size(), 0.0);
  std::array<Vec2d, kMostLines> seed{};
  const auto& at = chain.at(crank);
  int last = chain.last();
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
    PosedChain<double> chain(of.chain, of.design);
    PosedChain<Quad> exact(of.chain, of.design);
    for (int i = 30; i < 360; i += 120) {
      const Vec2d crank = unit_vector(kTurn * i / 360);
      const Quad length = sqrt(Quad(crank.x) * crank.x + Quad(crank.y) * crank.y);
      const Vec2<Quad> wide{crank.x / length, crank.y / length};
      std::array<std::vector<double>, kGoals> gradients;
      for (int goal = 0; goal < kGoals; ++goal) {
        gradients[static_cast<std::size_t>(goal)] = gradient_of(chain, of.base, crank, goal);
      }
      for (std::size_t k = 0; k < of.design.parameters.size(); ++k) {
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
    PosedChain<double> chain(of.chain, of.design);
    const std::size_t count = chain.parameters.size();
    for (int i = 0; i < 360; i += 7) {
      const auto& at = chain.at(unit_vector(kTurn * i / 360));
      std::vector<double> rates(count), gradient(count, 0.0);
      for (std::size_t k = 0; k < count; ++k) rates[k] = std::sin(double(k) + 1 + i);
      std::array<Vec2d, kMostLines> velocity, seed{};
      const auto trace = static_cast<std::size_t>(chain.last());
      const auto second = static_cast<std::size_t>(of.base + kSecondPin);
      move(chain.view(), at, 0.7, rates.data(), velocity.data());
      seed[trace] = {0.6, -0.8};
      seed[second] = {0.3, 0.4};
      double expected =
          0.7 * sweep_back(chain.view(), at, chain.last(), seed.data(), gradient.data());
      for (std::size_t k = 0; k < count; ++k) expected += gradient[k] * rates[k];
      EXPECT_NEAR(dot(velocity[trace], {0.6, -0.8}) + dot(velocity[second], {0.3, 0.4}), expected,
                  1e-11 * (1 + std::abs(expected)));
    }
  }
}

/// A plate at random, held from a crank of length 1 and two pivots, as it is drawn at angle 0.
PinnedChain random_chain(std::mt19937_64& random) {
  const auto some = [&] {
    return uniform(random, 0.3, 4) * unit_vector(uniform(random, 0, kTurn));
  };
  const Vec2d first = Vec2d{1, 0} + some();
  const std::array<Vec2d, 3> pins{first, first + some(), first + some()};
  const Vec2d second = pins[1] + some(), third = pins[2] + some();
  PinnedChain of = three_pin_chains().front();
  of.design.parameters =
      test::joined({0, 0, second.x, second.y, third.x, third.y, 1},
                   test::drawn_lines(pins, {Vec2d{1, 0}, second, third}), {0.7, 0.3});
  return of;
}

/// A link followed in small steps among all its assemblies, up to its first dead point.
class FollowedAssembly {
 public:
  FollowedAssembly(const PosedChain<double>& chain, const PinnedChain& of) {
    const auto held = held_link(chain.view(), of.base);
    const auto& own = chain.parameters;
    link_.pins = {Vec2d{}, Vec2d{held.distance, 0}, held.third};
    link_.pivots = {Vec2d{1, 0}, Vec2d{own[2], own[3]}, Vec2d{own[4], own[5]}};
    link_.legs = {held.length[0], held.length[1], held.length[2]};
    const double* drawn = own.data() + 8;
    const Vec2d first{drawn[0], drawn[1]}, way = Vec2d{drawn[2], drawn[3]} - first;
    place_ = {first, (1 / norm(way)) * way};
  }

  /// To the nearest of the assemblies with the crank's pin here; nowhere if none is near.
  void step(const Vec2d& pin) {
    link_.pivots[0] = pin;
    const auto away = [&](const Placement& one) {
      return norm(one.direction - place_->direction) +
             norm(one.origin - place_->origin) / link_.pins[1].x;
    };
    const auto all = assemblies(link_);
    const auto nearest = std::ranges::min_element(all, {}, away);
    if (nearest == all.end() || away(*nearest) > 0.3) {
      place_.reset();
      return;
    }
    place_ = *nearest;
    Vec2d pins[3];
    for (std::size_t k = 0; k < 3; ++k)
      pins[k] = place_->origin + place_->direction * link_.pins[k];
    for (int k = 0; k < 3; ++k) {
      greatest_cosine_ = std::max(greatest_cosine_, cosine_to_pole(link_.pivots, pins, k));
    }
  }

  const std::optional<Placement>& place() const { return place_; }
  double greatest_cosine() const { return greatest_cosine_; }

 private:
  ThreePinLink link_;
  std::optional<Placement> place_;
  double greatest_cosine_ = 0;
};

/// Beyond a dead point it is nowhere; near one it may be lost.
TEST(ThreePinChain, StandsWhereItsAssembliesLeadAndNowhereBeyondDeadPoints) {
  constexpr int kFine = 12, kSteps = 30;
  constexpr double kNearDead = 0.96;
  std::mt19937_64 random(5);
  int compared = 0, dead = 0;
  for (int number = 0; number < 150; ++number) {
    const PinnedChain of = random_chain(random);
    PosedChain<double> chain(of.chain, of.design);
    FollowedAssembly expected(chain, of);
    for (int i = 1; i < kSteps; ++i) {
      for (int k = 1; k <= 12 * kFine && expected.place(); ++k) {
        expected.step(unit_vector(kTurn * (12 * kFine * (i - 1) + k) / (12 * kFine * kSteps)));
      }
      const Vec2d found = chain.at(unit_vector(kTurn * i / kSteps)).at[of.base + kFirstPin];
      if (!expected.place()) {
        EXPECT_FALSE(std::isfinite(found.x)) << "chain " << number << " at " << 12 * i;
        ++dead;
      } else if (std::isfinite(found.x) || expected.greatest_cosine() < kNearDead) {
        EXPECT_LT(norm(found - expected.place()->origin), 1e-6)
            << "chain " << number << " at " << 12 * i;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(dead, 1000);
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
      PosedChain<double> chain(of.chain, of.design);
      ChainFit problem{.chain = of.chain, .trace = chain.last(), .closed = true};
      ChainFitState state{of.design, {}};
      constexpr int kTargets = 48;
      for (int i = 0; i < kTargets; ++i) {
        state.angles.push_back(kTurn * i / kTargets);
        const Vec2d p = chain.at(unit_vector(state.angles.back())).at[chain.last()];
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
