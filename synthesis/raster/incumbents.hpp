/// @file The best combinations of a raster that are known, and those that were looked at.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "synthesis/raster/raster.hpp"

namespace cognate::synthesis {

/// Combinations that were evaluated, the best of them kept.
class RasterIncumbents {
 public:
  /// What it is made of must outlive it.
  RasterIncumbents(const RasterTask& task, const RasterOptions& options);

  /// Evaluates those of `all` that were not yet, from `from`, and keeps the best that are accepted.
  void consider(const std::vector<RasterNumbers>& all, std::span<const RasterPoint> from);

  /// Designs found at one combination, the best of which takes the place of the one known there.
  void add(const RasterNumbers& at, std::vector<RasterPoint> points);

  /// Moves on from the best to its best neighbour (one or two axes by one value each) until none is
  /// better, or `is_over`.
  void improve(const std::function<bool()>& is_over);

  /// Whether `point`, at one combination, meets every constraint.
  bool meets_all(const RasterPoint& point) const;
  /// The best of `points`, at one combination, that meets every constraint; else the best of those
  /// that violate them least. Empty where there is no point.
  std::optional<RasterPoint> best_of(std::vector<RasterPoint> points) const;

  bool empty() const { return best_.empty(); }
  const RasterPoint& best() const { return best_.front().point; }
  /// Of the best; infinite without one.
  double objective() const;
  std::uint64_t evaluated() const { return looked_at_.size(); }
  /// The combinations kept, best first, then those of which no design was accepted: as many as are
  /// searched in the end.
  std::vector<RasterNumbers> promising() const;
  /// As many as the options want, best first.
  std::vector<RasterPoint> take();

 private:
  struct Kept {
    RasterNumbers at;
    RasterPoint point;
  };

  struct Rejected {
    RasterNumbers at;
    double violation, objective;  ///< of its best point
  };

  std::size_t capacity() const;
  void remember(RasterNumbers at, const std::vector<RasterPoint>& points);
  void insert(RasterNumbers at, std::vector<RasterPoint> points);
  std::vector<RasterNumbers> neighbours(const RasterNumbers& at) const;

  const RasterTask& task_;
  const RasterOptions& options_;
  std::set<RasterNumbers> looked_at_;
  std::vector<Kept> best_;
  std::vector<Rejected> rejected_;  ///< the most promising first
};

}  // namespace cognate::synthesis
