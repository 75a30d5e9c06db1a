/// @file Which way a body of a chain is headed, and the derivatives of that direction. The number
/// type may be double, a SIMD pack, a dual number or one of extended precision.
#pragma once

#include "analysis/numbers/vec2.hpp"
#include "synthesis/chain/chain_place.hpp"

namespace cognate::synthesis {

/// The direction that line `k` of type `heading` gives, a unit vector of the frame.
template <class T>
Vec2<T> heading(const ChainView<T>& chain, const ChainPlace<T>& at, int k) {
  return at.axis[k] * at.axis[chain.lines[k].line.first];
}

/// How fast it turns where the points move with `velocity` and its own angle at the rate `own`.
template <class T>
T heading_rate(const ChainView<T>& chain, const ChainPlace<T>& at, int k, const Vec2<T>* velocity,
               const T& own) {
  const int point = chain.lines[k].line.first;
  const ChainLine& body = chain.lines[point].line;
  return own +
         at.inverse[point] * cross(at.axis[point], velocity[body.second] - velocity[body.first]);
}

/// Adds `weight` times the derivatives of its angle to `seed`, of points before the attached one,
/// and `gradient`.
template <class T>
void seed_heading(const ChainView<T>& chain, const ChainPlace<T>& at, int k, const T& weight,
                  Vec2<T>* seed, T* gradient) {
  const auto& [line, parameter] = chain.lines[k];
  const ChainLine& body = chain.lines[line.first].line;
  const Vec2<T> couple = (weight * at.inverse[line.first]) * perp(at.axis[line.first]);
  seed[body.second] = seed[body.second] + couple;
  seed[body.first] = seed[body.first] - couple;
  gradient[parameter] = gradient[parameter] + weight;
}

}  // namespace cognate::synthesis
