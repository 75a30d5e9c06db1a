/// @file The points of one interval of a motion placed along the coupler curve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/path/curve/curve_branch.hpp"
#include "problems/path/order_intervals.hpp"

namespace cognate::problems {

/// Consecutive points that share a place, as one of their weighted mean.
struct Block {
  double at = 0;  ///< along the motion
  Vec2d mean;
  double weight = 0;
  std::size_t first = 0, last = 0;  ///< of the points of its interval
  double from = 0, to = 0;          ///< between which places it is looked for
};

/// Which sample each point is assigned to.
struct PlacingWay {
  double cost = 0;
  std::vector<std::size_t> at;  ///< sample of each point, counted on beyond the turn
  std::size_t begin = 0;        ///< the sample from which they are counted
};

/// What placing needs of memory, kept from one linkage to the next.
struct PlacingWorkspace {
  std::vector<CurveSample> samples, finer;
  std::vector<std::uint16_t> source;
  std::vector<double> cost, distance, chord;
  PlacingWay way, other;
  std::vector<Block> blocks;
};

/// The points of one interval placed along a branch.
class PathPlacing {
 public:
  PathPlacing(const CurveBranch& branch, const Travel& travel, const OrderInterval& interval,
              std::span<const Vec2d> targets, std::span<const double> weights,
              PlacingWorkspace& workspace);

  /// The curve can be sampled somewhere.
  bool is_possible() const { return !samples_.empty(); }

  /// The blocks, one behind the other; they are in the workspace.
  std::span<const Block> in_order();

  /// A block for each point, wherever the curve comes nearest to it.
  std::span<const Block> in_any_order();

 private:
  const Vec2d& target(std::size_t k) const { return targets_[stretch_.points[k]]; }
  double weight(std::size_t k) const { return weights_[stretch_.points[k]]; }
  double place_of(std::size_t sample) const {
    const std::size_t whole_turns = sample / samples_.size();
    return samples_[sample % samples_.size()].at + kTurn * double(whole_turns);
  }
  void find_way(std::size_t first, std::size_t starts, std::size_t count, PlacingWay& way) const;
  const PlacingWay& best_way() const;
  void settle(Block& block) const;
  Block settled(std::size_t sample, std::size_t k) const;
  void merge(Block& into, const Block& next, double shift) const;
  void close(std::vector<Block>& blocks) const;
  void release(std::vector<Block>& blocks) const;

  const CurveBranch& branch_;
  const Travel& travel_;
  const OrderInterval& stretch_;
  std::span<const Vec2d> targets_;
  std::span<const double> weights_;
  PlacingWorkspace& own_;
  std::vector<CurveSample>& samples_;
};

}  // namespace cognate::problems
