/// @file Limit positions of an output: how far it goes, where it turns back, and how fast each way.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/travel.hpp"

namespace cognate {

/// A quantity of the motion at a position of the drive: radians (counted on beyond a turn) or
/// length.
struct OutputValue {
  double drive = 0;
  double value = 0;
};

/// An output over the assembly ranges of a motion. `limits` are where its derivative by the drive
/// vanishes with a change of sign, in the order of the motion, refined to rounding; a position that
/// a whole turn of the drive reaches twice, at its start and end, counts once. `least` and
/// `greatest` take the ends of the ranges in. Where more than the rounding of the numbers is lost,
/// next to positions that are all but undetermined, all of this is known to what is left there.
struct OutputRange {
  std::vector<OutputValue> limits;
  OutputValue least;
  OutputValue greatest;
  OutputValue first;            ///< at the least value of the drive
  OutputValue last;             ///< at its greatest
  std::size_t evaluations = 0;  ///< positions of the mechanism that were computed for this

  /// The stroke (a length) or the swing (radians).
  double stroke() const { return greatest.value - least.value; }
};

/// Of a body's travel; empty where nothing of the assembly ranges can be assembled.
std::optional<OutputRange> output_range(const Mechanism<double>& mechanism,
                                        const AssemblyRanges& assembly_ranges,
                                        const Travel& travel);

/// Of a point along the unit vector `direction` in global axes.
std::optional<OutputRange> output_range(const Mechanism<double>& mechanism,
                                        const AssemblyRanges& assembly_ranges,
                                        const Attached<double>& point, const Vec2d& direction);

/// K ≥ 1: the longer of the crank's turns between the output's extreme limits over the shorter.
/// Empty unless a crank or floating link turns fully, at least once in the assembly ranges
/// and without change points, and its output has limits at both extremes.
std::optional<double> time_ratio(const Mechanism<double>& mechanism,
                                 const AssemblyRanges& assembly_ranges, const OutputRange& output);

}  // namespace cognate
