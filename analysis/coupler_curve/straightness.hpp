/// @file How straight a segment of a path is, and the longest segment that is straight enough.
///
/// A segment is the path over an interval of its parameter. Its line is the middle of the narrowest
/// strip that holds it, its length L the distance between the feet of its ends on that line, its
/// deviation δ half the width of the strip: the largest distance from the line. δ/L says how
/// straight it is. (Tables of (max − min)/stroke give 2 δ/L.)
#pragma once

#include <functional>
#include <optional>

#include "analysis/coupler_curve/narrowest_strip.hpp"
#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A point of a path and its derivative by the parameter.
struct PathPoint {
  Vec2d at;
  Vec2d rate;
};

/// A path by a parameter, such as the drive's coordinate. Points that are not numbers end it.
using Path = std::function<PathPoint(double)>;

/// The path of a point of a mechanism by its drive, in the assemblies that the mechanism names.
Path path_of(const Mechanism<double>& mechanism, const Attached<double>& point);

/// A part of a path and its best line: the middle of the narrowest strip that holds it.
struct StraightSegment {
  double from = 0;  ///< of the parameter, from < to
  double to = 0;
  double length = 0;
  double deviation = 0;
  Line line;  ///< directed as the parameter grows
};

/// The segment from `from` to `to` with its best line. The strip is exact, not sampled: where the
/// path comes nearest to its sides is refined between samples until the width no longer grows.
StraightSegment measure(const Path& path, double from, double to);

/// The interval about `at`, within `limits`, over which a path does not turn back along its own
/// tangent at `at`, nor end; for a parameter that is an angle, at most a turn to either side. Empty
/// where the point stands still at `at`, and where there is no path.
std::optional<CrankRange> forward_interval(const Path& path, double at, const CrankRange& limits);

/// The longest segment within `forward` that holds `at` and has δ ≤ `relative`·L.
StraightSegment longest_segment(const Path& path, double at, const CrankRange& forward,
                                double relative);

/// The longest segment about `at` within `forward` that keeps within `relative`·L of the tangent at
/// `at`, L its extent along that tangent; the tangent is its line.
StraightSegment longest_tangent_segment(const Path& path, double at, const CrankRange& forward,
                                        double relative);

/// (max − min)/mean of the speed along the line for a drive of constant speed. Empty for a segment
/// without length, and where it ends in a dead point, where the speed has no bound.
std::optional<double> speed_variation(const Path& path, const StraightSegment& segment);

}  // namespace cognate
