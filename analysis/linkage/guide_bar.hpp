/// @file The guide-bar and the oscillating block, two inversions of the slider-crank, as data.
#pragma once

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A crank A–B with a block at B that slides on a bar turning about C. With u the bar's direction:
/// B − C = (s + i·offset)·u. The bar swings where the frame is longer than the crank, and turns
/// where it is shorter. Lengths are in the unit of the pivots; the crank is positive.
struct GuideBar {
  Vec2d pivot_a;  ///< of the crank
  Vec2d pivot_c;  ///< of the bar
  double crank = 0;
  double offset = 0;  ///< distance of the guide line from C, to the left of u positive
  Assembly assembly = Assembly::open;  ///< `open`: s > 0
};

/// A crank A–B with a rod turning about B that slides through a block turning about C. With u the
/// rod's direction: C − B = (s + i·offset)·u. The block moves as the bar of the guide-bar of the
/// same dimensions does, u being turned by half a turn.
struct OscillatingBlock {
  Vec2d pivot_a;  ///< of the crank
  Vec2d pivot_c;  ///< of the block
  double crank = 0;
  double offset = 0;  ///< distance of C from the rod's line through B, to the left of u positive
  Assembly assembly = Assembly::open;  ///< `open`: s > 0
};

/// The guide-bar of the same dimensions, whose bar turns as the block does.
GuideBar as_guide_bar(const OscillatingBlock& mechanism);

/// A crank and an RPR dyad: body 1 is the crank, 2 the block on its pin, 3 the bar.
Mechanism<double> as_mechanism(const GuideBar& mechanism);

/// A crank and an RPR dyad: body 1 is the crank, 2 the block, 3 the rod (its origin at the crank
/// pin, its first axis along u).
Mechanism<double> as_mechanism(const OscillatingBlock& mechanism);

}  // namespace cognate
