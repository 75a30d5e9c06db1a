/// @file A crank that moves a link with three pins: as a group, and driven by another link as
/// dyads.
#pragma once

#include <array>
#include <random>

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::test {

inline constexpr int kPlate = 5, kCrankOfDyads = 5, kPlateOfDyads = 2;

/// A mechanism as it is drawn: crank AB, a plate with pins P, its legs to B and the frame.
struct Drawn {
  Vec2d a, b;
  std::array<Vec2d, 3> pins;
  std::array<Vec2d, 2> pivots;  ///< of the second leg and the third

  double angle() const { return angle_of(b - a); }
};

inline Placement from_to(const Vec2d& from, const Vec2d& to) {
  return {from, (1 / norm(to - from)) * (to - from)};
}

inline Vec2d in_axes(const Placement& axes, const Vec2d& place) {
  return conj(axes.direction) * (place - axes.origin);
}

/// Legs are bodies 2 to 4, the plate is body 5 with the axes of the global ones moved to its first
/// pin.
inline Mechanism<double> with_group(const Drawn& drawn) {
  const auto& [a, b, pins, pivots] = drawn;
  Group group;
  group.drive = drawn.angle();
  group.drawn = {from_to(b, pins[0]),
                 from_to(pivots[0], pins[1]),
                 from_to(pivots[1], pins[2]),
                 {pins[0], {1, 0}}};
  const double crank = norm(b - a);
  group.joints = {{{1, {crank, 0}}, {2, {}}}, {{0, pivots[0]}, {3, {}}}, {{0, pivots[1]}, {4, {}}}};
  for (int leg = 0; leg < 3; ++leg) {
    const auto i = static_cast<std::size_t>(leg);
    group.joints.push_back(
        {{2 + leg, in_axes(group.drawn[i], pins[i])}, {kPlate, in_axes(group.drawn[3], pins[i])}});
  }
  return {Crank<double>{a, crank}, {group, GroupRest{}}};
}

/// The same with the third leg as a block that turns about its pivot and slides along a line of the
/// plate, in the direction `angle`.
inline Mechanism<double> with_slide(const Drawn& drawn, double angle) {
  Mechanism<double> mechanism = with_group(drawn);
  Group& group = std::get<Group>(mechanism.dyads[0]);
  GroupJoint& joint = group.joints.back();
  std::swap(joint.first, joint.second);
  joint.slides = true;
  joint.along_first = unit_vector(angle);
  joint.along_second = conj(group.drawn[2].direction) * joint.along_first;
  return mechanism;
}

/// The same with the first leg sliding along a line of the crank, so that it turns with it.
inline Mechanism<double> with_slide_on_crank(const Drawn& drawn, double angle) {
  Mechanism<double> mechanism = with_group(drawn);
  Group& group = std::get<Group>(mechanism.dyads[0]);
  const Vec2d along = unit_vector(angle);
  GroupJoint& joint = group.joints.front();
  joint.slides = true;
  joint.along_first = conj(unit_vector(drawn.angle())) * along;
  joint.along_second = conj(group.drawn[0].direction) * along;
  return mechanism;
}

/// The three in turn.
inline Mechanism<double> any_form(const Drawn& drawn, int number, double angle) {
  if (number % 3 == 0) return with_group(drawn);
  return number % 3 == 1 ? with_slide(drawn, angle) : with_slide_on_crank(drawn, angle);
}

inline Assembly side_of(const Vec2d& from, const Vec2d& to, const Vec2d& joint) {
  return cross(to - from, joint - from) > 0 ? Assembly::open : Assembly::crossed;
}

/// The same, driven by the second leg: the plate and the third leg are a dyad, the first leg and
/// the crank, body 5, another.
inline Mechanism<double> with_dyads(const Drawn& drawn) {
  const auto& [a, b, pins, pivots] = drawn;
  const double leg = norm(pins[1] - pivots[0]);
  const Placement plate = from_to(pins[1], pins[2]);
  return {Crank<double>{pivots[0], leg},
          {Rrr<double>{{1, {leg, 0}},
                       {0, pivots[1]},
                       norm(pins[2] - pins[1]),
                       norm(pins[2] - pivots[1]),
                       side_of(pins[1], pivots[1], pins[2])},
           Rrr<double>{{kPlateOfDyads, in_axes(plate, pins[0])},
                       {0, a},
                       norm(b - pins[0]),
                       norm(b - a),
                       side_of(pins[0], a, b)}}};
}

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec2d place(double size) { return {between(-size, size), between(-size, size)}; }

  Drawn drawn() {
    return {
        {}, unit_vector(between(-kPi, kPi)), {place(4), place(4), place(4)}, {place(5), place(5)}};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace cognate::test
