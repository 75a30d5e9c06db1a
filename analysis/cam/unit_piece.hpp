/// @file Pieces of laws of unit rise over unit angle, and how they become those of a segment.
#pragma once

#include <cstddef>
#include <initializer_list>

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

}  // namespace cognate::cam
