/// @file The extremes of driving torque and reactions over a motion, independent of the rows of its
/// table.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A force (N) or torque (N·m), and the drive's coordinate (radians or length) there.
struct ForceAt {
  double value = 0;
  double drive = 0;
};

/// One end of a quantity's range: the extreme value where there is one, else the places near which
/// the quantity grows beyond every bound.
struct ForceBound {
  std::optional<ForceAt> extreme;
  std::vector<double> unbounded_at;

  bool is_unbounded() const { return !unbounded_at.empty(); }
};

/// Least and greatest driving torque or force, its root mean square, and the greatest magnitude of
/// each reaction (of a slide of its normal force) in the order of joints(mechanism).
struct ForceExtremes {
  ForceBound least_drive, greatest_drive;
  std::optional<double> drive_rms;  ///< over the drive's coordinate; empty where it is unbounded
  std::vector<ForceBound> reactions;
};

/// Over `assembly_ranges`, to rounding: the motion is cut where loads begin and cease and at dead
/// and change points, and each piece is represented by Chebyshev series (analysis/cam/extremes.hpp)
/// with the loads that act inside it, so that values at jumps are those of either side. Towards a
/// dead point the square root of the distance is the variable, over which the motion is smooth; a
/// force that there, at 1e-10 of the drive's scale, still grows like 1/√distance or faster counts
/// as unbounded. Within 5e-3 of the scale about a change point, where the closure is singular, only
/// the point itself is looked at. Reactions only with `output.reactions`. Nothing once `deadline`
/// is reached.
std::optional<ForceExtremes> force_extremes(const AnalysisProblem& problem,
                                            const AssemblyRanges& assembly_ranges,
                                            std::span<const Stroke> strokes,
                                            const Deadline& deadline);

}  // namespace cognate::problems
