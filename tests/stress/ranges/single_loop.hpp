/// @file The motion of mechanisms of one loop by brute force: intersections of circles and lines,
/// sampled densely over the drive and followed from sample to sample, with up to 113 bits. It
/// shares no code with the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cognate::stress {

enum class LoopType {
  four_bar,
  slider_crank,
  fixed_block,
  guide_bar,
  oscillating_block,
  scotch_yoke,
  tangent_generator,
  elliptic_trammel,
  oldham_coupling
};

/// Sums of lengths that are equal, as planted. Of a four-bar the first three make the longest and
/// the shortest as long as the other two; of a slider-crank `single` is coupler = crank + |offset|
/// or crank = coupler + |offset|, of a guide-bar |frame − crank| = |offset|.
enum class Tie { none, single, parallelogram, kite_b_on_d, kite_c_on_a, rhombus };

/// A mechanism and its drive. Angles in degrees.
struct SingleLoop {
  LoopType type = LoopType::four_bar;
  double crank = 1, coupler = 1, rocker = 1, offset = 0;
  double frame_x = 1, frame_y = 0;  ///< from A to D
  double direction = 0, slot = 90;  ///< of the slide, and of slot or second line from it
  int side = 1;                     ///< +1: open
  double start = 0, end = 360;
  Tie tie = Tie::none;  ///< which sums count as equal
  int equal_sum = 0;    ///< of a four-bar's `single`: 1: l₃+l₄=l₁+l₂, 2, 3

  bool slides() const;
};

/// What the motion is. Angles in degrees, drive angles as the file counts them.
struct LoopTruth {
  bool closes = false;  ///< anywhere in the drive
  int ranges = 0;       ///< that the drive crosses
  bool crank_turns = false;
  bool reaches_infinity = false;        ///< the first range ends where two lines are parallel
  double stroke = 0;                    ///< of the range of the start, on both its sides
  std::optional<double> circuit{};      ///< 360 where the output turns fully
  std::vector<double> dead_points{};    ///< in all ranges
  std::vector<double> change_points{};  ///< at which two assemblies meet
  double least_transmission = 180, greatest_transmission = 0;  ///< of all ranges
  bool keeps_direction = true;  ///< the coupler of a four-bar does not turn
};

/// With 64 bits, or 113 where `tie` or lengths next to one need them.
LoopTruth truth_of(const SingleLoop& loop, bool needs_113_bits);

/// The file that analyses it.
std::string file_of(const SingleLoop& loop);

}  // namespace cognate::stress
