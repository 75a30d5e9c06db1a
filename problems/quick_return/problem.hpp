/// @file What a file of kind = "quick-return" says.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/tolerance/tolerances.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"

namespace cognate::problems {

/// `mechanism.type` of a quick return. The shaper's six-bar is a guide-bar that pushes a ram.
enum class QuickReturnType { four_bar, slider_crank, guide_bar, shaper };

/// `kind = "quick-return"`: the return is to take 1/`time_ratio` of the time of the advance. What
/// is empty is found, or does not belong to the type.
struct QuickReturnProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  double time_ratio = 1;
  QuickReturnType type = QuickReturnType::four_bar;
  /// Crank, coupler, rocker and frame as far as the type has them. A four-bar has the rocker, and
  /// at most one of the other three or `crank_pivot_line`; a slider-crank at most one of crank,
  /// coupler and `offset`; guide-bar and shaper have one of frame and crank.
  Given given;
  std::optional<double> swing;                           ///< four-bar: of the rocker
  std::optional<synthesis::PivotLine> crank_pivot_line;  ///< four-bar
  std::optional<double> stroke;                          ///< slider-crank, shaper
  std::optional<double> offset;                          ///< slider-crank, guide-bar
  std::optional<double> rod;                             ///< shaper: of the ram
  std::optional<double> ram_height;                      ///< shaper: over the bar's pivot
  Bounds bounds;                                         ///< four-bar: lengths only
  Constraints constraints;                               ///< four-bar only
  std::optional<double> pressure_angle_max;              ///< slider-crank, shaper
  Solve solve;
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
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

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel; see linkage/result.hpp. The same
/// problem and seed give the same designs for any number of threads. An invalid problem gives
/// no design, its faults as notes and Status::invalid.
Result solve(const QuickReturnProblem& problem, const Run& run);

template <>
std::span<const Named<QuickReturnType>> names<QuickReturnType>();

}  // namespace cognate::problems
