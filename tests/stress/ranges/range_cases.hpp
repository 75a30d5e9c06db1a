/// @file Random mechanisms with their drives, near ties and at them.
#pragma once

#include <cstdint>
#include <random>

#include "tests/stress/ranges/single_loop.hpp"

namespace cognate::stress {

/// A mechanism, and whether its lengths are so near to a tie that 64 bits do not separate them.
struct LoopCase {
  SingleLoop loop;
  bool is_near_tie = false;
  double nearness = 1;  ///< of sums that the tie makes equal: their gap by the longest length
};

/// Draws mechanisms of one loop: half of the four-bars, slider-cranks and guide-bars within a
/// relative 1e-3 … 1e-15 of a change point, or exactly there; drives over a turn, over less and
/// more, in both senses, from anywhere and from the line of the frame.
class LoopCases {
 public:
  explicit LoopCases(std::uint64_t seed) : random_(seed) {}

  LoopCase next();

 private:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  bool chance(double share) { return between(0, 1) < share; }
  int one_of(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double dyadic() { return (16 + one_of(180)) / 64.0; }  ///< sums of these are exact

  double nearness();
  void set_drive(SingleLoop& loop);
  LoopCase four_bar();
  LoopCase slider_crank();
  LoopCase guide_bar();
  LoopCase double_slider();
  bool settle(LoopCase& drawn, long double gap, long double unit);

  std::mt19937_64 random_;
};

}  // namespace cognate::stress
