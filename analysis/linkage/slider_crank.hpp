/// @file The slider-crank and its inversion with a fixed block, as data.
#pragma once

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A crank A–B, a coupler B–C, and a slider at C on a straight line of the frame. Lengths are
/// positive and in the unit of the pivot.
struct SliderCrank {
  Vec2d pivot;  ///< A
  double crank = 0;
  double coupler = 0;
  double offset = 0;                   ///< distance of the slide line from A, positive to its left
  Vec2d direction{1, 0};               ///< unit vector of the slide line
  Assembly assembly = Assembly::open;  ///< `open`: C is ahead of B along `direction`
};

/// The slider-crank stood on its slider: the block is the frame, and the rod that was its frame
/// slides through it. A link A–B (`crank`, the driven one) turns about a pivot of the block, and a
/// link B–C (`coupler`) moves the rod by its pin C. Where the crank is the longer of the two, as in
/// a hand pump, it swings while the coupler may turn fully.
struct FixedBlock {
  Vec2d pivot;  ///< A
  double crank = 0;
  double coupler = 0;
  double offset = 0;                   ///< distance of the path of C from A, positive to its left
  Vec2d direction{1, 0};               ///< unit vector along which the rod slides
  Assembly assembly = Assembly::open;  ///< `open`: C is ahead of B along `direction`
};

/// The slider-crank of the same dimensions, whose slider moves as the rod does.
SliderCrank as_slider_crank(const FixedBlock& mechanism);

/// A crank and an RRP dyad: body 1 is the crank, 2 the coupler, 3 the slider (the rod).
Mechanism<double> as_mechanism(const SliderCrank& mechanism);
Mechanism<double> as_mechanism(const FixedBlock& mechanism);

}  // namespace cognate
