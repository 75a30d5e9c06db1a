/// Positions, forces and the choice of loads allocate nothing once prepared.
#include <gtest/gtest.h>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::mechanism_allocations_test {
namespace {

using test::ChainMaker;

TEST(MechanismAllocations, NoneAtAPosition) {
  ChainMaker maker(1);
  for (int drive = 0; drive < 3; ++drive) {
    const Mechanism<double> mechanism = maker.make(drive, {0, 1, 2, 3, 4});
    const std::vector<Inertia> inertias(std::size_t(body_count(mechanism)), {1, {1, 2}, 3});
    std::vector<problems::LoadRule> rules(2);
    rules[0] = {.at = {4, {1, 0}}, .force = {1, 2}};
    rules[1] = {.at = {5, {0, 1}}, .torque = 3, .sense = problems::LoadSense::advance};

    MechanismMotion<2> motion(mechanism);
    InverseDynamics dynamics(mechanism, inertias, {0, -9.8});
    problems::ActiveLoads active(mechanism, rules);
    Forces forces = dynamics.forces();
    const DriveRate rate{1, 2};

    const std::size_t before = test::allocations();
    motion.move_to(ChainMaker::kStart);
    const std::span<const Load> loads =
        active.at<2>(ChainMaker::kStart, rate.speed, motion.bodies());
    dynamics.solve<2>(motion.bodies(), rate, loads, forces);
    forces.drive += dynamics.drive<2>(motion.bodies(), rate, loads);
    EXPECT_EQ(test::allocations(), before);
  }
  EXPECT_GT(test::allocations(), 0U);
}

TEST(MechanismAllocations, NoneAlongACourse) {
  // A parallelogram, and at its change points, where positions are interpolated.
  const Mechanism<double> mechanism{Crank<double>{{0, 0}, 1},
                                    {Rrr<double>{{1, {1, 0}}, {0, {3, 0}}, 3, 1}}};
  FollowedMotion<2> motion(mechanism, follow(mechanism, 1, 5));
  ASSERT_EQ(motion.assembly_ranges().points.size(), 1U);

  const std::size_t before = test::allocations();
  EXPECT_TRUE(motion.move_to(2));
  EXPECT_TRUE(motion.move_to(motion.assembly_ranges().points[0].drive));
  EXPECT_FALSE(motion.move_to(6));
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace cognate::mechanism_allocations_test
