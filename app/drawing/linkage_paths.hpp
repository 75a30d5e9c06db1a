/// @file The paths of points of a linkage as polygons.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "app/drawing/linkage_scene.hpp"

namespace cognate::app {

/// The path of a named point over one range of the drive. Its last point is joined to its first
/// where `closed`.
struct PointPath {
  std::string point;
  std::vector<Vec2d> corners;
  bool closed = false;
};

/// Corners that the paths of a linkage have together at most.
inline constexpr std::size_t kMostPathCorners = 500'000;

/// The paths of all named points that move, each nowhere farther from its polygon than about
/// `tolerance`: the drive is halved until the curve keeps that distance from its chords at three
/// places of each. A path ends where the linkage cannot be assembled. Empty where so fine a
/// tolerance takes more than kMostPathCorners.
std::optional<std::vector<PointPath>> linkage_paths(const LinkageScene& linkage,
                                                    const AssemblyRanges& assembly_ranges,
                                                    double tolerance);

}  // namespace cognate::app
