/// @file The paths of points of a linkage as polygons.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/mechanism/course.hpp"
#include "app/export/result_linkage.hpp"

namespace cognate::app {

/// The path of a named point over one range of the drive. Its last point is joined to its first
/// where `closed`.
struct PointPath {
  std::string point;
  std::vector<Vec2d> corners;
  bool closed = false;
};

/// The paths of all named points that move, each nowhere farther from its polygon than about
/// `tolerance`: the drive is halved until the curve keeps that distance from its chords at three
/// places of each. A path ends where the linkage cannot be assembled. The error says that so fine a
/// tolerance takes too many points.
tl::expected<std::vector<PointPath>, std::string> linkage_paths(const ResultLinkage& linkage,
                                                                const Course& course,
                                                                double tolerance);

}  // namespace cognate::app
