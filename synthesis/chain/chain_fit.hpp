/// @file Least-squares fits of chains to paths from many starts, one in each SIMD lane.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "synthesis/chain/chain.hpp"

namespace cognate::synthesis {

/// What is fitted: the parameters `free` of `chain`, so that its point `trace` comes near the
/// targets; of a motion a heading, too, comes near the directions wanted. Crank angles are further
/// unknowns; of a timed path their phase alone is one.
struct ChainFit {
  Chain chain;
  int trace = 0;
  std::vector<double> x, y, root_weight;  ///< of each target; errors are multiplied by the latter
  /// Of a motion: the line of the body's heading, the direction wanted at each target, and the
  /// length that a radian counts.
  int heading = -1;
  std::vector<double> heading_x, heading_y;
  double angle_weight = 0;
  std::vector<double> crank_angles;  ///< timed: of each target, else empty
  bool closed = false;               ///< the first target follows the last
  std::vector<int> free;             ///< parameters, ascending
  std::vector<double> lower, upper;  ///< of each; infinite where there is no bound
  std::vector<int> joints;           ///< lines of the dyads whose transmission is limited
  double cosine_limit = 1;           ///< the greatest |cos μ| of these
  int checks = 36;  ///< positions of the turn at which they are limited; 0: at the targets
};

/// Where a fit starts, and where it ends.
struct ChainFitState {
  ChainDesign design;
  /// Of the crank, from the x axis, at each target, in order; their differences within a turn where
  /// the path is closed. Timed: the phase alone.
  std::vector<double> angles;
  /// Weighted sum of squares and penalties; not a number where the chain does not close.
  double cost = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
};

struct ChainFitOptions {
  int most_iterations = 80;
  double tolerance = 1e-8;    ///< relative change of the cost at which a fit ends
  double negligible = 1e-28;  ///< cost that counts as zero
  double penalty = 3;         ///< what a cosine is beyond its limit counts so much, as a residual
  /// Starts are given up that cost more after so many iterations.
  int early = 15, late = 40;
  double early_cost = std::numeric_limits<double>::infinity();
  double late_cost = std::numeric_limits<double>::infinity();
  int threads = 1;
  std::function<bool()> stop;         ///< asked now and then; fits not begun are left as they are
  std::optional<InstructionSet> set;  ///< the widest of the machine if empty
};

/// Fits all of `states` in place. What comes of one depends neither on the others nor on threads.
void fit_chains(const ChainFit& problem, std::span<ChainFitState> states,
                const ChainFitOptions& options);

}  // namespace cognate::synthesis
