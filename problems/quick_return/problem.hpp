/// @file What a file of kind = "quick-return" says.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"
#include "synthesis/exact/quick_return/limit_angle.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"

namespace cognate::problems {

/// `mechanism.type` of a quick return. The shaper's six-bar is a guide-bar that pushes a ram.
enum class QuickReturnType { four_bar, slider_crank, guide_bar, shaper };

/// The lengths of the types that may lie on a raster, each type having some of them.
enum class ReturnLength { crank, coupler, rocker, frame, offset, bar, rod, ram_height };
inline constexpr std::size_t kReturnLengths = 8;

/// `kind = "quick-return"`: the return is to take 1/`time_ratio` of the time of the advance. What
/// is empty is found, or does not belong to the type.
struct QuickReturnProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  double time_ratio = 1;
  QuickReturnType type = QuickReturnType::four_bar;
  /// Crank, coupler, rocker and frame as far as the type has them. A four-bar has the rocker, and
  /// at most one of the other three, `crank_pivot_line` and `limit_angle`, or without `swing` the
  /// frame and `limit_angle`; a slider-crank at most one of crank,
  /// coupler and `offset`; guide-bar and shaper have one of frame and crank. With a raster any of
  /// them may be given.
  Given given;
  std::optional<double> swing;                               ///< four-bar: of the rocker
  std::optional<synthesis::PivotLine> crank_pivot_line;      ///< four-bar
  std::optional<synthesis::RockerLimitAngle> limit_angle{};  ///< four-bar: of the rocker
  std::optional<double> stroke;                              ///< slider-crank, shaper
  std::optional<double> offset;                              ///< slider-crank, guide-bar
  std::optional<double> rod;                                 ///< shaper: of the ram
  std::optional<double> ram_height;                          ///< shaper: over the bar's pivot
  Bounds bounds;                                             ///< four-bar: lengths only
  /// Of the other types, with a raster: by `ReturnLength`.
  std::array<std::optional<Range>, kReturnLengths> raster_bounds{};
  Constraints constraints;                   ///< four-bar only
  std::optional<double> pressure_angle_max;  ///< slider-crank, shaper
  Solve solve;
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
  std::optional<Raster> raster{};
};

template <>
struct KindTraits<QuickReturnProblem> {
  static constexpr std::string_view kWord = "quick-return";
  static QuickReturnProblem read(reading::TableReader& document,
                                 const std::filesystem::path& folder);
  static reading::Written written(const QuickReturnProblem& problem);
  static tl::expected<QuickReturnProblem, std::vector<std::string>> checked(
      const QuickReturnProblem& problem);
};

/// The key in [mechanism] of the rocker's angle at a limit.
std::string_view limit_angle_key(synthesis::RockerLimit limit);

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel; see linkage/result.hpp. The same
/// problem and seed give the same designs for any number of threads. An invalid problem gives
/// no design, its faults as notes and Status::invalid.
Result solve(const QuickReturnProblem& problem, const Run& run);

template <>
std::span<const Named<QuickReturnType>> names<QuickReturnType>();
template <>
std::span<const Named<ReturnLength>> names<ReturnLength>();

}  // namespace cognate::problems
