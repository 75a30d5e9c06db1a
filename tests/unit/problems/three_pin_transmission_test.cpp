/// Mechanisms with a three-pin link as the kernel measures them, and their dimensions back.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/three_pin/transmission.hpp"
#include "problems/chain/topology.hpp"
#include "tests/support/three_pin_chains.hpp"

namespace cognate::problems::three_pin_transmission_test {
namespace {

/// Of the type three-pin-1, by where its joints stand with the crank at angle 0.
synthesis::ChainDesign design_of(const std::array<Vec2d, 3>& pins, double crank,
                                 const std::array<Vec2d, 2>& pivots) {
  const auto& [second, third] = pivots;
  synthesis::ChainDesign design;
  design.parameters =
      test::joined({0, 0, second.x, second.y, third.x, third.y, crank},
                   test::drawn_lines(pins, {Vec2d{crank, 0}, second, third}), {0.7, 0.3});
  design.side.assign(11, 0);
  return design;
}

Topology topology() {
  return topologies("three-pin-1").front();
}

bool returns(const synthesis::ChainDesign& design) {
  const NamedMechanism mechanism = named(topology(), design);
  const AssemblyRanges turn = follow(mechanism.mechanism, 0, kTurn);
  EXPECT_EQ(turn.runs.size(), 1U);
  EXPECT_TRUE(turn.points.empty());
  return returns_after_turn(mechanism.mechanism, turn);
}

/// The crank turns once without a dead point, with transmission angles of more than 17 degrees, and
/// the link stands in another of its assemblies then (followed in steps of 0.01 degrees by a
/// program of its own).
TEST(ThreePinTransmission, SaysWhetherATurnLeadsBack) {
  EXPECT_FALSE(returns(design_of({Vec2d{1.153, 0.151}, {0.961, -0.083}, {0.705, 0.803}}, 0.52,
                                 {Vec2d{0.425, -0.169}, {-0.181, 1.704}})));
  EXPECT_TRUE(returns(design_of({Vec2d{3.33, -1.5}, {2.2, 3.0}, {4.6, -3.0}}, 0.6,
                                {Vec2d{-1.8, 0.2}, {1.9, -4.7}})));
}

TEST(ThreePinTransmission, DimensionsAreThoseOfTheMechanism) {
  const auto design =
      design_of({Vec2d{3.33, -1.5}, {2.2, 3.0}, {4.6, -3.0}}, 0.6, {Vec2d{-1.8, 0.2}, {1.9, -4.7}});
  const auto back = dimensions(topology(), named(topology(), design));
  ASSERT_EQ(back.parameters.size(), design.parameters.size());
  for (std::size_t i = 0; i < back.parameters.size(); ++i) {
    EXPECT_NEAR(back.parameters[i], design.parameters[i], 1e-13);
  }
  EXPECT_EQ(back.side, design.side);
}

}  // namespace
}  // namespace cognate::problems::three_pin_transmission_test
