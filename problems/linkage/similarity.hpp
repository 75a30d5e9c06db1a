/// @file Problems moved and enlarged: file units to units of the target's own size.
#pragma once

#include <optional>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// Points p → (p − centre)/size, lengths l → l/size.
struct Similarity {
  Vec2d centre;
  double size = 1;

  Vec2d point(const Vec2d& p) const { return (1 / size) * (p - centre); }
  Vec2d point_back(const Vec2d& p) const { return centre + size * p; }

  /// In place, each where there is one.
  void shrink(std::optional<double>& length) const;
  void shrink(std::optional<Range>& lengths) const;
  void shrink(std::optional<Box>& vectors) const;  ///< of a link's own axes
  void move(std::optional<Vec2d>& p) const;
  void move(std::optional<Box>& box) const;
  void move(Given& given) const;
  void move(Bounds& bounds) const;
  /// Masses and times stay: a force is then divided by the size, a torque by its square.
  void move(Constraints& constraints) const;
};

}  // namespace cognate::problems
