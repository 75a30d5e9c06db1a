// The running machine of a four-bar: rows against central differences and against the metrics of
// finished linkages; these against closed forms and an integration of the equation of motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/machine/reduction.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/cycle/cycle_limits.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems::cycle_energy_test {
namespace {

/// A linkage of the class wanted, well away from its change points.
FourBar random_linkage(std::mt19937_64& random, MobilityClass wanted) {
  std::uniform_real_distribution<double> any(0, 1);
  const bool rocks = wanted == MobilityClass::crank_rocker;
  FourBar linkage;
  do {
    const double angle = kTurn * any(random), frame = rocks ? 1.5 + any(random) : 0.5;
    linkage.pivot_a = {any(random) - 0.5, any(random) - 0.5};
    linkage.pivot_d = linkage.pivot_a + frame * Vec2d{std::cos(angle), std::sin(angle)};
    linkage.crank = rocks ? 0.3 + 0.5 * any(random) : 1 + any(random);
    linkage.coupler = 1 + 2 * any(random);
    linkage.rocker = 1 + 2 * any(random);
    linkage.assembly = any(random) < 0.5 ? Assembly::open : Assembly::crossed;
    linkage.coupler_point = Vec2d{2 * any(random) - 0.5, 2 * any(random) - 1};
  } while (mobility_class(lengths(linkage)) != wanted ||
           transmission_angles(lengths(linkage)).acute_min < 0.4);
  return linkage;
}

/// With a load in each stroke of the rocker where it has some.
Operation machine(MobilityClass of, double speed) {
  Operation operation;
  operation.speed = speed;
  operation.flywheel = 3;
  operation.fluctuation = 0.15;
  operation.links[0] = {.centre = {.link = MovingLink::crank, .share = 0.5}, .mass_per_length = 2};
  operation.links[1] = {.mass = 0.5,
                        .centre = {.link = MovingLink::coupler, .share = 1, .offset = {-0.4, 0.3}},
                        .moment = 0.2};
  operation.links[2] = {.centre = {.link = MovingLink::rocker, .share = 0.5}, .mass_per_length = 1};
  operation.loads = {{{.link = MovingLink::coupler, .at_coupler_point = true}, {2, -3}, 0.5},
                     {{.link = MovingLink::rocker, .share = 1}, {0, 1}, -0.4},
                     {{.link = MovingLink::crank, .offset = {0.1, 0.2}}, {1, 1}, -0.3}};
  operation.gravity = {0.5, -2};
  if (of == MobilityClass::crank_rocker) {
    operation.loads.push_back(
        {{.link = MovingLink::rocker, .share = 1}, {3, 2}, -4, LoadSense::advance});
    operation.loads.push_back(
        {{.link = MovingLink::rocker, .offset = {0.2, 0.1}}, {1, 0}, 1, LoadSense::retreat});
  }
  return operation;
}

struct Case {
  FourBar linkage;
  Operation operation;
};

/// Both classes and both senses of turning.
std::vector<Case> cases(int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<Case> all;
  for (int trial = 0; trial < 12; ++trial) {
    const auto of = trial % 3 == 0 ? MobilityClass::double_crank : MobilityClass::crank_rocker;
    all.push_back({random_linkage(random, of), machine(of, trial % 2 == 0 ? 3.1 : -2.7)});
  }
  return all;
}

double motor_power(const FourBar& linkage, const Operation& operation) {
  return cycle_metric(CycleQuantity::motor_power, linkage, CycleOutput::coupler_point, operation);
}

double torque_ripple(const FourBar& linkage, const Operation& operation) {
  return cycle_metric(CycleQuantity::torque_ripple, linkage, CycleOutput::coupler_point, operation);
}

CycleDimensions dimensions(const FourBar& linkage) {
  return {lengths(linkage), linkage.coupler_point.value_or(Vec2d{}), linkage.pivot_a,
          frame_angle(linkage), linkage.assembly};
}

std::array<double*, 9> numbers(CycleDimensions& of) {
  return {&of.links.crank, &of.links.coupler,   &of.links.rocker,
          &of.links.frame, &of.coupler_point.x, &of.coupler_point.y,
          &of.pivot_a.x,   &of.pivot_a.y,       &of.frame_angle};
}

std::vector<double> rows(const CycleLimits& limits, const CycleDimensions& at) {
  std::vector<double> values(static_cast<std::size_t>(limits.count()));
  limits.evaluate(at, values, {});
  return values;
}

double least_row(const Constraints& constraints, const FourBar& linkage) {
  const CycleLimits limits(constraints, CycleOutput::coupler_point);
  return std::ranges::min(rows(limits, dimensions(linkage)));
}

TEST(TurnEnergy, SlopesAreThoseOfDifferences) {
  int count = 0, kinks = 0;
  for (const auto& [linkage, operation] : cases(1)) {
    Constraints constraints;
    constraints.cycle_max[CycleQuantity::speed_fluctuation] = 0.2;
    constraints.cycle_max[CycleQuantity::flywheel_inertia] = 5;
    constraints.cycle_max[CycleQuantity::motor_power] = 20;
    constraints.operation = operation;
    const CycleLimits limits(constraints, CycleOutput::coupler_point);
    CycleDimensions at = dimensions(linkage);
    std::vector<double> values(static_cast<std::size_t>(limits.count()));
    std::vector<LimitSlopes> slopes(values.size());
    limits.evaluate(at, values, slopes);
    EXPECT_EQ(values, rows(limits, at));
    const auto all = numbers(at);
    for (std::size_t i = 0; i < all.size(); ++i) {
      constexpr double kStep = 2e-6;
      const double here = *all.at(i);
      *all.at(i) = here + kStep;
      const auto high = rows(limits, at);
      *all.at(i) = here - kStep;
      const auto low = rows(limits, at);
      *all.at(i) = here;
      for (std::size_t row = 0; row < values.size(); ++row, ++count) {
        const double numeric = (high[row] - low[row]) / (2 * kStep);
        const double size = 1 + std::abs(numeric);
        if (std::abs(numeric - slopes[row][i]) > 1e-7 * size) ++kinks;
        EXPECT_NEAR(numeric, slopes[row][i], 0.02 * size) << "row " << row << " by " << i;
      }
    }
  }
  EXPECT_GT(count, 10000);
  EXPECT_LE(kinks, count / 200);
}

TEST(TurnEnergy, RowsAreZeroWhereTheMetricIsAtItsLimit) {
  for (const auto& [linkage, operation] : cases(2)) {
    Constraints constraints;
    constraints.operation = operation;
    constraints.cycle_max[CycleQuantity::speed_fluctuation] = speed_fluctuation(linkage, operation);
    ASSERT_LT(constraints.cycle_max[CycleQuantity::speed_fluctuation], 2);
    EXPECT_NEAR(least_row(constraints, linkage), 0, 1e-7);
    *constraints.cycle_max[CycleQuantity::speed_fluctuation] *= 1.01;
    EXPECT_GT(least_row(constraints, linkage), 1e-3);
    *constraints.cycle_max[CycleQuantity::speed_fluctuation] *= 0.98;
    EXPECT_LT(least_row(constraints, linkage), -1e-3);

    constraints.cycle_max[CycleQuantity::speed_fluctuation].reset();
    constraints.cycle_max[CycleQuantity::flywheel_inertia] =
        2 * flywheel_inertia(linkage, operation);
    EXPECT_NEAR(least_row(constraints, linkage), 0.5, 1e-7);

    constraints.cycle_max[CycleQuantity::flywheel_inertia].reset();
    constraints.cycle_max[CycleQuantity::motor_power] = motor_power(linkage, operation) / 3;
    EXPECT_NEAR(least_row(constraints, linkage), -std::log(3), 1e-7);
  }
}

/// Masses and loads of an operation as the kernel's bodies have them.
struct Bodies {
  std::vector<Inertia> inertias{1};
  std::vector<Load> always, advance, retreat;

  Bodies(const FourBar& linkage, const Operation& operation) {
    const double crank = operation.links[0].mass_per_length * linkage.crank;
    const double rocker = operation.links[2].mass_per_length * linkage.rocker;
    inertias.push_back({crank, {linkage.crank / 2, 0}, crank * std::pow(linkage.crank, 2) / 12});
    inertias.push_back({operation.links[1].mass,
                        Vec2d{linkage.coupler, 0} + operation.links[1].centre.offset,
                        operation.links[1].moment});
    inertias.push_back(
        {rocker, {linkage.rocker / 2, 0}, rocker * std::pow(linkage.rocker, 2) / 12});
    always = {{{2, *linkage.coupler_point}, {2, -3}, 0.5},
              {{3, {linkage.rocker, 0}}, {0, 1}, -0.4},
              {{1, {0.1, 0.2}}, {1, 1}, -0.3}};
    advance = retreat = always;
    advance.push_back({{3, {linkage.rocker, 0}}, {3, 2}, -4});
    retreat.push_back({{3, {0.2, 0.1}}, {1, 0}, 1});
  }
};

/// The greatest and least speed of a turn begun with some speed, and what it ends with.
struct Integrated {
  double greatest = 0, least = INFINITY, end = 0;
};

/// Integrates J ω dω/dφ + ½ ω² dJ/dφ = M by Runge's and Kutta's method, the drive giving the mean
/// of what loads and weights ask for.
Integrated integrated(const FourBar& linkage, const Operation& operation, bool rocks) {
  const Bodies of(linkage, operation);
  MechanismMotion<2> motion(as_mechanism(linkage));
  const auto load_torque = [&](double angle) {
    motion.move_to(angle);
    const bool advances = motion.bodies()[3].turn[0] * operation.speed > 0;
    const auto& loads = !rocks ? of.always : advances ? of.advance : of.retreat;
    return machine::load_torque(motion.bodies(), loads) +
           machine::weight_torque(motion.bodies(), of.inertias, operation.gravity);
  };
  constexpr int kSteps = 20000;
  constexpr double kStep = kTurn / kSteps;
  double drive = 0;
  for (int k = 0; k < kSteps; ++k) drive -= load_torque(kStep * k) / kSteps;
  const auto slope = [&](double angle, double speed) {
    const double torque = drive + load_torque(angle);
    const auto inertia = machine::equivalent_inertia(motion.bodies(), of.inertias);
    return (torque - 0.5 * speed * speed * inertia.slope) /
           ((inertia.value + operation.flywheel) * speed);
  };
  Integrated found;
  double speed = operation.speed;
  for (int k = 0; k < kSteps; ++k) {
    const double angle = kStep * k;
    found.greatest = std::max(found.greatest, std::abs(speed));
    found.least = std::min(found.least, std::abs(speed));
    const double k1 = slope(angle, speed);
    const double k2 = slope(angle + kStep / 2, speed + kStep / 2 * k1);
    const double k3 = slope(angle + kStep / 2, speed + kStep / 2 * k2);
    const double k4 = slope(angle + kStep, speed + kStep * k3);
    speed += kStep / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  found.end = speed;
  return found;
}

TEST(TurnEnergy, FluctuationIsThatOfTheEquationOfMotion) {
  int trial = 0;
  for (auto [linkage, operation] : cases(3)) {
    const auto found = integrated(linkage, operation, trial++ % 3 != 0);
    EXPECT_NEAR(found.end, operation.speed, 1e-6 * std::abs(operation.speed));
    operation.speed = std::copysign(0.5 * (found.greatest + found.least), operation.speed);
    const double wanted = (found.greatest - found.least) / std::abs(operation.speed);
    ASSERT_GT(wanted, 0.05);
    EXPECT_NEAR(speed_fluctuation(linkage, operation), wanted, 1e-6 * wanted) << trial;
  }
}

TEST(TurnEnergy, TheFlywheelLeavesTheFluctuationThatIsAskedFor) {
  int tested = 0;
  for (auto [linkage, operation] : cases(4)) {
    operation.flywheel = flywheel_inertia(linkage, operation);
    EXPECT_GT(operation.flywheel, 0);
    EXPECT_NEAR(speed_fluctuation(linkage, operation), operation.fluctuation, 1e-9);
    // Where the links are even enough alone, none is needed.
    operation.flywheel = 0;
    operation.fluctuation = 1.001 * speed_fluctuation(linkage, operation);
    if (operation.fluctuation >= 2) continue;
    ++tested;
    EXPECT_EQ(flywheel_inertia(linkage, operation), 0);
  }
  EXPECT_GE(tested, 4);
}

/// A weight at B of a crank whose moment alone counts: ½ J (ω_max² − ω_min²) is the work of the
/// weight over a crank's diameter.
TEST(TurnEnergy, OfConstantInertiaIsThatOfTheGreatestExcessWork) {
  std::mt19937_64 random(5);
  const FourBar linkage = random_linkage(random, MobilityClass::crank_rocker);
  Operation operation;
  operation.speed = 4;
  operation.fluctuation = 0.03;
  operation.flywheel = 6;
  operation.links[0].moment = 2;
  operation.loads = {{{.link = MovingLink::crank, .share = 1}, {0, -5}, 0}};
  const double excess = 2 * 5 * linkage.crank;
  EXPECT_NEAR(speed_fluctuation(linkage, operation), excess / (8 * 16), 1e-10);
  EXPECT_NEAR(flywheel_inertia(linkage, operation), excess / (0.03 * 16) - 2, 1e-9);
  EXPECT_NEAR(motor_power(linkage, operation), 5 * linkage.crank * 4, 1e-9);
}

/// Without loads the energy is constant: speeds are as one over the root of the inertia, which is
/// the flywheel's where the rocker turns back.
TEST(TurnEnergy, OfConstantEnergyIsThatOfTheInertia) {
  std::mt19937_64 random(6);
  const FourBar linkage = random_linkage(random, MobilityClass::crank_rocker);
  const Motion motion(linkage);
  double fastest = 0;
  for (double angle = 0; angle < kTurn; angle += kTurn / 20000) {
    constexpr double kStep = 1e-4;
    const double turned =
        motion.at(angle + kStep)->rocker_angle - motion.at(angle - kStep)->rocker_angle;
    fastest = std::max(fastest, std::abs(std::remainder(turned, kTurn)) / (2 * kStep));
  }
  Operation operation;
  operation.flywheel = 0.4;
  operation.links[2].moment = 3;
  const double low = std::sqrt(0.4), high = std::sqrt(0.4 + 3 * fastest * fastest);
  const double wanted = 2 * (high - low) / (high + low);
  for (const double speed : {0.1, -20.0}) {
    operation.speed = speed;
    EXPECT_NEAR(speed_fluctuation(linkage, operation), wanted, 1e-6);
  }
}

/// The torque of a load of one stroke acts there alone, either way the crank turns.
TEST(TurnEnergy, PowerOfALoadInOneStroke) {
  std::mt19937_64 random(7);
  const FourBar linkage = random_linkage(random, MobilityClass::crank_rocker);
  const Motion motion(linkage);
  for (const double speed : {2.5, -2.5}) {
    for (const LoadSense sense : {LoadSense::advance, LoadSense::retreat}) {
      const double way = sense == LoadSense::advance ? 1 : -1;
      Operation operation;
      operation.speed = speed;
      operation.loads = {{{.link = MovingLink::rocker}, {}, -6 * way, sense}};
      double fastest = 0;  // of the rocker, in the load's stroke
      for (double angle = 0; angle < kTurn; angle += kTurn / 20000) {
        constexpr double kStep = 1e-4;
        const double turned =
            motion.at(angle + kStep)->rocker_angle - motion.at(angle - kStep)->rocker_angle;
        fastest = std::max(fastest, way * speed * std::remainder(turned, kTurn) / (2 * kStep));
      }
      EXPECT_NEAR(motor_power(linkage, operation), 6 * fastest, 1e-5);
      EXPECT_NEAR(torque_ripple(linkage, operation), 6 * fastest / 2.5, 1e-5);
    }
  }
}

/// A load that no energy overcomes at so low a speed: the fluctuation goes on beyond 2.
TEST(TurnEnergy, BeyondStandstillTheFluctuationIsTwoAndMore) {
  std::mt19937_64 random(8);
  const FourBar linkage = random_linkage(random, MobilityClass::crank_rocker);
  Operation operation;
  operation.flywheel = 1;
  operation.loads = {{{.link = MovingLink::crank, .share = 1}, {0, -5}, 0}};
  const double excess = 2 * 5 * linkage.crank;
  // ω_min = 0 where ½ J (2 ω)² is the excess.
  operation.speed = 1.0001 * std::sqrt(excess / 2);
  EXPECT_LT(speed_fluctuation(linkage, operation), 2);
  operation.speed = 0.9999 * std::sqrt(excess / 2);
  EXPECT_GT(speed_fluctuation(linkage, operation), 2);
  operation.speed = 0.1 * std::sqrt(excess / 2);
  EXPECT_GT(speed_fluctuation(linkage, operation), 10);
}

/// Six timed points of a linkage whose steadier neighbours miss them.
TEST(TurnEnergy, AFrontGetsSteadierAsItsErrorGrows) {
  const FourBar planted{{0, 0}, {2, 0.5}, 0.7, 2.1, 1.8, Assembly::open, Vec2d{1.2, 0.9}};
  PathProblem problem;
  problem.timing = Timing::prescribed;
  problem.crank_reference = CrankReference::global;
  problem.crank_angles = {0.2, 0.9, 1.7, 2.6, 3.6, 4.9};
  for (const double angle : problem.crank_angles) {
    problem.points.push_back(*Motion(planted).at(angle)->coupler_point);
  }
  problem.weights.assign(problem.points.size(), 1.0);
  problem.given.pivot_a = planted.pivot_a;
  problem.given.pivot_d = planted.pivot_d;
  problem.given.crank = planted.crank;
  problem.given.assembly = planted.assembly;
  problem.given.coupler_point = planted.coupler_point;
  problem.bounds.coupler = problem.bounds.rocker = Range{1.2, 3};
  Constraints& constraints = problem.constraints;
  constraints.required_class = RequiredClass::crank_rocker;
  constraints.cycle_max[CycleQuantity::speed_fluctuation] = INFINITY;
  constraints.operation = machine(MobilityClass::crank_rocker, 3);
  problem.solve.objectives = {DesignObjective::error,
                              objective_of(CycleQuantity::speed_fluctuation)};
  problem.solve.designs = 3;
  problem.solve.starts = 6;
  const Result result = solve(problem, {.threads = 2});
  ASSERT_EQ(result.status, Status::solved) << (result.notes.empty() ? "" : result.notes[0]);
  ASSERT_EQ(result.designs.size(), 3);
  const double begin = speed_fluctuation(planted, constraints.operation);
  EXPECT_NEAR(*result.designs.front().metrics.cycle[CycleQuantity::speed_fluctuation], begin, 1e-5);
  for (std::size_t i = 1; i < result.designs.size(); ++i) {
    const Design &before = result.designs[i - 1], &after = result.designs[i];
    EXPECT_GT(after.error.rms, before.error.rms);
    EXPECT_LT(*after.metrics.cycle[CycleQuantity::speed_fluctuation],
              *before.metrics.cycle[CycleQuantity::speed_fluctuation] * (1 - 1e-3));
  }
}

}  // namespace
}  // namespace cognate::problems::cycle_energy_test
