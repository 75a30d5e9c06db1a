/// @file The links of a mechanism as plates in layers, and the pins that cross them.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The bodies of a driving cylinder.
inline constexpr int kDrivingRod = 1, kDrivingCylinder = 2;

/// The sizes of links and pins, in the lengths of the mechanism.
struct PlateSizes {
  std::vector<double> widths;  ///< of each body; that of the frame is ignored
  double pin_diameter = 0;
  double clearance = 0;  ///< that plates and pins of one layer keep from each other
};

/// What a disc covers that moves over a convex polygon: one corner is a disc, two are a bar with
/// round ends.
struct Plate {
  int body = 0;
  std::vector<Vec2d> corners;  ///< in the axes of the body, counter-clockwise
  double radius = 0;           ///< of the disc
  /// Corners on another body, with which the polygon is their convex hull: of a cylinder those of
  /// its rod.
  std::vector<Attached<double>> others{};
};

/// A pin, and the links that it joins: indices of `Plates::links`, ascending.
struct PlatePin {
  Plate disc;
  std::vector<int> links;
  bool on_base = false;  ///< whether it rises from the base, below all layers
  int joint = 0;         ///< the first of the joints that it is: an index of `joints(mechanism)`
};

struct Plates {
  std::vector<Plate> links;  ///< of the bodies that have layers, in their order
  std::vector<PlatePin> pins;
  std::vector<std::pair<int, int>> slides;  ///< links of which one slides on the other, no pin
};

/// The plates of a mechanism that moves along `motion` (which has a range).
///
/// - A link covers the convex hull of its joints, its named `points` and, where something slides on
///   it, the way of what slides, swept by a disc as wide as the link.
/// - The frame is the base below all layers. Joints at one place are one pin.
/// - A block or slider whose turning joints are all at its origin, and on which nothing slides, has
///   no layer: its pin runs in the slot of the link that it slides on, or in the base.
/// - Any other slider is a link, whose guide is not looked at.
/// - A driving cylinder is one link with its rod, as wide as the cylinder, from its pivot to the
///   rod's pin at every position.
Plates plates(const Mechanism<double>& mechanism, const AssemblyRanges& motion,
              std::span<const Attached<double>> points, const PlateSizes& sizes);

}  // namespace cognate
