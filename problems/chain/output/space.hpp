/// @file The designs of a chain whose output is an angle, or the displacement of a slider: what
/// moves or turns the whole mechanism changes nothing of it, nor of an angle what enlarges it.
#pragma once

#include <array>
#include <string>

#include "problems/chain/free_chain.hpp"

namespace cognate::problems {

/// What of the place of a mechanism counts all the same.
struct OutputFrame {
  bool keeps_size = false;
  bool keeps_direction = false;
  double size = 1;  ///< the unit where it is kept and the file gives no length
};

/// What the output is at a position: a direction, or the displacement of a slider.
struct WantedOutput {
  Vec2d direction{1, 0};
  double displacement = 0;
};

/// The designs of one topology by the angle of the way from the point of line `from` to that of
/// `to`; where `from` is a guide, by the displacement of its slider `to`. The unit is the crank
/// where its length is known. As far as the file and `OutputFrame` leave these open, the crank has
/// the length 1 (or the nearest that its bounds allow) and turns about the origin, and the first
/// other pivot is level with its own; where there are guides, the first is level instead.
struct OutputSpace : ChainSpace {
  TargetScale scale;
  int from, to;

  /// Whether the output is the displacement of a slider.
  bool slides() const;
  /// By how much a level of the output may change in a fit: half a turn, or so many units.
  double most_level() const;

  /// An output of so many radians or units.
  WantedOutput wanted(double output) const;
  /// The output where `chain` is.
  WantedOutput output(const FreeChain& chain) const;
  /// The same less `from`, in radians, within half a turn, or units.
  double error(const FreeChain& chain, const WantedOutput& from) const;
  /// The derivatives of the output, as FreeChain has them.
  double output_slope(FreeChain& chain, double* row) const;

  /// `output`: names of the two points, or of the guide and its slider. `transmission`: radians;
  /// the narrower side counts.
  OutputSpace(const Topology& topology, const std::array<std::string, 2>& output,
              const Range& transmission, const OutputFrame& frame);

 private:
  OutputSpace(const Topology& topology, const std::array<std::string, 2>& output,
              const Range& transmission, const Topology& framed, const OutputFrame& frame);
};

/// The angle of `way` relative to `reference`: within half a turn of it.
double relative_angle(const Vec2d& way, const Vec2d& reference);

}  // namespace cognate::problems
