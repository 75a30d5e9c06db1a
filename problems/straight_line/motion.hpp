/// @file The coupler point of a linkage in the axes of its frame, in any number type with + − · ÷
/// and sqrt: what a straight-line search varies, and dual numbers of it.
///
/// Axes: the crank's pivot A is the origin; x points along A→D of a four-bar, along the slide line
/// of a slider-crank.
#pragma once

#include <array>
#include <cmath>

#include "analysis/linkage/closure.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

/// Dimensions in the order crank, coupler, rocker, frame of a four-bar; crank, coupler, offset of a
/// slider-crank, the fourth without meaning. `point` is (u, v): origin B, first axis from B to C.
template <class T>
struct CouplerDimensions {
  std::array<T, 4> links{};
  Vec2<T> point{};
};

/// The coupler point at one position.
template <class T>
struct CouplerPoint {
  Vec2<T> at;
  Vec2<T> rate;  ///< by the crank angle
  /// cos μ: of ∠BCD; of a slider-crank the sine of the coupler's angle with the slide line.
  T transmission_cosine{};
  Vec2<T> pin;          ///< B
  Vec2<T> joint;        ///< C
  bool closes = false;  ///< false too at a dead point, where there is no rate
};

/// A linkage prepared for many positions. `assembly`: +1 (open) or −1 (crossed).
template <class T>
class CouplerMotion {
 public:
  CouplerMotion(MechanismType type, const CouplerDimensions<T>& dimensions, double assembly)
      : slides_(type == MechanismType::slider_crank), dimensions_(dimensions), assembly_(assembly) {
    const auto& [crank, coupler, rocker, frame] = dimensions.links;
    if (!slides_) closure_ = Closure<T>(Lengths<T>{crank, coupler, rocker, frame});
  }

  CouplerPoint<T> at(const T& crank_angle) const {
    const CrankDirection<T> direction = crank_direction(crank_angle);
    const Vec2<T> turn{direction.cos, direction.sin};
    const T& crank = dimensions_.links[0];
    const T& coupler = dimensions_.links[1];
    Vec2<T> along, guide;  // unit vectors: of the coupler, and across the way of C
    const bool closes = slides_ ? slide(turn, along, guide) : rock(direction, along, guide);
    if (!closes) return {};
    CouplerPoint<T> point;
    point.pin = crank * turn;
    point.joint = point.pin + coupler * along;
    const Vec2<T> arm = along * dimensions_.point, pin_rate = crank * perp(turn);
    const T spin = -dot(guide, pin_rate) / (coupler * dot(guide, perp(along)));
    point.at = point.pin + arm;
    point.rate = pin_rate + spin * perp(arm);
    point.transmission_cosine = dot(along, guide);
    point.closes = true;
    return point;
  }

 private:
  bool rock(const CrankDirection<T>& direction, Vec2<T>& along, Vec2<T>& guide) const {
    const LinkDirections<T> links = closure_.at(direction, T(assembly_));
    along = links.coupler;
    guide = links.rocker;
    return links.discriminant > T(0);
  }

  bool slide(const Vec2<T>& turn, Vec2<T>& along, Vec2<T>& guide) const {
    using std::sqrt;
    const auto& [crank, coupler, offset, none] = dimensions_.links;
    const T sine = (offset - crank * turn.y) / coupler;
    const T square = T(1) - sine * sine;
    if (!(square > T(0))) return false;
    along = {T(assembly_) * sqrt(square), sine};
    guide = {T(0), T(1)};
    return true;
  }

  bool slides_;
  CouplerDimensions<T> dimensions_;
  double assembly_;
  Closure<T> closure_;
};

}  // namespace cognate::problems
