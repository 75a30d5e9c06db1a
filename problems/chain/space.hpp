/// @file Which dimensions of a chain are sought, and within what.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "problems/chain/topology.hpp"
#include "synthesis/chain/chain.hpp"

namespace cognate::problems {

/// Where the unit of a search is: of a path the centroid of its points, and the root of their mean
/// squared distance from there.
struct TargetScale {
  Vec2d centre;
  double size = 1;

  TargetScale() = default;
  explicit TargetScale(std::span<const Vec2d> points);

  Vec2d into(const Vec2d& point) const { return (1 / size) * (point - centre); }
  /// A design in the unit of the search.
  synthesis::ChainDesign into(const synthesis::Chain& chain, synthesis::ChainDesign design) const;
  /// A design back in the file's unit.
  synthesis::ChainDesign out_of(const synthesis::Chain& chain, synthesis::ChainDesign design) const;
};

/// The designs of a topology, in the unit of the search.
struct ChainSpace {
  const Topology* topology = nullptr;
  synthesis::Chain chain;
  std::vector<synthesis::PlacedLine> lines;
  /// Of each parameter: what is given, and bounds, which are finite.
  std::vector<std::optional<double>> given;
  std::vector<double> lower, upper;
  std::vector<int> free;    ///< the parameters that are not given
  std::vector<int> joints;  ///< lines of the dyads that move
  double cosine_limit = 1;  ///< of |cos μ|, below 1

  /// `transmission`: radians; the narrower side counts.
  ChainSpace(const Topology& topology, const TargetScale& scale, const Range& transmission);

  /// Bounds of what the file leaves without: of lengths from `least`, of lengths and coordinates up
  /// to `most`, or from there on where the bound given lies beyond. No link is shorter than
  /// `kLeastLink`, so that it has a direction.
  void limit_open(double least, double most);
  static constexpr double kLeastLink = 1e-4;

  /// Whether a dimension is given, so that drawn designs cannot be enlarged and moved.
  bool is_anchored() const {
    return std::ranges::any_of(given, [](const auto& value) { return value.has_value(); });
  }
};

/// The design whose free parameters are the nearest within their bounds.
synthesis::ChainDesign within_bounds(const ChainSpace& space, synthesis::ChainDesign design);

/// The same mechanism with guides whose direction is found from −90° up to 90°, where what the file
/// gives of their sliders leaves that open.
synthesis::ChainDesign with_guides_forward(const ChainSpace& space, synthesis::ChainDesign design);

/// Whether two designs have the same assembly and dimensions, relative to these or 1.
bool is_same_chain(const synthesis::ChainDesign& known, const synthesis::ChainDesign& other,
                   double tolerance);

}  // namespace cognate::problems
