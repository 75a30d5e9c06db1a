/// @file A mechanism over another number type.
#pragma once

#include <utility>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// Carries every number of a mechanism over to T by `lift`, called once for each, in order; those
/// of groups stay as they are.
template <class T, class Lift>
class Converter {
 public:
  explicit Converter(Lift lift) : lift_(std::move(lift)) {}

  Mechanism<T> operator()(const Mechanism<double>& mechanism) {
    Mechanism<T> result;
    result.drive = (*this)(mechanism.drive);
    for (const Dyad<double>& dyad : mechanism.dyads) result.dyads.push_back((*this)(dyad));
    return result;
  }
  Drive<T> operator()(const Drive<double>& drive) {
    return std::visit([&](const auto& d) -> Drive<T> { return of(d); }, drive);
  }
  Dyad<T> operator()(const Dyad<double>& dyad) {
    return std::visit([&](const auto& d) -> Dyad<T> { return of(d); }, dyad);
  }

 private:
  T of(double x) { return lift_(x); }
  Vec2<T> of(const Vec2d& v) { return {of(v.x), of(v.y)}; }
  Attached<T> of(const Attached<double>& a) { return {a.body, of(a.at)}; }
  Guide<T> of(const Guide<double>& g) {
    return {g.body, of(g.through), of(g.direction), of(g.offset)};
  }
  Crank<T> of(const Crank<double>& d) { return {of(d.pivot), of(d.length)}; }
  DrivingSlider<T> of(const DrivingSlider<double>& d) { return {of(d.guide)}; }
  FloatingLink<T> of(const FloatingLink<double>& d) {
    return {of(d.first), of(d.second), of(d.length)};
  }
  DrivingRod<T> of(const DrivingRod<double>&) { return {}; }
  Rrr<T> of(const Rrr<double>& d) {
    return {of(d.first), of(d.second), of(d.first_length), of(d.second_length), d.assembly};
  }
  Rrp<T> of(const Rrp<double>& d) { return {of(d.point), of(d.length), of(d.guide), d.assembly}; }
  Rpr<T> of(const Rpr<double>& d) { return {of(d.block), of(d.pivot), of(d.offset), d.assembly}; }
  Prp<T> of(const Prp<double>& d) { return {of(d.first), of(d.second)}; }
  Rpp<T> of(const Rpp<double>& d) { return {of(d.point), of(d.slot), of(d.guide)}; }
  Cylinder<T> of(const Cylinder<double>& d) {
    return {of(d.base), of(d.pivot), of(d.length), d.assembly};
  }
  Group of(const Group& group) { return group; }
  GroupRest of(const GroupRest& rest) { return rest; }

  Lift lift_;
};

/// `mechanism` over T, each of its numbers x carried over as `lift(x)`: a variable of a design,
/// say, or a pack of the same number.
template <class T, class Lift>
Mechanism<T> convert(const Mechanism<double>& mechanism, Lift lift) {
  return Converter<T, Lift>(std::move(lift))(mechanism);
}

/// `mechanism` over T, its numbers as constants.
template <class T>
Mechanism<T> convert(const Mechanism<double>& mechanism) {
  return convert<T>(mechanism, [](double x) { return T(x); });
}

}  // namespace cognate
