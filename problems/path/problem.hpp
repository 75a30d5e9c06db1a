/// @file What `kind = "path-generation"` specifies. Angles are in radians, lengths in the file's
/// unit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/path/curve/closed_curve.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// `mixed`: prescribed at some of the points.
enum class Timing { free, prescribed, mixed };
/// What stands in `target.crank_deg` at a point that is not timed.
inline constexpr const char* kFreeAngle = "free";
/// From where `target.crank_deg` counts: the first timed point, the line A→D, the x axis.
enum class CrankReference { first, frame, global };
/// In which sense the crank turns from point to point.
enum class CrankSense { either, ccw, cw };
/// `least_squares`: as near to the points as can be. `exact`: through each of them, all solutions.
enum class PathMethod { least_squares, exact };

/// `target.place`: the curve stays where it is, or may be moved, turned and enlarged.
enum class CurvePlace { given, similar };

/// A closed curve as the target.
struct TargetCurve {
  ClosedCurve curve;
  std::string svg_path;  ///< the path data it was read from, y down; empty where it was a polyline
  CurvePlace place = CurvePlace::given;
};

/// `solve.atlas`: the study file with whose curves a search for a closed curve begins. Who solves
/// the problem reads it; that it is no atlas is then a fault of the problem file, at this place.
struct AtlasSource {
  std::string name;            ///< as written
  std::filesystem::path file;  ///< in the folder of the problem file
  std::size_t line = 1, column = 1;
};

/// `kind = "path-generation"`.
struct PathProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  PathMethod method = PathMethod::least_squares;
  /// At least 3, neighbours distinct (the last may repeat the first); `exact`: 2 to 9, all
  /// distinct.
  std::vector<Vec2d> points;
  /// Where a closed curve is given instead: `points` are then its samples, in equal steps.
  std::optional<TargetCurve> curve;
  /// `exact`: orientations of the coupler at the first of the points, which are `target.poses`.
  std::vector<double> pose_angles;
  Timing timing = Timing::free;
  /// One for each point, empty with free timing; entries of untimed points are ignored.
  /// With reference `first` only differences from that of the first timed point count.
  std::vector<double> crank_angles;
  std::vector<bool> has_crank_angle;  ///< mixed timing: whether each point is timed, some are
  CrankReference crank_reference = CrankReference::first;
  CrankSense crank_sense = CrankSense::either;
  PointOrder order = PointOrder::cyclic;
  std::vector<double> weights;  ///< one for each point; all 1 when the file gives none
  Given given;
  Bounds bounds;
  Constraints constraints;
  Solve solve;
  WarningLimits warnings{};
  std::optional<Raster> raster;  ///< least squares; which dimensions take single values only
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
  std::optional<AtlasSource> atlas;  ///< of a closed curve

  /// Whether the crank's angle at a point is prescribed.
  bool is_timed(std::size_t point) const {
    return timing == Timing::prescribed || (timing == Timing::mixed && has_crank_angle[point]);
  }
};

template <>
struct KindTraits<PathProblem> {
  static constexpr std::string_view kWord = "path-generation";
  static PathProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const PathProblem& problem);
  static tl::expected<PathProblem, std::vector<std::string>> checked(const PathProblem& problem);
};

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel; see linkage/result.hpp. The same
/// problem and seed give the same designs for any number of threads. An invalid problem gives
/// no design, its faults as notes and Status::invalid.
Result solve(const PathProblem& problem, const Run& run);

template <>
std::span<const Named<Timing>> names<Timing>();
template <>
std::span<const Named<CrankReference>> names<CrankReference>();
template <>
std::span<const Named<CrankSense>> names<CrankSense>();
template <>
std::span<const Named<CurvePlace>> names<CurvePlace>();
template <>
std::span<const Named<PathMethod>> names<PathMethod>();

}  // namespace cognate::problems
