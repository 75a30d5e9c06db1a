/// @file What a file of kind = "straight-line" says.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/coupler_curve/parallel_cranks.hpp"
#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// `mechanism.cranks`: how crank and rocker stand in the position where the line is requested.
enum class CrankArrangement { any, parallel, symmetric };

/// The names of CrankArrangement and CrankSides in files, in the order of their declaration.
inline constexpr std::array<std::string_view, 3> kCrankArrangements{"any", "parallel", "symmetric"};
inline constexpr std::array<std::string_view, 2> kCrankSides{"same", "opposite"};

/// `type = "slider-crank"`. Lengths in `StraightLineProblem::given`, the pivot as its pivot_a.
struct SliderGuide {
  double offset = 0;
  double direction = 0;  ///< of the slide line
};

/// What `[target]` demands where it names no method: a search over all linkages. The measures are
/// those of analysis/coupler_curve/straightness.hpp.
struct StraightLineGoal {
  std::optional<double> length;              ///< of the segment
  std::optional<double> deviation;           ///< greatest, half the strip's width
  std::optional<double> deviation_relative;  ///< greatest, over the length
  std::optional<double> direction;           ///< of the line, either way along it
  /// Of the line in the plane, either the first along the motion. Readers set `length` to their
  /// distance and leave `direction` empty.
  std::optional<std::array<Vec2d, 2>> ends;
};

/// `[constraints]` that a segment has beside those of linkages.
struct SegmentConstraints {
  std::optional<Range> crank_range;  ///< the crank's turn over the segment
  /// Largest dimension of a link (the coupler's with its point) over the length; empty: 2 where
  /// deviation or length would gain by size without end.
  std::optional<double> size_over_length_max;
  std::optional<double> speed_variation_max;
};

/// `kind = "straight-line"`. With `method = "exact"`: coupler points whose path has contact of at
/// least `contact` points with a straight line, by the local theory of a position. Else the
/// linkages of `goal`; then `type` and `given` say what is given (a slider-crank's
/// offset in `slider_offset`, its slide line's direction in `given.frame_angle`).
struct StraightLineProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::optional<StraightLineGoal> goal;          ///< empty with method = "exact"
  MechanismType type = MechanismType::four_bar;  ///< of the linkage that is searched
  std::optional<double> slider_offset;
  SegmentConstraints segment;
  Bounds bounds;    ///< of a search
  int contact = 4;  ///< 3, 4 or 5
  CrankArrangement cranks = CrankArrangement::any;
  /// Lengths, pivots and assembly. Of `any` and `symmetric` cranks one length may be missing, which
  /// is chosen for contact of five points.
  Given given;
  /// The position, from the x axis; empty: all positions of the contact. For parallel cranks their
  /// direction, 90° if empty.
  std::optional<double> crank_angle;
  std::optional<SliderGuide> slider;    ///< of a slider-crank
  double coupler_angle = 0;             ///< of parallel cranks: see ParallelCranks
  CrankSides sides = CrankSides::same;  ///< of parallel cranks
  Constraints constraints;
  Solve solve;  ///< `designs` is 100 where the file says nothing
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
  std::optional<Raster> raster{};  ///< of a search
};

template <>
struct KindTraits<StraightLineProblem> {
  static constexpr std::string_view kWord = "straight-line";
  static StraightLineProblem read(reading::TableReader& document,
                                  const std::filesystem::path& folder);
  static reading::Written written(const StraightLineProblem& problem);
  static tl::expected<StraightLineProblem, std::vector<std::string>> checked(
      const StraightLineProblem& problem);
};

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel; see linkage/result.hpp. The same
/// problem and seed give the same designs for any number of threads. An invalid problem gives
/// no design, its faults as notes and Status::invalid.
Result solve(const StraightLineProblem& problem, const Run& run);

}  // namespace cognate::problems
