/// @file Bounds of a motion piece's derivatives, without a search.
#pragma once

#include "analysis/cam/motion_piece.hpp"

namespace cognate::cam {

struct Bounds {
  double least = 0;
  double greatest = 0;
};

/// Bounds of the derivative `order` (0: displacement) of `piece` by the cam angle: by the Bernstein
/// coefficients of its polynomial and the ranges of its sinusoids. Attained by a polynomial of
/// degree 1 with a sinusoid that is monotone; else they may be wider than the truth.
Bounds bounds_of(const MotionPiece<double>& piece, int order);

}  // namespace cognate::cam
