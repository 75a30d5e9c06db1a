/// Chains in point form: against published figures, and derivatives against differences in 113
/// bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/sweep.hpp"
#include "tests/support/posed_chain.hpp"
#include "tests/support/six_bars.hpp"

namespace cognate::synthesis::chain_sweep_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using test::chains_with_sliders;
using test::kTracedLine;
using test::PosedChain;
using test::six_bars;
using test::six_bars_and_sliders;
using test::SixBar;

constexpr int kPositions = 360;

Vec2<Quad> wide(const Vec2d& v) {
  const Quad length = sqrt(Quad(v.x) * v.x + Quad(v.y) * v.y);
  return {Quad(v.x) / length, Quad(v.y) / length};
}

TEST(ChainSweep, PathsAndTransmissionAnglesOfPublishedSixBars) {
  for (const SixBar& six_bar : six_bars()) {
    SCOPED_TRACE(six_bar.name);
    PosedChain<double> chain(six_bar.chain, six_bar.design);
    const Vec2d start = chain.at({1, 0}).at[kTracedLine];
    EXPECT_NEAR(start.x, six_bar.start.x, 1e-9);
    EXPECT_NEAR(start.y, six_bar.start.y, 1e-9);
    std::array<double, 4> box{1e9, -1e9, 1e9, -1e9};
    std::array<double, 2> cosine{0, 0};
    for (int i = 0; i < 36000; ++i) {
      const auto& place = chain.at(unit_vector(kTurn * i / 36000));
      const Vec2d p = place.at[kTracedLine];
      box = {std::min(box[0], p.x), std::max(box[1], p.x), std::min(box[2], p.y),
             std::max(box[3], p.y)};
      const std::array joints{six_bar.first_joint, six_bar.second_joint};
      for (std::size_t k = 0; k < 2; ++k) {
        cosine[k] =
            std::max(cosine[k], std::abs(transmission_cosine(chain.view(), place, joints[k])));
      }
    }
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(box[i], six_bar.box[i], 1e-6);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(std::acos(cosine[k]) * 180 / kPi, six_bar.transmission[k], 6e-4);
    }
  }
}

TEST(ChainSweep, GradientsAreDifferencesIn113Bits) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    PosedChain<double> chain(six_bar.chain, six_bar.design);
    PosedChain<Quad> exact(six_bar.chain, six_bar.design);
    double worst = 0;
    for (int i = 0; i < kPositions; i += 5) {
      const Vec2d crank = unit_vector(kTurn * i / kPositions), direction = unit_vector(0.3 + i);
      std::vector<double> gradient(six_bar.design.parameters.size(), 0.0);
      std::array<Vec2d, kMostLines> seed{};
      seed[kTracedLine] = direction;
      sweep_back(chain.view(), chain.at(crank), kTracedLine, seed.data(), gradient.data());
      const auto goal = [&] {
        const Vec2<Quad> p = exact.at(wide(crank)).at[kTracedLine];
        return p.x * direction.x + p.y * direction.y;
      };
      double size = 0;
      for (const double slope : gradient) size = std::max(size, std::abs(slope));
      for (std::size_t k = 0; k < gradient.size(); ++k) {
        const Quad step = 1e-11, middle = exact.parameters[k];
        exact.parameters[k] = middle + step;
        const Quad above = goal();
        exact.parameters[k] = middle - step;
        const Quad below = goal();
        exact.parameters[k] = middle;
        const double slope = static_cast<double>((above - below) / (2 * step));
        worst = std::max(worst, std::abs(slope - gradient[k]) / size);
      }
    }
    EXPECT_LT(worst, 1e-12);
  }
}

TEST(ChainSweep, MotionAndGradientSayTheSame) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    PosedChain<double> chain(six_bar.chain, six_bar.design);
    const std::size_t count = six_bar.design.parameters.size();
    for (int i = 0; i < kPositions; i += 7) {
      const auto& place = chain.at(unit_vector(kTurn * i / kPositions));
      std::vector<double> rates(count), gradient(count, 0.0);
      for (std::size_t k = 0; k < count; ++k) rates[k] = std::sin(double(k) + 1 + i);
      std::array<Vec2d, kMostLines> velocity, seed{};
      move(chain.view(), place, 0.7, rates.data(), velocity.data());
      seed[kTracedLine] = {0.6, -0.8};
      const double turn =
          sweep_back(chain.view(), place, kTracedLine, seed.data(), gradient.data());
      double expected = 0.7 * turn;
      for (std::size_t k = 0; k < count; ++k) expected += gradient[k] * rates[k];
      EXPECT_NEAR(dot(velocity[kTracedLine], {0.6, -0.8}), expected,
                  1e-12 * (1 + std::abs(expected)));
    }
  }
}

TEST(ChainSweep, CosinesAreDifferentiatedToo) {
  for (const SixBar& six_bar : six_bars_and_sliders()) {
    SCOPED_TRACE(six_bar.name);
    PosedChain<double> chain(six_bar.chain, six_bar.design);
    PosedChain<Quad> exact(six_bar.chain, six_bar.design);
    for (int i = 0; i < kPositions; i += 15) {
      const int joint = i % 2 == 0 ? six_bar.second_joint : six_bar.first_joint;
      const Vec2d crank = unit_vector(kTurn * i / kPositions);
      const auto& place = chain.at(crank);
      std::vector<double> gradient(six_bar.design.parameters.size(), 0.0);
      std::array<Vec2d, kMostLines> seed{};
      const double cosine = transmission_cosine(chain.view(), place, joint);
      seed_transmission(chain.view(), place, joint, cosine, 1.0, seed.data(), gradient.data());
      sweep_back(chain.view(), place, joint - 1, seed.data(), gradient.data());
      for (std::size_t k = 0; k < gradient.size(); ++k) {
        const Quad step = 1e-11, middle = exact.parameters[k];
        const auto goal = [&](const Quad& value) {
          exact.parameters[k] = value;
          return transmission_cosine(exact.view(), exact.at(wide(crank)), joint);
        };
        const Quad above = goal(middle + step), below = goal(middle - step);
        exact.parameters[k] = middle;
        EXPECT_NEAR(static_cast<double>((above - below) / (2 * step)), gradient[k], 1e-12);
      }
    }
  }
}

/// The first slider of a chain.
int slider_of(const SixBar& chain) {
  const auto is_slider = [](const ChainLine& line) { return line.type == LineType::slider; };
  return static_cast<int>(std::ranges::find_if(chain.chain.lines, is_slider) -
                          chain.chain.lines.begin());
}

TEST(ChainSweep, PinsOfSlidersAreOnTheirGuidesAheadOrBehind) {
  for (const SixBar& six_bar : chains_with_sliders()) {
    SCOPED_TRACE(six_bar.name);
    PosedChain<double> chain(six_bar.chain, six_bar.design);
    const int slider = slider_of(six_bar);
    const auto lines = placed_lines(six_bar.chain);
    const auto& [line, parameter] = lines[std::size_t(slider)];
    const auto& [guide, direction] = lines[std::size_t(line.second)];
    const double length = six_bar.design.parameters[std::size_t(parameter)],
                 offset = six_bar.design.parameters[std::size_t(direction) + 1];
    const Vec2d along = unit_vector(six_bar.design.parameters[std::size_t(direction)]);
    for (int i = 0; i < kPositions; i += 7) {
      const auto& place = chain.at(unit_vector(kTurn * i / kPositions));
      const Vec2d pin = place.at[slider], from = place.at[line.first];
      EXPECT_NEAR(norm(pin - from), length, 1e-13);
      EXPECT_NEAR(cross(along, pin - place.at[guide.first]), offset, 1e-13);
      EXPECT_GT(six_bar.design.side[std::size_t(slider)] * dot(along, pin - from), 0.1);
    }
  }
}

TEST(ChainSweep, DisplacementsAreDifferentiatedToo) {
  for (const SixBar& six_bar : chains_with_sliders()) {
    SCOPED_TRACE(six_bar.name);
    PosedChain<double> chain(six_bar.chain, six_bar.design);
    PosedChain<Quad> exact(six_bar.chain, six_bar.design);
    const int slider = slider_of(six_bar);
    const int guide = six_bar.chain.lines[std::size_t(slider)].second;
    for (int i = 0; i < kPositions; i += 15) {
      const Vec2d crank = unit_vector(kTurn * i / kPositions);
      const auto& place = chain.at(crank);
      std::vector<double> gradient(six_bar.design.parameters.size(), 0.0);
      std::array<Vec2d, kMostLines> seed{};
      seed[std::size_t(slider)] = place.axis[guide];
      seed[std::size_t(guide)] = -place.axis[guide];
      sweep_back(chain.view(), place, slider, seed.data(), gradient.data());
      for (std::size_t k = 0; k < gradient.size(); ++k) {
        const Quad step = 1e-11, middle = exact.parameters[k];
        const auto goal = [&](const Quad& value) {
          exact.parameters[k] = value;
          const auto& at = exact.at(wide(crank));
          return dot(at.axis[guide], at.at[slider] - at.at[guide]);
        };
        const Quad above = goal(middle + step), below = goal(middle - step);
        exact.parameters[k] = middle;
        EXPECT_NEAR(static_cast<double>((above - below) / (2 * step)), gradient[k], 1e-12);
      }
    }
  }
}

TEST(ChainBodies, RigidTrianglesAreNoJoints) {
  // Jansen's leg: its points D and F make triangles with links that are there already.
  const Chain chain{{{LineType::pivot},
                     {LineType::pivot},
                     {LineType::crank, 0},
                     {LineType::dyad, 2, 1},
                     {LineType::dyad, 3, 1},
                     {LineType::dyad, 2, 1},
                     {LineType::dyad, 4, 5},
                     {LineType::dyad, 5, 6}}};
  EXPECT_EQ(joints(chain), (std::vector{3, 5, 6}));
  EXPECT_EQ(bodies(chain).front(), (std::vector{0, 1}));
}

}  // namespace
}  // namespace cognate::synthesis::chain_sweep_test
