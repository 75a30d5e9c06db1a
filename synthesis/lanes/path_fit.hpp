/// @file Least-squares fits of linkages to paths from many starts, one in each SIMD lane.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "synthesis/bounds/link_limit.hpp"
#include "synthesis/lanes/path_fit_kernel.hpp"

namespace cognate::synthesis {

/// What is fitted: the unknowns of PathUnknown, those that are not free having the value of the
/// start, so that coupler points come near the targets. The crank angle of a point that is not
/// timed is a further unknown; those of timed points are fixed but for the phase.
struct PathFit {
  std::vector<double> x, y, root_weight;  ///< of each target; errors are multiplied by the latter
  std::vector<int> free;                  ///< of PathUnknown, ascending
  std::vector<double> lower, upper;       ///< of each; infinite where there is no bound. Those of
                                          ///< the two angles are not kept.
  std::vector<unsigned char> is_timed;    ///< of each target
  bool counted_from_x = false;  ///< prescribed crank angles are from the x axis, not from the frame
  bool anchored_at_d = false;   ///< the anchor is the pivot D, not A
  std::vector<LinkLimit> limits;
  std::array<double, 4> box;  ///< of the other pivot: least and greatest x, then y; may be infinite
  /// Least and greatest cosine of the transmission angle at every point.
  std::optional<std::array<double, 2>> transmission_cosines;
};

/// Where a fit starts, and where it ends.
struct PathFitState {
  std::array<double, 8> value{};              ///< of the unknowns from path_crank to path_anchor_y
  double frame_x = 1, frame_y = 0;            ///< direction from A to D
  double half_phase_x = 1, half_phase_y = 0;  ///< direction of half the phase
  double assembly = 1;                        ///< ±1
  /// x and y of the direction of half the crank angle at each point: from the frame, or of a timed
  /// point before the phase.
  std::vector<double> crank_half;

  /// Weighted sum of squares and penalties; not a number where the linkage does not close or has
  /// not been fitted.
  double cost = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
};

struct PathFitOptions {
  int most_iterations = 80;
  double tolerance = 1e-10;   ///< relative change of the cost at which a fit ends
  double negligible = 1e-30;  ///< cost that counts as zero
  /// Weight of violated limits: a violation v costs (penalty·v)², so that limits are kept to some
  /// share of the error, not to rounding.
  double penalty = 10;
  int threads = 1;
  std::function<bool()> stop;         ///< asked now and then; fits not begun are left as they are
  std::optional<InstructionSet> set;  ///< the widest of the machine if empty
};

/// Fits all of `states` in place; those that start beyond a bound start at it. What comes of one
/// depends neither on the others nor on threads.
void fit_paths(const PathFit& problem, std::span<PathFitState> states,
               const PathFitOptions& options);

}  // namespace cognate::synthesis
