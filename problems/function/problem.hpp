/// @file What `kind = "function-generation"` specifies. Angles are in radians, lengths in the
/// file's unit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// Where the start angles of a function generator are taken from.
enum class FunctionStart { free, outer_dead_centre, inner_dead_centre };
/// What is least: nothing (exact at precision points), the sum of squares, the largest error.
enum class FunctionObjective { exact, least_squares, minimax };

/// `target.function` with `domain`, or `target.table`: y as a function of x on [domain.min,
/// domain.max]. `y` may be called from one thread at a time and is finite on the whole domain.
struct FunctionOfX {
  std::string text;                              ///< the expression as written; empty for a table
  std::vector<std::pair<double, double>> table;  ///< as written; empty for an expression
  std::function<double(double)> y;
  Range domain;
  /// Input and output angle swept over the domain, signed (negative: clockwise). Empty with
  /// relation = "angles": then x and y are themselves angles from the start angles. The output of a
  /// slider-crank is a displacement (negative: against the slide direction).
  std::optional<double> input_range, output_range;
};

/// `target.pairs_deg`: input and output angles, in radians, counted from the start angles; of a
/// slider-crank, `target.pairs`, input angles and displacements from the start.
using AnglePairs = std::vector<std::pair<double, double>>;

/// `solve.best_by`: what chooses among exact designs where they form a family.
enum class BestBy {
  error,        ///< the least of the largest structural errors over the domain
  transmission  ///< the greatest of the least transmission angles
};

/// `target.spacing`: how precision points are placed where `at` does not.
enum class PointSpacing {
  chebyshev,
  equal_peaks  ///< so that the peaks of the structural error are level; four-bars only
};

/// `kind = "function-generation"`. All angles of links are measured from the directed line A→D.
struct FunctionProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  MechanismType type = MechanismType::four_bar;  ///< or slider_crank, with objective `exact` alone
  std::variant<FunctionOfX, AnglePairs> target;
  FunctionObjective objective = FunctionObjective::least_squares;
  int precision_points = 0;  ///< 3, 4 or 5 with objective `exact`, else 0
  std::vector<double> at;    ///< precision points in x, given; empty: Chebyshev spacing
  PointSpacing spacing = PointSpacing::chebyshev;
  /// How many conditions each precision point is, one for each; empty: each is one. k: the output
  /// and its first k − 1 derivatives. Their sum is `precision_points`.
  std::vector<int> multiplicity;
  /// With pairs: derivatives of the output by the input in radians, a list for each pair; empty:
  /// none. Each derivative is a condition in addition to the pair's own.
  std::vector<std::vector<double>> derivatives;
  std::vector<double> sample_at;  ///< sample abscissae in x, explicit; empty for angle pairs
  FunctionStart start = FunctionStart::free;
  /// α₀, φ₀ where the file fixes them; of a slider-crank the crank's angle from the slide direction
  /// and the displacement from the foot of the perpendicular from the pivot.
  std::optional<double> input_start, output_start;
  std::optional<double> offset{};  ///< of a slider-crank's slide line, positive to its left
  Given given;                     ///< lengths and assembly only
  Bounds bounds;                   ///< lengths only
  std::optional<Range> input_start_bounds, output_start_bounds;
  std::optional<Range> offset_bounds{};
  Constraints constraints;
  Solve solve;
  WarningLimits warnings{};
  std::optional<Raster> raster;  ///< least squares; which lengths take single values only
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
  std::optional<BestBy> best_by;  ///< empty: by error for functions, by transmission for pairs
};

template <>
struct KindTraits<FunctionProblem> {
  static constexpr std::string_view kWord = "function-generation";
  static FunctionProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const FunctionProblem& problem);
  static tl::expected<FunctionProblem, std::vector<std::string>> checked(
      const FunctionProblem& problem);
};

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel; see linkage/result.hpp. The same
/// problem and seed give the same designs for any number of threads. An invalid problem gives
/// no design, its faults as notes and Status::invalid.
Result solve(const FunctionProblem& problem, const Run& run);

template <>
std::span<const Named<FunctionStart>> names<FunctionStart>();
template <>
std::span<const Named<FunctionObjective>> names<FunctionObjective>();
template <>
std::span<const Named<BestBy>> names<BestBy>();
template <>
std::span<const Named<PointSpacing>> names<PointSpacing>();

}  // namespace cognate::problems
