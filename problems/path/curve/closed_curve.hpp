/// @file A closed curve of the plane, as a polyline known by its arc length.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {

/// A polyline whose last vertex is joined to its first.
class ClosedCurve {
 public:
  /// `vertices`: at least two; each differs from the next, and the last from the first.
  explicit ClosedCurve(std::vector<Vec2d> vertices);

  const std::vector<Vec2d>& vertices() const { return vertices_; }
  double length() const { return at_.back(); }

  /// So many points in equal steps of arc length; the first is the first vertex.
  std::vector<Vec2d> equally_spaced(int count) const;

  /// The distance from `point` to the nearest point of the curve.
  double distance(const Vec2d& point) const;

 private:
  /// A box around the sides from `begin` to `end`. Of an inner node the first half follows at once,
  /// the second stands at `second`; a leaf has none there.
  struct Node {
    Vec2d min, max;
    std::size_t begin, end, second;
  };

  const Vec2d& end_of(std::size_t side) const {
    return vertices_[side + 1 < vertices_.size() ? side + 1 : 0];
  }
  std::size_t add_node(std::size_t begin, std::size_t end);
  void lower(const Vec2d& point, std::size_t node, double& square) const;

  std::vector<Vec2d> vertices_;
  std::vector<double> at_;  ///< arc length at each vertex, and the whole
  std::vector<Node> nodes_;
};

}  // namespace cognate::problems
