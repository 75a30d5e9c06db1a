/// @file The six lines of a three-pin link in a chain: their part of what sweep.hpp does.
#pragma once

#include <cmath>

#include "synthesis/chain/chain_place.hpp"
#include "synthesis/chain/held_link.hpp"

namespace cognate::synthesis {

/// The three-pin link whose first line is `base`.
template <class T>
HeldLink<T> held_link(const ChainView<T>& chain, int base) {
  const auto own = [&](int line) { return chain.parameters + chain.lines[base + line].parameter; };
  const T *second = own(kSecondPin), *third = own(kThirdPin);
  return {{own(kFirstPin)[0], second[0], own(0)[0]}, second[1], {third[0], third[1]}};
}

/// The points from which the links hold it.
template <class T>
void points_that_hold(const ChainView<T>& chain, const ChainPlace<T>& at, int base, Vec2<T>* out) {
  const int lines[3] = {base + kFirstPin, base + kSecondPin, base};
  for (int i = 0; i < 3; ++i) out[i] = at.at[chain.lines[lines[i]].line.first];
}

template <class T>
HeldClosure<T> held_closure(const ChainView<T>& chain, const ChainPlace<T>& at, int base) {
  Vec2<T> held_by[3];
  points_that_hold(chain, at, base, held_by);
  return {held_by, at.at + base + kFirstPin};
}

/// Which of the pins of a three-pin link a line places, from 0.
constexpr int pin_of(LineType type) {
  return static_cast<int>(type) - static_cast<int>(LineType::first_pin);
}

/// Places the first two pins of a three-pin link.
template <Kept Keeps, class T>
void place_pins(const ChainView<T>& chain, int base, ChainPlace<T>& out) {
  using std::sqrt;
  constexpr int kSteps = 2, kIterations = 4, kFirstIterations = 12;
  const HeldLink<T> link = held_link(chain, base);
  Vec2<T> held_by[3];
  points_that_hold(chain, out, base, held_by);
  Vec2<T>& before_first = out.axis[base + kFirstPin];
  Vec2<T>& before_second = out.axis[base + kSecondPin];
  Vec2<T>& before_third = out.axis[base];
  T& side = out.inverse[base + kFirstPin];
  HeldPlace<T> place;
  if constexpr (Keeps == Kept::distances) {
    place = {out.at[base + kFirstPin], out.axis[base + kThirdPin]};
    const Vec2<T> before[3] = {before_first, before_second, before_third};
    follow(link, before, held_by, kSteps, kIterations, place, side);
  } else {
    place.first = out.at[base + kDrawnLine];
    const Vec2<T> way = out.at[base + kDrawnLine + 1] - place.first;
    place.axis = (T(1) / sqrt(squared_norm(way))) * way;
    Vec2<T> pins[3];
    place.pins(link, pins);
    side = HeldClosure<T>(held_by, pins).determinant;
    follow(link, held_by, held_by, 1, kFirstIterations, place, side);
  }
  before_first = held_by[0];
  before_second = held_by[1];
  before_third = held_by[2];
  out.at[base + kFirstPin] = place.first;
  out.at[base + kSecondPin] = place.first + link.distance * place.axis;
}

/// How the first two pins of a three-pin link move, as `move` says.
template <class T>
void move_pins(const ChainView<T>& chain, const ChainPlace<T>& at, int base, const T* rates,
               Vec2<T>* velocity) {
  const auto rate = [&](int line, int parameter) {
    return rates ? rates[chain.lines[base + line].parameter + parameter] : T(0);
  };
  const HeldLink<T> link = held_link(chain, base);
  const HeldClosure<T> closure = held_closure(chain, at, base);
  const Vec2<T>& axis = at.axis[base + kThirdPin];
  const int lines[3] = {kFirstPin, kSecondPin, 0};
  const Vec2<T> zero{T(0), T(0)};
  const Vec2<T> own[3] = {zero, rate(kSecondPin, 1) * axis,
                          Vec2<T>{rate(kThirdPin, 0), rate(kThirdPin, 1)} * axis};
  T c[3];
  for (int k = 0; k < 3; ++k) {
    const Vec2<T> held = velocity[chain.lines[base + lines[k]].line.first];
    c[k] = link.length[k] * rate(lines[k], 0) + dot(closure.along[k], held - own[k]);
  }
  const Twist<T> motion = closure.solve(c);
  velocity[base + kFirstPin] = motion.shift;
  velocity[base + kSecondPin] = motion.shift + motion.turn * perp(closure.arm[1]) + own[1];
}

/// The part of `sweep_back` of the first two pins of a three-pin link.
template <class T>
void sweep_back_pins(const ChainView<T>& chain, const ChainPlace<T>& at, int base, Vec2<T>* seed,
                     T* gradient) {
  const auto slope = [&](int line, int parameter) -> T& {
    return gradient[chain.lines[base + line].parameter + parameter];
  };
  const HeldLink<T> link = held_link(chain, base);
  const HeldClosure<T> closure = held_closure(chain, at, base);
  const Vec2<T>& axis = at.axis[base + kThirdPin];
  const Vec2<T> first = seed[base + kFirstPin], second = seed[base + kSecondPin];
  T lambda[3];
  closure.solve_transposed({first + second, cross(closure.arm[1], second)}, lambda);
  const int lines[3] = {kFirstPin, kSecondPin, 0};
  for (int k = 0; k < 3; ++k) {
    Vec2<T>& held = seed[chain.lines[base + lines[k]].line.first];
    held = held + lambda[k] * closure.along[k];
    slope(lines[k], 0) = slope(lines[k], 0) + lambda[k] * link.length[k];
  }
  slope(kSecondPin, 1) =
      slope(kSecondPin, 1) + dot(axis, second) - lambda[1] * dot(axis, closure.along[1]);
  slope(kThirdPin, 0) = slope(kThirdPin, 0) - lambda[2] * dot(axis, closure.along[2]);
  slope(kThirdPin, 1) = slope(kThirdPin, 1) - lambda[2] * cross(axis, closure.along[2]);
}

/// The part of `seed_transmission` of a pin of the three-pin link whose first line is `base`.
template <class T>
void seed_pin(const ChainView<T>& chain, const ChainPlace<T>& at, int base, int pin,
              const T& cosine, const T& weight, Vec2<T>* seed, T* gradient) {
  Vec2<T> by_pins[3], by_holders[3];
  const T by_length = transmission_slopes(held_link(chain, base), held_closure(chain, at, base),
                                          pin, cosine, by_pins, by_holders);
  const int lines[3] = {base + kFirstPin, base + kSecondPin, base};
  for (int i = 0; i < 3; ++i) {
    Vec2<T>& own = seed[base + kFirstPin + i];
    own = own + weight * by_pins[i];
    Vec2<T>& held = seed[chain.lines[lines[i]].line.first];
    held = held + weight * by_holders[i];
  }
  T& slope = gradient[chain.lines[lines[pin]].parameter];
  slope = slope + weight * by_length;
}

}  // namespace cognate::synthesis
