// Limits over the full turn: rows against central differences, extremes against scans of positions
// and of Newton's and Euler's equations.
#include "problems/linkage/cycle/cycle_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <optional>
#include <random>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/model.hpp"
#include "problems/guidance/model.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/path/model.hpp"
#include "tests/support/driven_linkage.hpp"

namespace cognate::problems::cycle_limits_test {
namespace {

using test::machine;
using test::peak_acceleration;

double peak_speed(const FourBar& linkage, CycleOutput output, double speed) {
  Operation operation;
  operation.speed = speed;
  return cycle_metric(CycleQuantity::peak_speed, linkage, output, operation);
}

double of_torque(CycleQuantity quantity, const FourBar& linkage, const Operation& operation) {
  return cycle_metric(quantity, linkage, CycleOutput::coupler_point, operation);
}

/// A crank-rocker well away from its change points.
FourBar random_linkage(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(0, 1);
  FourBar linkage;
  do {
    const double angle = kTurn * any(random), frame = 1.5 + any(random);
    linkage.pivot_a = {any(random) - 0.5, any(random) - 0.5};
    linkage.pivot_d = linkage.pivot_a + frame * Vec2d{std::cos(angle), std::sin(angle)};
    linkage.crank = 0.3 + 0.5 * any(random);
    linkage.coupler = 1 + 2 * any(random);
    linkage.rocker = 1 + 2 * any(random);
    linkage.assembly = any(random) < 0.5 ? Assembly::open : Assembly::crossed;
    linkage.coupler_point = Vec2d{2 * any(random) - 0.5, 2 * any(random) - 1};
  } while (mobility_class(lengths(linkage)) != MobilityClass::crank_rocker ||
           transmission_angles(lengths(linkage)).acute_min < 0.4);
  return linkage;
}

Constraints all_limits() {
  Constraints constraints;
  constraints.required_class = RequiredClass::crank_rocker;
  constraints.clearances = {{MovingPoint::coupler_point, true, {{-1, -2}, {2, INFINITY}}},
                            {MovingPoint::coupler_point, false, {{0.5, 0.5}, {1.5, 0.9}}},
                            {MovingPoint::b, false, {{-0.2, 0.2}, {0.4, 0.4}}},
                            {MovingPoint::c, true, {{-3, -1}, {2, 2}}}};
  constraints.cycle_max[CycleQuantity::peak_speed] = 1.5;
  constraints.cycle_max[CycleQuantity::peak_acceleration] = 2;
  constraints.cycle_max[CycleQuantity::torque_ripple] = 30;
  constraints.cycle_max[CycleQuantity::peak_torque] = 25;
  constraints.cycle_max[CycleQuantity::rms_torque] = 8;
  constraints.cycle_max[CycleQuantity::speed_fluctuation] = 0.4;
  constraints.cycle_max[CycleQuantity::flywheel_inertia] = 50;
  constraints.cycle_max[CycleQuantity::motor_power] = 20;
  constraints.operation = machine();
  constraints.operation.fluctuation = 0.1;
  constraints.operation.flywheel = 30;
  return constraints;
}

CycleDimensions dimensions(const FourBar& linkage) {
  return {lengths(linkage), linkage.coupler_point.value_or(Vec2d{}), linkage.pivot_a,
          frame_angle(linkage), linkage.assembly};
}

/// Derivatives of the constraints of `model` against central differences.
void expect_slopes(const synthesis::Model& model, std::vector<double> x) {
  const auto rows = static_cast<std::size_t>(model.constraint_count());
  const auto n = static_cast<std::size_t>(model.global_count());
  ASSERT_GT(rows, 50);
  std::vector<double> c(rows), jacobian(rows * n), high(rows), low(rows);
  model.constraints(x, c, jacobian);
  int kinks = 0;
  for (std::size_t i = 0; i < n; ++i) {
    constexpr double kStep = 2e-6;
    const double at = x[i];
    x[i] = at + kStep;
    model.constraints(x, high, {});
    x[i] = at - kStep;
    model.constraints(x, low, {});
    x[i] = at;
    for (std::size_t row = 0; row < rows; ++row) {
      const double numeric = (high[row] - low[row]) / (2 * kStep);
      const double size = 1 + std::abs(numeric);
      if (std::abs(numeric - jacobian[row * n + i]) > 1e-7 * size) ++kinks;
      EXPECT_NEAR(numeric, jacobian[row * n + i], 0.02 * size) << "row " << row << " by " << i;
    }
  }
  EXPECT_LE(kinks, static_cast<int>(rows * n) / 200);
}

TEST(CycleLimits, SlopesOfAPathModel) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const FourBar linkage = random_linkage(random);
    PathProblem problem;
    problem.points = {{0, 0}, {1, 0}, {1, 1}};
    problem.constraints = all_limits();
    if (trial % 2 == 1) problem.given.pivot_d = linkage.pivot_d;
    const PathModel model(problem, linkage.assembly, false);
    EXPECT_FALSE(model.has_hessian());
    expect_slopes(model, model.variables_of(linkage, std::vector{0.1, 0.2, 0.3}));
  }
}

TEST(CycleLimits, SlopesOfAFunctionModel) {
  std::mt19937_64 random(2);
  FunctionProblem problem;
  problem.target = AnglePairs{{0, 0}, {0.5, 0.4}, {1, 0.6}};
  problem.constraints = all_limits();
  problem.constraints.clearances.clear();
  problem.constraints.operation.loads[0].at = {.link = MovingLink::coupler, .offset = {0.4, 0.2}};
  const FunctionSamples samples = function_samples(problem);
  for (int trial = 0; trial < 20; ++trial) {
    const FourBar linkage = random_linkage(random);
    const FunctionModel model(problem, samples, linkage.assembly,
                              synthesis::Objective::sum_of_squares);
    EXPECT_FALSE(model.has_hessian());
    expect_slopes(model, model.variables_of({lengths(linkage), linkage.assembly, 0.3, 1.2}));
  }
}

/// A body on the coupler of `linkage`, its origin at the coupler point.
TEST(CycleLimits, SlopesAndExtremesOfAMotionModel) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const FourBar linkage = random_linkage(random);
    MotionProblem problem;
    problem.method = MotionMethod::least_squares;
    problem.constraints = all_limits();
    problem.dyads = {synthesis::DyadKind::rr};
    std::optional<Pose> first;
    for (const double angle : {0.3, 0.9, 1.6, 2.5}) {
      const Pose pose = *Motion(linkage).at(angle);
      const Vec2d along = (1 / linkage.coupler) * (pose.c - pose.b);
      problem.poses.push_back({*pose.coupler_point, std::atan2(along.y, along.x)});
      if (!first) first = pose;
    }
    const Vec2d b = -*linkage.coupler_point, c = b + Vec2d{linkage.coupler, 0};
    using synthesis::DyadKind;
    const DyadPair pair{{DyadKind::rr, b, first->b, linkage.pivot_a, {1, 0}, linkage.crank},
                        {DyadKind::rr, c, first->c, linkage.pivot_d, {1, 0}, linkage.rocker}};
    const MotionModel model(problem, form_of(problem, pair));
    const std::vector<double> x = model.variables_of(pair);
    expect_slopes(model, x);

    // The rows are those of the linkage itself.
    const CycleLimits limits(problem.constraints, CycleOutput::coupler_point);
    std::vector<double> direct(static_cast<std::size_t>(limits.count())),
        rows(static_cast<std::size_t>(model.constraint_count()));
    limits.evaluate(dimensions(linkage), direct, {});
    model.constraints(x, rows, {});
    for (std::size_t i = 0; i < direct.size(); ++i) {
      EXPECT_NEAR(rows[rows.size() - direct.size() + i], direct[i], 1e-9) << i;
    }
  }
}

/// The least row of a model with one limit alone.
double least_row(const FourBar& linkage, const Constraints& constraints, CycleOutput output) {
  const CycleLimits limits(constraints, output);
  std::vector<double> rows(static_cast<std::size_t>(limits.count()));
  limits.evaluate(dimensions(linkage), rows, {});
  return *std::ranges::min_element(rows);
}

/// Coupler point and rocker's angle in extended precision, by the triangle of B, C and D.
class LongMotion {
 public:
  using Place = std::complex<long double>;

  explicit LongMotion(const FourBar& linkage)
      : of_(linkage),
        a_(linkage.pivot_a.x, linkage.pivot_a.y),
        d_(linkage.pivot_d.x, linkage.pivot_d.y) {
    const Pose pose = *Motion(linkage).at(0);
    const Place c = from_b(0) + b(0);
    if (std::abs(c - Place(pose.c.x, pose.c.y)) > 1e-6L) side_ = -1;
  }

  Place coupler_point(long double crank) const {
    const Place arm(of_.coupler_point->x, of_.coupler_point->y);
    return b(crank) + from_b(crank) / static_cast<long double>(of_.coupler) * arm;
  }
  Place rocker_direction(long double crank) const {
    return (b(crank) + from_b(crank) - d_) / static_cast<long double>(of_.rocker);
  }

 private:
  Place b(long double crank) const {
    return a_ + std::polar(static_cast<long double>(of_.crank), crank);
  }
  /// From B to C, by the law of cosines.
  Place from_b(long double crank) const {
    const Place to_d = d_ - b(crank);
    const long double away = std::abs(to_d), coupler = of_.coupler, rocker = of_.rocker;
    const long double cosine =
        (coupler * coupler + away * away - rocker * rocker) / (2 * coupler * away);
    return std::polar(coupler, std::arg(to_d) + side_ * std::acos(cosine));
  }

  const FourBar& of_;
  Place a_, d_;
  int side_ = 1;
};

/// Peak speed by differences of those positions, extrapolated, at the best of many angles, refined.
long double differenced_speed(const FourBar& linkage, CycleOutput output) {
  const LongMotion motion(linkage);
  const auto difference = [&](long double angle, long double h) {
    if (output == CycleOutput::coupler_point) {
      return (motion.coupler_point(angle + h) - motion.coupler_point(angle - h)) / (2 * h);
    }
    return (motion.rocker_direction(angle + h) - motion.rocker_direction(angle - h)) / (2 * h);
  };
  const auto speed = [&](long double angle) {
    constexpr long double h = 2e-4L;
    return std::abs((4.0L * difference(angle, h) - difference(angle, 2 * h)) / 3.0L);
  };
  constexpr int kAngles = 3000;
  constexpr long double kStep = kTurn / kAngles;
  int best = 0;
  for (int k = 1; k < kAngles; ++k) {
    if (speed(k * kStep) > speed(best * kStep)) best = k;
  }
  long double low = (best - 1) * kStep, high = (best + 1) * kStep;
  for (int i = 0; i < 60; ++i) {
    const long double third = (high - low) / 3;
    if (speed(low + third) < speed(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  return speed((low + high) / 2);
}

TEST(CycleLimits, PeakSpeedIsThatOfDifferencesInExtendedPrecision) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 10; ++trial) {
    const FourBar linkage = random_linkage(random);
    for (const CycleOutput output : {CycleOutput::coupler_point, CycleOutput::rocker}) {
      for (const double speed : {1.3, -2.0}) {
        const double wanted =
            std::abs(speed) * static_cast<double>(differenced_speed(linkage, output));
        EXPECT_NEAR(peak_speed(linkage, output, speed), wanted, 1e-10 * wanted);
        Constraints constraints;
        constraints.operation.speed = speed;
        constraints.cycle_max[CycleQuantity::peak_speed] = 1.5 * wanted;
        EXPECT_NEAR(least_row(linkage, constraints, output), 1 - 1 / 1.5, 1e-8);
        constraints.cycle_max[CycleQuantity::peak_speed] = wanted / 3;
        EXPECT_NEAR(least_row(linkage, constraints, output), -std::log(3), 1e-8);
      }
    }
  }
}

/// Peak acceleration by second differences of positions, extrapolated.
double scanned_acceleration(const FourBar& linkage, bool of_rocker, double speed) {
  const Motion motion(linkage);
  const auto at = [&](double angle) {
    const Pose pose = *motion.at(angle);
    return std::pair(*pose.coupler_point, pose.rocker_angle);
  };
  const auto second = [&](double angle, double h) {
    const auto low = at(angle - h), here = at(angle), high = at(angle + h);
    const auto turned = [&](double to) { return std::remainder(to - here.second, kTurn); };
    if (of_rocker) return std::abs(turned(low.second) + turned(high.second)) / (h * h);
    return norm(high.first - 2.0 * here.first + low.first) / (h * h);
  };
  double most = 0;
  for (double angle = 0; angle < kTurn; angle += kTurn / 4000) {
    most = std::max(most, (4 * second(angle, 1e-3) - second(angle, 2e-3)) / 3);
  }
  return most * speed * speed;
}

TEST(CycleLimits, PeakAccelerationIsThatOfSecondDifferences) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const FourBar linkage = random_linkage(random);
    for (const CycleOutput output : {CycleOutput::coupler_point, CycleOutput::rocker}) {
      const double speed = 1.3;
      const double wanted = scanned_acceleration(linkage, output == CycleOutput::rocker, speed);
      EXPECT_NEAR(peak_acceleration(linkage, output, speed), wanted, 1e-5 * wanted);
      Constraints constraints;
      constraints.cycle_max[CycleQuantity::peak_acceleration] = 1.5 * wanted;
      constraints.operation.speed = speed;
      EXPECT_NEAR(least_row(linkage, constraints, output), 1 - 1 / 1.5, 1e-5);
      constraints.cycle_max[CycleQuantity::peak_acceleration] = wanted / 3;
      EXPECT_NEAR(least_row(linkage, constraints, output), -std::log(3), 3e-5);
    }
  }
}

struct ScannedTorque {
  double ripple = 0, peak = 0, rms = 0;

  double of(CycleQuantity quantity) const {
    if (quantity == CycleQuantity::peak_torque) return peak;
    return quantity == CycleQuantity::rms_torque ? rms : ripple;
  }
};

/// By Newton's and Euler's equations of every link at many crank angles.
ScannedTorque scanned_torque(const FourBar& linkage, const Operation& operation) {
  std::vector<Inertia> inertias(4);
  const double crank = operation.links[0].mass_per_length * linkage.crank;
  const double rocker = operation.links[2].mass_per_length * linkage.rocker;
  inertias[1] = {crank, {linkage.crank / 2, 0}, crank * linkage.crank * linkage.crank / 12};
  inertias[2] = {operation.links[1].mass,
                 Vec2d{linkage.coupler, 0} + operation.links[1].centre.offset,
                 operation.links[1].moment};
  inertias[3] = {rocker, {linkage.rocker / 2, 0}, rocker * linkage.rocker * linkage.rocker / 12};
  const std::vector<Load> loads{{{2, *linkage.coupler_point}, {2, -3}, 0.5},
                                {{3, {linkage.rocker, 0}}, {0, 1}, 0},
                                {{1, {0.1, 0.2}}, {1, 1}, -0.3}};
  MechanismMotion<2> motion(as_mechanism(linkage));
  InverseDynamics dynamics(motion.mechanism(), inertias, operation.gravity);
  Forces forces = dynamics.forces();
  double least = INFINITY, most = -INFINITY, squares = 0;
  constexpr int kAngles = 20000;
  for (int k = 0; k < kAngles; ++k) {
    EXPECT_TRUE(motion.move_to(kTurn * k / kAngles));
    EXPECT_TRUE(dynamics.solve(motion.bodies(), {operation.speed, 0}, loads, forces));
    least = std::min(least, forces.drive);
    most = std::max(most, forces.drive);
    squares += forces.drive * forces.drive;
  }
  return {most - least, std::max(most, -least), std::sqrt(squares / kAngles)};
}

TEST(CycleLimits, TorquesAreThoseOfNewtonAndEuler) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 10; ++trial) {
    const FourBar linkage = random_linkage(random);
    const ScannedTorque scanned = scanned_torque(linkage, machine());
    for (const auto quantity :
         {CycleQuantity::torque_ripple, CycleQuantity::peak_torque, CycleQuantity::rms_torque}) {
      const double wanted = scanned.of(quantity);
      EXPECT_NEAR(of_torque(quantity, linkage, machine()), wanted, 1e-6 * wanted);
      Constraints constraints;
      constraints.cycle_max[quantity] = 2 * wanted;
      constraints.operation = machine();
      EXPECT_NEAR(least_row(linkage, constraints, CycleOutput::coupler_point), 0.5, 1e-6);
    }
  }
}

/// A load of one stroke has a kink where the rocker turns back: the adaptive quadrature of the
/// finished linkage and the rule of the search, whose cuts come from closed forms, agree.
TEST(CycleLimits, MeanSquareTorqueIsTheSameByBothQuadratures) {
  std::mt19937_64 random(6);
  for (const auto sense : {LoadSense::advance, LoadSense::retreat}) {
    for (const double speed : {1.7, -1.7}) {
      const FourBar linkage = random_linkage(random);
      Constraints constraints;
      constraints.operation = machine();
      constraints.operation.speed = speed;
      constraints.operation.loads.push_back(
          {{.link = MovingLink::rocker, .share = 1}, {}, 25, sense});
      const double rms = of_torque(CycleQuantity::rms_torque, linkage, constraints.operation);
      constraints.cycle_max[CycleQuantity::rms_torque] = 4 * rms;
      EXPECT_NEAR(least_row(linkage, constraints, CycleOutput::coupler_point), 0.75, 2e-9);
    }
  }
}

TEST(CycleLimits, ClearancesAreThoseOfManyPositions) {
  std::mt19937_64 random(6);
  const Box box{{-0.5, -0.8}, {1.2, 0.7}};
  for (int trial = 0; trial < 20; ++trial) {
    const FourBar linkage = random_linkage(random);
    for (const MovingPoint point : {MovingPoint::b, MovingPoint::c, MovingPoint::coupler_point}) {
      double inside = INFINITY, outside = INFINITY;
      for (double angle = 0; angle < kTurn; angle += kTurn / 20000) {
        const Pose pose = *Motion(linkage).at(angle);
        const Vec2d p = point == MovingPoint::b   ? pose.b
                        : point == MovingPoint::c ? pose.c
                                                  : *pose.coupler_point;
        const double within =
            std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y});
        inside = std::min(inside, within);
        outside = std::min(outside, -within);
      }
      for (const bool keep_in : {true, false}) {
        const Clearance clearance{point, keep_in, box};
        const double wanted = keep_in ? inside : outside;
        EXPECT_NEAR(clearance_distance(linkage, clearance), wanted, 1e-3);
        EXPECT_LE(clearance_distance(linkage, clearance), wanted + 1e-12);
        Constraints constraints;
        constraints.clearances = {clearance};
        EXPECT_NEAR(least_row(linkage, constraints, CycleOutput::coupler_point),
                    clearance_distance(linkage, clearance), 1e-8);
      }
    }
  }
}

}  // namespace
}  // namespace cognate::problems::cycle_limits_test
