/// @file Which points lie on which body of a chain, and where.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/chain/chain.hpp"

namespace cognate::problems {

/// The bodies of a chain, numbered and with the axes of `analysis/mechanism/mechanism.hpp`: the
/// frame, the crank, two for each dyad, four for each link with three pins: those that hold it by
/// its first, second and third pin, and the link itself.
class ChainPlaces {
 public:
  /// `parameters`: line by line; without them which body a point is on is known, but not where.
  explicit ChainPlaces(std::span<const synthesis::ChainLine> lines,
                       std::span<const double> parameters = {});

  int body_count() const { return static_cast<int>(bodies_.size()); }

  /// The body that carries both points, the last where there are several.
  std::optional<int> common_body(int first, int second) const;

  /// The first body that carries the point, and where in its axes.
  std::pair<int, Vec2d> place(int line) const;

  /// Origin and unit vector of the axes from `first` towards `second` in those of the body that
  /// carries both.
  std::pair<Vec2d, Vec2d> axes(int first, int second) const;

  /// Where `at`, in the axes from `first` towards `second` of the body that carries both, lies in
  /// the body's own axes.
  Vec2d in_body(int first, int second, const Vec2d& at) const;

  /// The inverse of `in_body`.
  Vec2d in_axes(int first, int second, const Vec2d& place) const;

  /// Where the point is in the axes of a body; empty where it is not on it.
  std::optional<Vec2d> find(int body, int line) const;

 private:
  struct ThreePins;
  void add_three_pins(const ThreePins& link);

  std::vector<std::vector<std::pair<int, Vec2d>>> bodies_;  // of each body its points
};

}  // namespace cognate::problems
