// A link with three pins, moved by a crank: against the same mechanism driven by one of the link's
// legs, which then has dyads alone; against all assemblies of the link, found by a polynomial; and
// against virtual work and the balance of every body.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/mechanism/circuit_range.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/three_pin_link.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "tests/support/quad_four_bar.hpp"
#include "tests/support/three_pin_links.hpp"

namespace cognate::group_test {
namespace {

using namespace test;

/// Crank angle and a point of the plate, by the mechanism of dyads.
class ByDyads {
 public:
  explicit ByDyads(const Drawn& drawn)
      : motion_(with_dyads(drawn)),
        plate_(from_to(drawn.pins[1], drawn.pins[2])),
        start_(angle_of(drawn.pins[1] - drawn.pivots[0])) {}

  double start() const { return start_; }
  bool move_to(double leg) { return motion_.move_to(leg); }
  const BodyMotion<double, 1>& crank() const { return motion_.bodies()[kCrankOfDyads]; }
  double rate() const { return crank().turn[0]; }
  Vec2d place(const Vec2d& drawn) const {
    return motion_.point({kPlateOfDyads, in_axes(plate_, drawn)})[0];
  }

 private:
  MechanismMotion<1> motion_;
  Placement plate_;
  double start_;
};

TEST(Group, MovesAsTheSameMechanismDrivenByAnotherLink) {
  constexpr int kSteps = 400;
  Chance chance(1);
  int compared = 0, dead = 0;
  for (int i = 0; i < 60; ++i) {
    const Drawn drawn = chance.drawn();
    const Mechanism<double> mechanism = with_group(drawn);
    const double begin = drawn.angle();
    ByDyads dyads(drawn);
    ASSERT_TRUE(dyads.move_to(dyads.start()));
    const double sense = dyads.rate();
    const AssemblyRanges ranges = follow(mechanism, begin, begin + std::copysign(2 * kTurn, sense));
    ASSERT_FALSE(ranges.runs.empty());
    FollowedMotion<0> motion(mechanism, ranges);
    double crank = begin, last_rate = sense;
    for (int k = 0; k < kSteps; ++k) {
      const double leg = dyads.start() + 2.0 * k / kSteps;
      if (!dyads.move_to(leg)) break;
      const double angle = angle_of(dyads.crank().direction);
      crank += std::remainder(angle - crank, kTurn);
      if (dyads.rate() * sense <= 0) {
        const auto rate = [&](double at) { return dyads.move_to(at) ? dyads.rate() : NAN; };
        const double step = 2.0 / kSteps;
        rate(better_end(rate, bracket_zero(rate, leg - step, last_rate, leg, dyads.rate())));
        crank += std::remainder(angle_of(dyads.crank().direction) - crank, kTurn);
        const AssemblyRange* run = ranges.range_at(begin);
        EXPECT_NEAR(sense > 0 ? run->to : run->from, crank, 1e-12) << i;
        ++dead;
        break;
      }
      last_rate = dyads.rate();
      ASSERT_TRUE(motion.move_to(crank)) << i << ' ' << k;
      const Vec2d point = drawn.pins[0] + Vec2d{0.3, -0.7};
      const Vec2d place = motion.point({kPlate, point - drawn.pins[0]})[0];
      const double loss = 1e-13 * (1 + std::abs(sense / dyads.rate())) * (1 + 1 / std::abs(sense));
      ASSERT_LE(norm(place - dyads.place(point)), 1e-9 + 100 * loss) << i << ' ' << k;
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000);
  EXPECT_GT(dead, 15);
}

/// The plate of a drawn mechanism by three circles in 113 bits, the crank at `angle`: its first pin
/// and its direction, by Newton's method from `near`.
struct QuadPlate {
  Quad x, y, angle;
};

QuadPlate quad_plate(const Drawn& drawn, double crank, const BodyMotion<double, 1>& near) {
  const Quad r = sqrt(Quad(drawn.b.x) * drawn.b.x + Quad(drawn.b.y) * drawn.b.y);
  const std::array<std::array<Quad, 2>, 3> centres{{{r * cos(Quad(crank)), r * sin(Quad(crank))},
                                                    {drawn.pivots[0].x, drawn.pivots[0].y},
                                                    {drawn.pivots[1].x, drawn.pivots[1].y}}};
  const std::array<Vec2d, 3> drawn_centres{drawn.b, drawn.pivots[0], drawn.pivots[1]};
  QuadPlate at{near.origin[0].x, near.origin[0].y,
               atan2(Quad(near.direction.y), Quad(near.direction.x))};
  for (int step = 0; step < 8; ++step) {
    Eigen::Matrix<Quad, 3, 3> matrix;
    Eigen::Matrix<Quad, 3, 1> gap;
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Quad u = Quad(drawn.pins[i].x) - drawn.pins[0].x;
      const Quad v = Quad(drawn.pins[i].y) - drawn.pins[0].y;
      const Quad ax = u * cos(at.angle) - v * sin(at.angle);
      const Quad ay = u * sin(at.angle) + v * cos(at.angle);
      const Quad dx = at.x + ax - centres[i][0], dy = at.y + ay - centres[i][1];
      const Quad lx = Quad(drawn.pins[i].x) - drawn_centres[i].x;
      const Quad ly = Quad(drawn.pins[i].y) - drawn_centres[i].y;
      gap(k) = dx * dx + dy * dy - lx * lx - ly * ly;
      matrix.row(k) << 2 * dx, 2 * dy, 2 * (dy * ax - dx * ay);
    }
    const Eigen::Matrix<Quad, 3, 1> change = matrix.fullPivLu().solve(gap);
    at = {at.x - change(0), at.y - change(1), at.angle - change(2)};
  }
  return at;
}

TEST(Group, StandsWhereThreeCirclesDoIn113Bits) {
  Chance chance(7);
  int compared = 0;
  for (int i = 0; i < 30; ++i) {
    const Drawn drawn = chance.drawn();
    FollowedMotion<1> motion(with_group(drawn),
                             follow(with_group(drawn), drawn.angle(), drawn.angle() + 1));
    for (int k = 0; k < 10 && motion.move_to(drawn.angle() + 0.1 * k); ++k) {
      const auto& plate = motion.bodies()[kPlate];
      const QuadPlate exact = quad_plate(drawn, drawn.angle() + 0.1 * k, plate);
      const double x = static_cast<double>(exact.x - plate.origin[0].x);
      const double y = static_cast<double>(exact.y - plate.origin[0].y);
      // Lengths of 1 to 10, and the group's distance from its dead points.
      EXPECT_LE(std::hypot(x, y), 1e-15 / std::abs(motion.closures()[0].sine)) << i << ' ' << k;
      ++compared;
    }
  }
  EXPECT_GT(compared, 150);
}

TEST(Group, IsFollowedFromFarAlongAShortWayOfASlider) {
  Chance chance(8);
  int reached = 0;
  for (int i = 0; i < 10; ++i) {
    Mechanism<double> mechanism = with_group(chance.drawn());
    Group& group = std::get<Group>(mechanism.dyads[0]);
    // The crank's pin goes along a line as it does along its circle.
    const Vec2d pin = group.drawn[0].origin;
    mechanism.drive = DrivingSlider<double>{{0, pin, {1, 0}, 0}};
    group.joints[0].first.at = {};
    group.drive = 0;
    const AssemblyRanges near = follow(mechanism, 0, 0.02);
    const AssemblyRanges far = follow(mechanism, 0.01, 0.01 + 1e-9);
    FollowedMotion<0> first(mechanism, near), second(mechanism, far);
    const bool is_reached = first.move_to(0.01);
    EXPECT_EQ(second.move_to(0.01), is_reached) << i;
    if (!is_reached) continue;
    EXPECT_LT(norm(first.bodies()[kPlate].origin[0] - second.bodies()[kPlate].origin[0]), 1e-10);
    ++reached;
  }
  EXPECT_GT(reached, 5);
}

TEST(Group, HasTheDerivativesOfItsMotion) {
  Chance chance(2);
  const Attached<double> point{kPlate, {0.4, 1.1}};
  double worst = 0;
  for (int i = 0; i < 80; ++i) {
    const Drawn drawn = chance.drawn();
    const Mechanism<double> mechanism = any_form(drawn, i, chance.between(-kPi, kPi));
    FollowedMotion<3> motion(mechanism, follow(mechanism, drawn.angle() - 1, drawn.angle() + 1));
    const AssemblyRange& run = *motion.assembly_ranges().range_at(drawn.angle());
    const double middle = std::midpoint(run.from, run.to);
    const double step = 1e-4 * (run.to - run.from);
    const auto at = [&](double drive) {
      EXPECT_TRUE(motion.move_to(drive));
      return motion.point(point);
    };
    const auto here = at(middle);
    const auto one = at(middle + step), two = at(middle + 2 * step);
    const auto less = at(middle - step), least = at(middle - 2 * step);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2d slope = (1 / (12 * step)) * (8.0 * (one[k] - less[k]) - (two[k] - least[k]));
      const double size = norm(here[k + 1]) + norm(two[k] - least[k]) / step;
      worst = std::max(worst, norm(slope - here[k + 1]) / size);
    }
  }
  EXPECT_LT(worst, 1e-7);
}

/// Forces and moments about the global origin that joints exert on each body.
std::vector<std::array<double, 3>> exerted(const Mechanism<double>& mechanism,
                                           std::span<const BodyMotion<double, 2>> bodies,
                                           const Forces& forces) {
  std::vector<std::array<double, 3>> all(bodies.size());
  const auto list = joints(mechanism).joints;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& body = bodies[static_cast<std::size_t>(list[i].at.body)];
    const Vec2d at = point_motion(body, list[i].at.at)[0];
    const auto& [force, moment] = forces.reactions[i];
    const std::array<double, 3> on_second{force.x, force.y, moment + cross(at, force)};
    for (std::size_t k = 0; k < 3; ++k) {
      all[static_cast<std::size_t>(list[i].second)][k] += on_second[k];
      all[static_cast<std::size_t>(list[i].first)][k] -= on_second[k];
    }
  }
  return all;
}

TEST(Group, IsInBalanceAndDoesNoWorkOfItsOwn) {
  Chance chance(3);
  for (int i = 0; i < 80; ++i) {
    const Drawn drawn = chance.drawn();
    const Mechanism<double> mechanism = any_form(drawn, i, chance.between(-kPi, kPi));
    MechanismMotion<2> motion(mechanism);
    ASSERT_TRUE(motion.move_to(drawn.angle()));
    std::vector<Inertia> inertias(6);
    for (std::size_t body = 1; body < 6; ++body) {
      inertias[body] = {chance.between(0.1, 2), chance.place(1), chance.between(0.1, 2)};
    }
    const DriveRate rate{chance.between(-3, 3), chance.between(-3, 3)};
    const Load load{{kPlate, chance.place(1)}, chance.place(5), chance.between(-2, 2)};
    const Vec2d gravity{0, -9.81};
    InverseDynamics dynamics(mechanism, inertias, gravity);
    Forces forces = dynamics.forces();
    const std::span<const Load> loads(&load, 1);
    ASSERT_TRUE(dynamics.solve<2>(motion.bodies(), rate, loads, forces));
    double size = std::abs(forces.drive);
    for (const Reaction& reaction : forces.reactions) size = std::max(size, norm(reaction.force));
    EXPECT_NEAR(forces.drive, dynamics.drive<2>(motion.bodies(), rate, loads), 1e-11 * size);

    const auto all = exerted(mechanism, motion.bodies(), forces);
    for (int body = 1; body < 6; ++body) {
      const auto number = static_cast<std::size_t>(body);
      const auto centre = motion.point({body, inertias[number].centre});
      const Vec2d acceleration =
          rate.speed * rate.speed * centre[2] + rate.acceleration * centre[1];
      const auto& turn = motion.bodies()[number].turn;
      const double angular = rate.speed * rate.speed * turn[1] + rate.acceleration * turn[0];
      Vec2d needed = inertias[number].mass * (acceleration - gravity);
      double moment = inertias[number].moment * angular + cross(centre[0], needed);
      if (body == kPlate) {
        needed = needed - load.force;
        moment -= load.torque + cross(motion.point(load.at)[0], load.force);
      }
      if (body == 1) moment -= forces.drive;
      EXPECT_NEAR(all[number][0], needed.x, 1e-10 * size) << body;
      EXPECT_NEAR(all[number][1], needed.y, 1e-10 * size) << body;
      EXPECT_NEAR(all[number][2], moment, 1e-9 * size) << body;
    }
  }
}

/// Compares the circuits of both forms, where either is found; whether both are.
bool has_same_circuit(const Drawn& drawn, const AssemblyRange& run) {
  const auto circuit = circuit_range(with_group(drawn), run, {.body = kPlate}, {});
  const Mechanism<double> dyads = with_dyads(drawn);
  const double leg = angle_of(drawn.pins[1] - drawn.pivots[0]);
  const AssemblyRanges by_leg = follow(dyads, leg - kPi, leg + kPi);
  const auto same = circuit_range(dyads, *by_leg.range_at(leg), {.body = kPlateOfDyads}, {});
  if (!circuit || !same) return false;
  EXPECT_EQ(circuit->turns_fully, same->turns_fully);
  EXPECT_NEAR(circuit->stroke, same->stroke, 1e-7);
  return true;
}

TEST(Group, GoesRoundItsCircuitBeyondItsDeadPoints) {
  Chance chance(4);
  int closed = 0;
  for (int i = 0; i < 40; ++i) {
    const Drawn drawn = chance.drawn();
    const AssemblyRanges ranges =
        follow(with_group(drawn), drawn.angle() - kPi, drawn.angle() + kPi);
    closed += has_same_circuit(drawn, *ranges.range_at(drawn.angle()));
  }
  EXPECT_GT(closed, 30);
}

TEST(Group, MayStandInAnotherAssemblyWhenItsCrankComesRound) {
  Chance chance(9);
  int found = 0, closed = 0;
  for (int i = 0; i < 600; ++i) {
    Drawn drawn = chance.drawn();
    drawn.b = chance.between(0.2, 0.8) * drawn.b;
    const Mechanism<double> mechanism = with_group(drawn);
    const AssemblyRanges turn = follow(mechanism, drawn.angle(), drawn.angle() + kTurn);
    const AssemblyRange& run = *turn.range_at(drawn.angle());
    if (turn.runs.size() > 1 || !turn.points.empty()) continue;
    if (groups_stand_alike(mechanism, run, run.from, run, run.to)) continue;
    ++found;
    closed += has_same_circuit(drawn, run);
  }
  EXPECT_GT(found, 1);
  EXPECT_EQ(closed, found);
}

/// How far the third leg is from its length with the link at an angle and the first two closed in
/// one of two ways; not a number where they are not.
double gap(const ThreePinLink& link, double angle, double side) {
  const Vec2d u = unit_vector(angle);
  const Vec2d centre = link.pivots[1] - u * (link.pins[1] - link.pins[0]);
  const Vec2d between = centre - link.pivots[0];
  const double d = norm(between), l = link.legs[0], m = link.legs[1];
  const double along = (d * d + l * l - m * m) / (2 * d);
  const double across = side * std::sqrt(l * l - along * along);
  const Vec2d pin = link.pivots[0] + (1 / d) * (Vec2d{along, across} * between);
  return norm(pin + u * (link.pins[2] - link.pins[0]) - link.pivots[2]) - link.legs[2];
}

/// Changes of sign over a turn.
int scanned(const ThreePinLink& link) {
  constexpr int kPlaces = 20000;
  int changes = 0;
  for (const double side : {-1., 1.}) {
    double last = gap(link, 0, side);
    for (int i = 1; i <= kPlaces; ++i) {
      const double here = gap(link, kTurn * i / kPlaces, side);
      changes += here * last < 0;
      last = here;
    }
  }
  return changes;
}

TEST(ThreePinLink, HasAllAssembliesThatAScanFinds) {
  Chance chance(5);
  std::array<int, 7> count{};
  for (int i = 0; i < 300; ++i) {
    ThreePinLink link{.pins = {chance.place(3), chance.place(3), chance.place(3)},
                      .pivots = {chance.place(4), chance.place(4), chance.place(4)}};
    const Placement planted{chance.place(3), unit_vector(chance.between(-kPi, kPi))};
    for (std::size_t k = 0; k < 3; ++k) {
      link.legs[k] = norm(planted.origin + planted.direction * link.pins[k] - link.pivots[k]);
    }
    const auto all = assemblies(link);
    double nearest = 1;
    for (const auto& [origin, direction] : all) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double leg = norm(origin + direction * link.pins[k] - link.pivots[k]);
        EXPECT_NEAR(leg, link.legs[k], 1e-9) << i;
      }
      nearest = std::min(nearest, norm(origin - planted.origin));
    }
    EXPECT_LT(nearest, 1e-9) << i;
    EXPECT_GE(static_cast<int>(all.size()), scanned(link)) << i;
    EXPECT_EQ(all.size() % 2, 0U) << i;
    ++count[all.size()];
  }
  EXPECT_GT(count[2], 0);
  EXPECT_GT(count[4], 0);
  EXPECT_GT(count[6], 0);
}

TEST(ThreePinLink, StandsWhereTheMotionOfItsGroupLeads) {
  Chance chance(6);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Drawn drawn = chance.drawn();
    const Mechanism<double> mechanism = with_group(drawn);
    FollowedMotion<0> motion(mechanism, follow(mechanism, drawn.angle(), drawn.angle() + 2));
    for (int k = 0; k < 20; ++k) {
      if (!motion.move_to(drawn.angle() + 0.1 * k)) break;
      std::vector<Placement> bodies;
      for (const auto& body : motion.bodies()) bodies.push_back({body.origin[0], body.direction});
      const auto link = as_three_pin_link(std::get<Group>(mechanism.dyads[0]), 2, bodies);
      ASSERT_TRUE(link);
      EXPECT_EQ(link->body, kPlate);
      double nearest = 1;
      for (const auto& at : assemblies(*link)) {
        nearest = std::min(nearest, norm(at.origin - bodies[kPlate].origin));
      }
      EXPECT_LT(nearest, 1e-8) << i << ' ' << k;
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace cognate::group_test
