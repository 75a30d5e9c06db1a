/// @file Motion laws whose acceleration runs along a sine, a constant, a cosine and zero.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "analysis/cam/motion_law.hpp"
#include "analysis/cam/motion_piece.hpp"

namespace cognate::cam {

/// The piece Σ polynomial[k] xᵏ + Σ sinusoids[i] over [begin, begin + span] of a unit segment.
template <class T>
MotionPiece<T> unit_piece(const T& begin, const T& span, std::initializer_list<T> polynomial,
                          std::initializer_list<Sinusoid<T>> sinusoids = {}) {
  MotionPiece<T> piece;
  piece.begin = begin;
  piece.span = span;
  for (const T& coefficient : polynomial) {
    piece.polynomial[static_cast<std::size_t>(piece.terms++)] = coefficient;
  }
  for (const auto& wave : sinusoids) {
    piece.sinusoids[static_cast<std::size_t>(piece.sinusoid_count++)] = wave;
  }
  return piece;
}

/// A piece of the law 1 − f(1 − u), where `piece` is one of the law f(u): what makes the second
/// half of a symmetric law from its first.
template <class T>
MotionPiece<T> mirrored(MotionPiece<T> piece) {
  piece.begin = T(1) - (piece.begin + piece.span);
  for (std::size_t k = 0; k < static_cast<std::size_t>(piece.terms); k += 2) {
    piece.polynomial[k] = T(k == 0 ? 1 : 0) - piece.polynomial[k];
  }
  for (auto& wave : piece.sinusoids) wave.phase = -wave.rate - wave.phase;
  return piece;
}

/// A segment of a cam: where it begins and what it adds.
template <class T>
struct Place {
  T begin{};
  T over{};
  T start{};
  T rise{};
  int segment = 0;
};

template <class T>
MotionPiece<T> placed(MotionPiece<T> piece, const Place<T>& place) {
  piece.begin = place.begin + place.over * piece.begin;
  piece.span = place.over * piece.span;
  piece.offset = place.start;
  piece.scale = place.rise;
  piece.segment = place.segment;
  return piece;
}

/// A share of the segment whose value is below this has no piece of its own: what is left of 1
/// after shares like 0.1, 0.2 and 0.7 is rounding. Its derivatives still count in all other pieces.
constexpr double kLeastShare = 1e-12;

/// The first half of a universal law of unit rise over unit angle, without the constant velocity
/// about its middle: where its parts meet. Makino, Jidokikai kikogaku, 1976; Norton, Cam Design and
/// Manufacturing Handbook, chapter 3 (SCCA).
template <class T>
struct UniversalHalf {
  T rest{};                                    ///< share of constant velocity
  T acceleration{};                            ///< its greatest value
  T velocity_1{}, velocity_2{}, velocity_3{};  ///< after the sine, the constant, the cosine
  T displacement_1{}, displacement_2{};        ///< after the sine, the constant
};

template <class T>
UniversalHalf<T> universal_half(const UniversalShape<T>& shape) {
  const T half(0.5);
  const T sine = shape.sine / pi_of<T>(), cosine = shape.cosine / pi_of<T>();
  const T constant = half * shape.constant;
  UniversalHalf<T> at;
  at.rest = T(1) - shape.sine - shape.constant - shape.cosine;
  // For unit acceleration first, then so that half the rise is reached at half the angle.
  at.velocity_1 = sine;
  at.velocity_2 = at.velocity_1 + constant;
  at.velocity_3 = at.velocity_2 + cosine;
  at.displacement_1 = sine * (half * shape.sine - sine);
  at.displacement_2 = at.displacement_1 + constant * (at.velocity_1 + half * constant);
  const T at_middle = at.displacement_2 + half * at.velocity_2 * shape.cosine + cosine * cosine +
                      half * at.velocity_3 * at.rest;
  if (!(at_middle > T(0))) {  // no acceleration at all
    at.velocity_3 = T(1);
    return at;
  }
  at.acceleration = half / at_middle;
  for (T* sum :
       {&at.velocity_1, &at.velocity_2, &at.velocity_3, &at.displacement_1, &at.displacement_2}) {
    *sum = *sum * at.acceleration;
  }
  return at;
}

/// Along a quarter sine up, from rest. The slope is made of what the sinusoid takes away at t = 0,
/// by the operations of `motion_at`, so that the velocity begins with exactly 0.
template <class T>
MotionPiece<T> universal_sine(const UniversalShape<T>& shape, const UniversalHalf<T>& at) {
  const T per_turn = shape.sine / pi_of<T>();
  const T amplitude = -at.acceleration * per_turn * per_turn;
  const T half_slope = -(T(0.5) * (amplitude * (pi_of<T>() * T(0.5))));
  return unit_piece<T>(T(0), T(0.5) * shape.sine, {half_slope, half_slope},
                       {{amplitude, T(0.5), T(0)}});
}

template <class T>
MotionPiece<T> universal_constant(const UniversalShape<T>& shape, const UniversalHalf<T>& at) {
  const T span = T(0.5) * shape.constant;
  const T half_slope = T(0.5) * at.velocity_1 * span;
  const T bend = T(0.125) * at.acceleration * span * span;
  return unit_piece<T>(T(0.5) * shape.sine, span,
                       {at.displacement_1 + half_slope + bend, half_slope + T(2) * bend, bend});
}

/// Along a quarter cosine down, to the greatest velocity.
template <class T>
MotionPiece<T> universal_cosine(const UniversalShape<T>& shape, const UniversalHalf<T>& at) {
  const T span = T(0.5) * shape.cosine;
  const T half_slope = T(0.5) * at.velocity_2 * span;
  const T per_turn = shape.cosine / pi_of<T>();
  const T amplitude = at.acceleration * per_turn * per_turn;
  return unit_piece<T>(T(0.5) * (shape.sine + shape.constant), span,
                       {at.displacement_2 + half_slope + amplitude, half_slope},
                       {{-amplitude, T(0.5), T(0.5)}});
}

template <class T>
MotionPiece<T> universal_rest(const UniversalHalf<T>& at) {
  return unit_piece<T>(T(0.5) * (T(1) - at.rest), at.rest,
                       {T(0.5), T(0.5) * at.velocity_3 * at.rest});
}

template <class T>
void append_universal(const UniversalShape<T>& shape, const T& begin, const T& over, const T& start,
                      const T& rise, int index, std::vector<MotionPiece<T>>& pieces) {
  const UniversalHalf<T> at = universal_half(shape);
  const Place<T> place{begin, over, start, rise, index};
  const std::array<MotionPiece<T>, 3> half{universal_sine(shape, at), universal_constant(shape, at),
                                           universal_cosine(shape, at)};
  const auto append = [&](const MotionPiece<T>& piece) {
    if (piece.span > T(0.5 * kLeastShare)) pieces.push_back(placed(piece, place));
  };
  for (const auto& piece : half) append(piece);
  append(universal_rest(at));
  for (auto piece = half.rbegin(); piece != half.rend(); ++piece) append(mirrored(*piece));
}

}  // namespace cognate::cam
