/// Forces in random mechanisms of every dyad and drive: against one dense system of Newton's and
/// Euler's equations in 113 bits, against virtual work, and as a whole.
#include "analysis/mechanism/inverse_dynamics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "analysis/mechanism/convert.hpp"
#include "tests/support/dense_forces.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::inverse_dynamics_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using test::ChainMaker;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A mechanism with its motion and loads.
struct Task {
  Mechanism<double> mechanism;
  std::vector<Inertia> inertias;
  std::vector<Load> loads;
  DriveRate rate;
  Vec2d gravity;

  InverseDynamics dynamics() const { return {mechanism, inertias, gravity}; }
};

Task random_task(ChainMaker& maker, int drive, const std::vector<int>& types) {
  const auto some = [&] { return maker.uniform(-2, 2); };
  Task task{.mechanism = maker.make(drive, types)};
  const int bodies = body_count(task.mechanism);
  for (int i = 0; i < bodies; ++i) {
    task.inertias.push_back({maker.uniform(0.1, 2), {some(), some()}, maker.uniform(0.1, 1)});
  }
  for (int i = 0; i < 3; ++i) {
    const int on = 1 + static_cast<int>(maker.uniform(0, bodies - 1.01));
    task.loads.push_back({{on, {some(), some()}}, {10 * some(), 10 * some()}, 10 * some()});
  }
  task.rate = {some(), some()};
  task.gravity = {some(), 5 * some()};
  return task;
}

bool is_well_closed(const Mechanism<double>& mechanism) {
  MechanismMotion<0> motion(mechanism);
  motion.move_to(ChainMaker::kStart);
  return std::ranges::all_of(motion.closures(), [](const DyadClosure<double>& closure) {
    return std::abs(closure.sine) > 0.2;
  });
}

/// Chains of three dyads in every order, with each drive but a cylinder in turn, and then some with
/// that.
std::vector<Task> random_tasks(unsigned seed) {
  ChainMaker maker(seed);
  std::vector<Task> tasks;
  constexpr int kOrders = 125, kWithCylinder = 50;
  for (int i = 0; i < kOrders + kWithCylinder; ++i) {
    do {
      tasks.resize(std::size_t(i));
      const int drive = i < kOrders ? i % 3 : 3;
      tasks.push_back(random_task(maker, drive, {i / 25 % 5, i / 5 % 5, i % 5}));
    } while (!is_well_closed(tasks.back().mechanism));
  }
  return tasks;
}

/// What 113 bits say of the task's motion.
std::vector<BodyMotion<Quad, 2>> quad_motion(const Mechanism<double>& mechanism,
                                             const DrivePosition<Quad>& drive) {
  const std::vector<double> signs = sides(mechanism);
  const std::vector<Quad> quad_signs(signs.begin(), signs.end());
  std::vector<BodyMotion<Quad, 2>> bodies(std::size_t(body_count(mechanism)));
  std::vector<DyadClosure<Quad>> closures(signs.size());
  evaluate<2, Quad>(convert<Quad>(mechanism), drive, quad_signs, bodies, closures);
  return bodies;
}

DrivePosition<Quad> quad_position(double coordinate) {
  return {{cos(Quad(coordinate)), sin(Quad(coordinate))}, Quad(coordinate)};
}

double magnitude(const Vec2d& v) {
  return std::hypot(v.x, v.y);
}

/// The greatest force, and moment over length 1, in the mechanism.
double greatest(const Forces& forces) {
  double size = std::abs(forces.drive);
  for (const Reaction& reaction : forces.reactions) {
    size = std::max({size, magnitude(reaction.force), std::abs(reaction.moment)});
  }
  return size;
}

double greatest_difference(const Forces& forces, const test::DenseForces<Quad>& exact) {
  double size = std::abs(double(forces.drive - exact.drive));
  for (std::size_t i = 0; i < forces.reactions.size(); ++i) {
    const Reaction& reaction = forces.reactions[i];
    size = std::max({size, std::abs(double(reaction.force.x - exact.force[i].x)),
                     std::abs(double(reaction.force.y - exact.force[i].y)),
                     std::abs(double(reaction.moment - exact.moment[i]))});
  }
  return size;
}

/// A mechanism where it stands, with its forces.
struct Solved {
  MechanismMotion<2> motion;
  Forces forces;
  bool ok = false;

  Solved(const Task& task, double coordinate) : motion(task.mechanism) {
    motion.move_to(coordinate);
    InverseDynamics dynamics = task.dynamics();
    forces = dynamics.forces();
    ok = dynamics.solve<2>(motion.bodies(), task.rate, task.loads, forces);
  }
};

TEST(InverseDynamics, EqualsOneDenseSystemInHigherPrecision) {
  for (const Task& task : random_tasks(1)) {
    const Solved solved(task, ChainMaker::kStart);
    ASSERT_TRUE(solved.ok);
    const test::DenseBalance<Quad> balance(
        task.mechanism, quad_motion(task.mechanism, quad_position(ChainMaker::kStart)),
        task.inertias);
    const auto exact = balance.solve(task.rate, task.loads, task.gravity);
    EXPECT_LE(greatest_difference(solved.forces, exact), 40 * epsilon * greatest(solved.forces));
  }
}

TEST(InverseDynamics, DriveDoesTheWorkOfInertiaAndLoads) {
  for (const Task& task : random_tasks(2)) {
    const Solved solved(task, ChainMaker::kStart);
    ASSERT_TRUE(solved.ok);
    const double drive = task.dynamics().drive<2>(solved.motion.bodies(), task.rate, task.loads);
    EXPECT_NEAR(solved.forces.drive, drive, 40 * epsilon * greatest(solved.forces));
  }
}

/// Power of drive, loads and gravity = d/dt of the kinetic energy, by central differences in 113
/// bits: nothing here knows an acceleration or a reaction.
TEST(InverseDynamics, PowerIsTheRateOfKineticEnergy) {
  for (const Task& task : random_tasks(3)) {
    const auto energy = [&](const Quad& time) {
      const Quad q =
          ChainMaker::kStart + task.rate.speed * time + task.rate.acceleration * time * time / 2;
      const Quad speed = task.rate.speed + task.rate.acceleration * time;
      const auto bodies = quad_motion(task.mechanism, {{cos(q), sin(q)}, q});
      Quad sum = 0;
      for (std::size_t i = 1; i < bodies.size(); ++i) {
        const auto& [mass, centre, moment] = task.inertias[i];
        const auto at = point_motion(bodies[i], Vec2<Quad>{centre.x, centre.y});
        const Quad turning = moment * bodies[i].turn[0] * bodies[i].turn[0];
        sum += (mass * squared_norm(at[1]) + turning) * speed * speed / 2;
        sum -= mass * (task.gravity.x * at[0].x + task.gravity.y * at[0].y);
      }
      return sum;
    };
    const Quad step = 1e-8;
    const double rise = double((energy(step) - energy(-step)) / (2 * step));

    const Solved solved(task, ChainMaker::kStart);
    double power = solved.forces.drive * task.rate.speed;
    for (const Load& load : task.loads) {
      const auto& body = solved.motion.bodies()[std::size_t(load.at.body)];
      power += task.rate.speed *
               (dot(load.force, solved.motion.point(load.at)[1]) + load.torque * body.turn[0]);
    }
    EXPECT_NEAR(power, rise, 1e-12 * greatest(solved.forces));
  }
}

TEST(InverseDynamics, FrameBearsLoadsWeightsAndInertia) {
  for (const Task& task : random_tasks(4)) {
    const Solved solved(task, ChainMaker::kStart);
    Vec2d force{};
    double moment = 0;  // about the global origin
    for (std::size_t i = 1; i < solved.motion.bodies().size(); ++i) {
      const auto& [mass, centre, inertia] = task.inertias[i];
      const auto& turn = solved.motion.bodies()[i].turn;
      const auto at = solved.motion.point({int(i), centre});
      const double speed2 = task.rate.speed * task.rate.speed;
      const Vec2d a = speed2 * at[2] + task.rate.acceleration * at[1];
      const Vec2d inertia_force = mass * (task.gravity - a);
      force = force + inertia_force;
      moment += cross(at[0], inertia_force) -
                inertia * (speed2 * turn[1] + task.rate.acceleration * turn[0]);
    }
    for (const Load& load : task.loads) {
      force = force + load.force;
      moment += load.torque + cross(solved.motion.point(load.at)[0], load.force);
    }
    double reach = 1;
    for (const auto& body : solved.motion.bodies()) {
      reach = std::max(reach, magnitude(body.origin[0]));
    }
    const double bound = 40 * epsilon * greatest(solved.forces);
    EXPECT_NEAR(solved.forces.shaking_force.x, force.x, bound);
    EXPECT_NEAR(solved.forces.shaking_force.y, force.y, bound);
    EXPECT_NEAR(solved.forces.shaking_moment, moment, bound * reach);
  }
}

// Scaling. `k` is a power of two, so that nothing is rounded.

Attached<double> scaled(double k, const Attached<double>& point) {
  return {point.body, k * point.at};
}
Guide<double> scaled(double k, const Guide<double>& g) {
  return {g.body, k * g.through, g.direction, k * g.offset};
}
Drive<double> scaled(double k, const Crank<double>& crank) {
  return Crank<double>{k * crank.pivot, k * crank.length};
}
Drive<double> scaled(double k, const DrivingSlider<double>& slider) {
  return DrivingSlider<double>{scaled(k, slider.guide)};
}
Drive<double> scaled(double k, const FloatingLink<double>& link) {
  return FloatingLink<double>{scaled(k, link.first), scaled(k, link.second), k * link.length};
}
Drive<double> scaled(double, const DrivingRod<double>& rod) {
  return rod;
}
Dyad<double> scaled(double k, const Rrr<double>& d) {
  return Rrr<double>{scaled(k, d.first), scaled(k, d.second), k * d.first_length,
                     k * d.second_length, d.assembly};
}
Dyad<double> scaled(double k, const Rrp<double>& d) {
  return Rrp<double>{scaled(k, d.point), k * d.length, scaled(k, d.guide), d.assembly};
}
Dyad<double> scaled(double k, const Rpr<double>& d) {
  return Rpr<double>{scaled(k, d.block), scaled(k, d.pivot), k * d.offset, d.assembly};
}
Dyad<double> scaled(double k, const Prp<double>& d) {
  return Prp<double>{scaled(k, d.first), scaled(k, d.second)};
}
Dyad<double> scaled(double k, const Rpp<double>& d) {
  return Rpp<double>{scaled(k, d.point), d.slot, scaled(k, d.guide)};
}

Dyad<double> scaled(double k, const Cylinder<double>& d) {
  return Cylinder<double>{scaled(k, d.base), scaled(k, d.pivot), k * d.length, d.assembly};
}

// No task here has a group (group_test.cpp).
Dyad<double> scaled(double, const Group& group) {
  return group;
}
Dyad<double> scaled(double, const GroupRest& rest) {
  return rest;
}

/// The task with lengths in a unit k times smaller: forces are k times as many, moments k² times.
Task scaled(double k, Task task) {
  const auto scale = [k](const auto& part) { return scaled(k, part); };
  task.mechanism.drive = std::visit(scale, task.mechanism.drive);
  for (Dyad<double>& dyad : task.mechanism.dyads) dyad = std::visit(scale, dyad);
  for (Inertia& inertia : task.inertias) {
    inertia = {inertia.mass, k * inertia.centre, k * k * inertia.moment};
  }
  for (Load& load : task.loads) load = {scaled(k, load.at), k * load.force, k * k * load.torque};
  task.gravity = k * task.gravity;
  return task;
}

TEST(InverseDynamics, UnitOfLengthChangesNoDigit) {
  constexpr double k = 1024;
  for (const Task& task : random_tasks(5)) {
    Task in_small = scaled(k, task);
    // A displacement is a length itself, and a force drives it.
    const bool slides = driven_by_length(task.mechanism.drive);
    const double of_drive = slides ? k : 1;
    in_small.rate = {of_drive * task.rate.speed, of_drive * task.rate.acceleration};
    const Solved metres(task, ChainMaker::kStart), small(in_small, of_drive * ChainMaker::kStart);
    EXPECT_EQ(small.forces.drive, k * k / of_drive * metres.forces.drive);
    EXPECT_EQ(small.forces.shaking_force, k * metres.forces.shaking_force);
    for (std::size_t i = 0; i < metres.forces.reactions.size(); ++i) {
      EXPECT_EQ(small.forces.reactions[i].force, k * metres.forces.reactions[i].force);
      EXPECT_EQ(small.forces.reactions[i].moment, k * k * metres.forces.reactions[i].moment);
    }
  }
}

/// A mechanism whose crank stops at `dead_point`.
struct Stopping {
  Task task;
  double dead_point = 0;
};

/// A four-bar: coupler and rocker in line.
Stopping stopping_four_bar() {
  Task task;
  task.mechanism.drive = Crank<double>{{0, 0}, 2};
  task.mechanism.dyads = {Rrr<double>{{1, {2, 0}}, {0, {3, 0}}, 1.5, 2}};
  task.inertias = {{}, {1, {1, 0}, 0.1}, {2, {0.7, 0.1}, 0.2}, {1.5, {0.9, 0}, 0.3}};
  task.loads = {{{3, {1, 0.5}}, {3, -2}, 5}};
  task.rate = {1, 0.5};
  task.gravity = {0, -9.8};
  return {task, std::acos((2 * 2 + 3 * 3 - 3.5 * 3.5) / (2 * 2 * 3))};
}

/// A slider-crank with a coupler too short: it stands across the slide.
Stopping stopping_slider_crank() {
  auto [task, unused] = stopping_four_bar();
  task.mechanism.dyads = {Rrp<double>{{1, {2, 0}}, 1.5, {0, {0, 0}, {1, 0}, 0.25}}};
  return {task, std::asin((1.5 + 0.25) / 2)};
}

/// The forces grow as 1/sine⁴ towards the dead point (accelerations as 1/sine³), so that a relative
/// change of the lengths by ε changes them by some ε/sine².
TEST(InverseDynamics, ErrorNearADeadPointGrowsWithItsCondition) {
  for (const auto& [task, dead_point] : {stopping_four_bar(), stopping_slider_crank()}) {
    for (int i = 1; i <= 48; ++i) {
      const double angle = dead_point - std::exp2(-i);
      const Solved solved(task, angle);
      ASSERT_TRUE(solved.ok);
      const DrivePosition<double> drive = drive_position(task.mechanism, angle);
      const test::DenseBalance<Quad> balance(
          task.mechanism, quad_motion(task.mechanism, {{drive.direction.x, drive.direction.y}, 0}),
          task.inertias);
      const auto exact = balance.solve(task.rate, task.loads, task.gravity);
      const double sine = solved.motion.closures()[0].sine;
      EXPECT_LE(greatest_difference(solved.forces, exact),
                10 * epsilon / (sine * sine) * greatest(solved.forces))
          << angle;
    }
  }
}

TEST(InverseDynamics, SaysWhereForcesAreNotNumbers) {
  auto [task, dead_point] = stopping_four_bar();
  EXPECT_FALSE(Solved(task, dead_point + 0.1).ok);  // not to be assembled
  task.mechanism.dyads = {Rrr<double>{{1, {2, 0}}, {0, {5, 0}}, 1, 2}};
  EXPECT_FALSE(Solved(task, 0).ok);  // exactly in line
}

TEST(InverseDynamics, DriveAtRestNeedsNoSecondDerivative) {
  for (Task task : random_tasks(6)) {
    task.rate.speed = 0;
    const Solved solved(task, ChainMaker::kStart);
    MechanismMotion<1> motion(task.mechanism);
    motion.move_to(ChainMaker::kStart);
    InverseDynamics dynamics = task.dynamics();
    Forces forces = dynamics.forces();
    ASSERT_TRUE(dynamics.solve<1>(motion.bodies(), task.rate, task.loads, forces));
    EXPECT_EQ(forces.drive, solved.forces.drive);
    EXPECT_EQ(dynamics.drive<1>(motion.bodies(), task.rate, task.loads),
              dynamics.drive<2>(solved.motion.bodies(), task.rate, task.loads));
  }
}

}  // namespace
}  // namespace cognate::inverse_dynamics_test
