/// @file The crank angles at which one linkage comes nearest to points that are not timed, in
/// order.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "problems/path/problem.hpp"

namespace cognate::problems {

/// What holds the crank angle of a point.
enum class HeldBy {
  timing,      ///< it is prescribed
  nothing,     ///< it is the best for all points of its block
  range_end,   ///< an end of the range in which the linkage closes, or keeps its transmission angle
  timed_point  ///< that of the timed point before or after it
};

/// Where one point lies on the coupler curve.
struct PlaceInOrder {
  HeldBy held_by = HeldBy::timing;
  double angle = 0;             ///< of the crank, from the frame line
  std::size_t block = 0;        ///< points of one block that nothing holds share their angle
  std::size_t timed_point = 0;  ///< which one holds it
};

struct OrderedPlaces {
  std::vector<PlaceInOrder> of_point;
  std::size_t blocks = 0;
  double cost = 0;  ///< weighted sum of squared distances, of timed points too

  /// Whether points share an angle, or something holds one that is not timed.
  bool any_held() const;
};

/// Whether the crank angles of untimed points of `problem` are kept in order, or on one circuit.
bool assigns_places(const PathProblem& problem);

struct PathOrderMemory;

/// What finding places needs of memory; it grows to the size of the problem once. One thread uses
/// it at a time.
class PathOrderWorkspace {
 public:
  PathOrderWorkspace();
  ~PathOrderWorkspace();
  PathOrderMemory& operator*() const { return *memory_; }

 private:
  std::unique_ptr<PathOrderMemory> memory_;
};

class OrderIntervals;

/// Finds, for a linkage, the crank angles of the points that are not timed at which the weighted
/// sum of squared distances is least, where the crank passes all points in their order, in one
/// sense, once round at most and without leaving the range in which the linkage closes. Where the
/// transmission angle of a crank that does not turn fully is limited, the range ends where that is
/// at a limit, or at a timed point beyond. Points whose order binds share an angle: they form a
/// block, which is as far away as their weighted mean. Where any order will do each point lies at
/// the nearest place of the range.
///
/// Global up to the sampling of the curve by dynamic programming over its samples; then brought to
/// rounding by Newton steps, blocks being merged as in isotonic regression (adjacent violators).
class PathOrder {
 public:
  /// `scaled` is copied as far as it is needed. `transmission`: limits over the way of the crank.
  explicit PathOrder(const PathProblem& scaled, std::optional<Range> transmission = std::nullopt);
  ~PathOrder();

  /// `crank_angles`: from the x axis, of which those of timed points are used. The places are in
  /// `workspace` until its next use; null where the linkage does not close at the timed points,
  /// cannot pass them in that order, or has no place within the limits.
  const OrderedPlaces* places(const FourBar& linkage, std::span<const double> crank_angles,
                              bool clockwise, PathOrderWorkspace& workspace) const;

 private:
  std::vector<CrankRange> ranges(const Lengths<double>& links, std::span<const double> timed_at,
                                 double sense) const;

  std::vector<Vec2d> points_;
  std::vector<double> weights_;
  std::vector<std::size_t> timed_;  ///< ascending
  bool in_order_;
  std::optional<Range> transmission_;
  std::unique_ptr<OrderIntervals> intervals_;
};

}  // namespace cognate::problems
