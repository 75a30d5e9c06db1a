/// @file What limits over the full turn are about, at one crank angle, as templates on the number
/// type: places, accelerations, inertia and the driving torque of a four-bar whose crank has
/// constant speed.
///
/// The links' angular velocities and accelerations by the crank's angle follow from the closure
/// l₁e₁ + l₂e₂ = l₄ + l₃e₃ differentiated once and twice and projected on e₃ and e₂; the torque
/// from the balance of power, in which the joints' forces do not occur.
#pragma once

#include <cmath>
#include <span>

#include "analysis/linkage/closure.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// A four-bar set in the plane. `turn` is the unit vector from A to D.
template <class T>
struct LinkagePose {
  Lengths<T> links;
  Vec2<T> coupler_point;
  Vec2<T> pivot_a;
  Vec2<T> turn;
};

/// A link's direction (a unit vector in the frame's axes), and the first and second derivative of
/// its angle by the crank's. The angle itself, continuous over the turn, only where it is requested
/// .
template <class T>
struct LinkTurning {
  Vec2<T> direction;
  T rate{};
  T bend{};
  T angle{};
};

template <class T>
struct CycleState {
  LinkTurning<T> crank, coupler, rocker;
};

/// The state at a crank direction. Not numbers where the linkage does not close.
template <class T>
CycleState<T> turn_state(const Lengths<T>& l, const Closure<T>& closure,
                         const CrankDirection<T>& crank, double assembly) {
  const LinkDirections<T> at = closure.at(crank, T(assembly));
  const Vec2<T> e1{crank.cos, crank.sin};
  const Vec2<T>&e2 = at.coupler, &e3 = at.rocker;
  const T sine = cross(e2, e3), along = dot(e2, e3);
  const T by_coupler = T(1) / (l.coupler * sine), by_rocker = T(1) / (l.rocker * sine);
  const T rate2 = -l.crank * dot(perp(e1), e3) * by_coupler;
  const T rate3 = -l.crank * dot(perp(e1), e2) * by_rocker;
  const T square2 = l.coupler * rate2 * rate2, square3 = l.rocker * rate3 * rate3;
  const T bend2 = (l.crank * dot(e1, e3) + square2 * along - square3) * by_coupler;
  const T bend3 = (l.crank * dot(e1, e2) + square2 - square3 * along) * by_rocker;
  return {{e1, T(1), T(0)}, {e2, rate2, bend2}, {e3, rate3, bend3}};
}

/// A moving point with its derivatives by the crank's angle, from A in the frame's axes.
template <class T>
struct PointTurning {
  Vec2<T> place, rate, bend;
};

/// Of the point that stands `in_link` from the point `from` of a turning link, in the frame's axes.
template <class T>
PointTurning<T> carried(const PointTurning<T>& from, const LinkTurning<T>& link,
                        const Vec2<T>& in_link) {
  const Vec2<T> arm = link.direction * in_link, across = perp(arm);
  return {from.place + arm, from.rate + link.rate * across,
          from.bend + link.bend * across - (link.rate * link.rate) * arm};
}

template <class T>
PointTurning<T> turning_of(const LinkagePose<T>& of, const CycleState<T>& at,
                           const LinkPlace& place) {
  const auto in_link = [&](const T& length) {
    return Vec2<T>{T(place.share) * length + T(place.offset.x), T(place.offset.y)};
  };
  const Vec2<T> along_crank{of.links.crank, T(0)};
  switch (place.link) {
    case MovingLink::crank:
      return carried(PointTurning<T>{}, at.crank, in_link(of.links.crank));
    case MovingLink::coupler:
      return carried(carried(PointTurning<T>{}, at.crank, along_crank), at.coupler,
                     place.at_coupler_point ? of.coupler_point : in_link(of.links.coupler));
    case MovingLink::rocker:
      break;
  }
  return carried(PointTurning<T>{{of.links.frame, T(0)}, {}, {}}, at.rocker,
                 in_link(of.links.rocker));
}

inline LinkPlace place_of(MovingPoint point) {
  switch (point) {
    case MovingPoint::b:
      return {.link = MovingLink::crank, .share = 1};
    case MovingPoint::c:
      return {.link = MovingLink::rocker, .share = 1};
    case MovingPoint::coupler_point:
      break;
  }
  return {.link = MovingLink::coupler, .at_coupler_point = true};
}

template <class T>
Vec2<T> in_frame(const LinkagePose<T>& of, const Vec2d& v) {
  return conj(of.turn) * Vec2<T>{T(v.x), T(v.y)};
}

template <class T>
const LinkTurning<T>& turning_link(const CycleState<T>& at, MovingLink link) {
  const LinkTurning<T>* const all[] = {&at.crank, &at.coupler, &at.rocker};
  return *all[static_cast<std::size_t>(link)];
}

/// A link with what it weighs in this linkage.
template <class T>
struct MovingMass {
  T mass, moment;
  PointTurning<T> centre;
  LinkTurning<T> link;
};

/// Calls `use` with every link that weighs something.
template <class T, class Use>
void each_mass(const LinkagePose<T>& of, const CycleState<T>& at, const Operation& operation,
               const Use& use) {
  const T* const lengths[] = {&of.links.crank, &of.links.coupler, &of.links.rocker};
  for (std::size_t i = 0; i < operation.links.size(); ++i) {
    const LinkMass& link = operation.links[i];
    if (link.mass == 0 && link.moment == 0 && link.mass_per_length == 0) continue;
    const T& length = *lengths[i];
    const T rod = T(link.mass_per_length) * length;
    use(MovingMass<T>{T(link.mass) + rod, T(link.moment) + rod * length * length * T(1. / 12),
                      turning_of(of, at, link.centre),
                      turning_link(at, static_cast<MovingLink>(i))});
  }
}

/// Σ m v′² + J φ′² of the links, and the flywheel: with the crank's speed ω the kinetic energy is
/// half of this times ω².
template <class T>
T equivalent_inertia(const LinkagePose<T>& of, const CycleState<T>& at,
                     const Operation& operation) {
  T inertia(operation.flywheel);
  each_mass(of, at, operation, [&](const MovingMass<T>& body) {
    inertia = inertia + body.mass * squared_norm(body.centre.rate) +
              body.moment * body.link.rate * body.link.rate;
  });
  return inertia;
}

/// Whether a load acts, given how its link turns.
template <class T>
bool acts(const WorkingLoad& load, const CycleState<T>& at, double speed) {
  if (load.sense == LoadSense::always) return true;
  const bool advances = turning_link(at, load.at.link).rate * T(speed) > T(0);
  return advances == (load.sense == LoadSense::advance);
}

/// The driving torque at the speed of `operation`, counter-clockwise: with v′, v″ and φ′, φ″ the
/// derivatives of the centres of mass and of the links' angles by the crank's,
/// Σ (m (ω² v″ − g)·v′ + J ω² φ″ φ′) − Σ (F·v′ + M φ′).
template <class T>
T driving_torque(const LinkagePose<T>& of, const CycleState<T>& at, const Operation& operation) {
  const T square(operation.speed * operation.speed);
  const Vec2<T> gravity = in_frame(of, operation.gravity);
  T torque(0);
  each_mass(of, at, operation, [&](const MovingMass<T>& body) {
    torque = torque + body.mass * dot(square * body.centre.bend - gravity, body.centre.rate) +
             body.moment * square * body.link.bend * body.link.rate;
  });
  for (const WorkingLoad& load : operation.loads) {
    if (!acts(load, at, operation.speed)) continue;
    torque = torque - dot(in_frame(of, load.force), turning_of(of, at, load.at).rate) -
             T(load.torque) * turning_link(at, load.at.link).rate;
  }
  return torque;
}

}  // namespace cognate::problems
