/// @file A chain with numbers for its parameters, and where its points are. The number type may be
/// double, a SIMD pack, a dual number or one of extended precision.
#pragma once

#include "analysis/numbers/vec2.hpp"
#include "synthesis/chain/chain.hpp"

namespace cognate::synthesis {

/// What of a chain is the same at all positions.
template <class T>
struct ChainView {
  const PlacedLine* lines;
  int count;  ///< of lines, at most kMostLines
  const T* parameters;
  const T* side;  ///< of each line, see ChainDesign
};

/// A chain at a position of its crank. Not a number from the first dyad on that does not close.
template <class T>
struct ChainPlace {
  Vec2<T> crank;             ///< the direction of the crank
  Vec2<T> at[kMostLines];    ///< the points
  Vec2<T> axis[kMostLines];  ///< of attached points: the first axis of their body; of guides: their
                             ///< direction; of headings: theirs in the axes of their body; of the
                             ///< links that hold a three-pin link: where the
                             ///< points are that hold it
  T inverse[kMostLines];     ///< of attached points: one over the distance of the two points; of
                             ///< first pins the determinant of the closure
};

/// What of a chain is taken from `out` where that is a place of it with the same dimensions:
/// directions of guides, and with them distances within bodies; and then three-pin links are
/// followed from where they stand, from a position of the crank nearby.
enum class Kept { nothing, guides, distances };

template <class T>
bool has_three_pin_link(const ChainView<T>& chain) {
  for (int k = 0; k < chain.count; ++k) {
    if (chain.lines[k].line.type == LineType::third_link) return true;
  }
  return false;
}

}  // namespace cognate::synthesis
