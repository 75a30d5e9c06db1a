/// @file What `kind = "path-generation"` specifies where the mechanism is a longer chain than a
/// four-bar. Angles are in radians, lengths in the file's unit.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/chain/front/measure.hpp"
#include "problems/chain/topology.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// The motion over which a limit holds: the whole turn of the crank, or from the first to the last
/// point.
enum class LimitSpan { turn, range };

/// `[constraints]` of chains.
struct ChainConstraints {
  /// Of every dyad that is a joint (rigid triangles are none), radians; symmetric about a right
  /// angle: the narrower side counts.
  Range transmission_angle{0, 3.14159265358979323846};
  LimitSpan over = LimitSpan::turn;
  std::optional<double> rms_error_max;
};

/// `kind = "path-generation"` with a chain as its mechanism.
struct ChainPathProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::string mechanism;             ///< `mechanism.type`
  std::vector<Topology> topologies;  ///< at least one; tried in turns
  /// At least 3, neighbours distinct. `closed`: the first follows the last, which does not repeat
  /// it.
  std::vector<Vec2d> points;
  bool closed = false;
  /// Of a closed path on a raster: it may be moved, turned and enlarged.
  bool is_movable = false;
  /// Crank angles of the points, of which differences alone count; empty: free, in cyclic order.
  std::vector<double> crank_angles;
  ChainConstraints constraints;
  Solve solve;
  std::optional<ChainMeasure> against{};  ///< of a front; empty: the error alone counts
  WarningLimits warnings{};
  std::optional<Raster> raster{};  ///< of one topology
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
};

template <>
struct KindTraits<ChainPathProblem> {
  static constexpr std::string_view kWord = "path-generation";
  /// Whether the mechanism of a path is a longer chain than a four-bar.
  static bool takes(reading::TableReader& document);
  static ChainPathProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const ChainPathProblem& problem);
  static tl::expected<ChainPathProblem, std::vector<std::string>> checked(
      const ChainPathProblem& problem);
};

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel. The same problem and seed give the
/// same designs for any number of threads.
Result solve(const ChainPathProblem& problem, const Run& run);

template <>
std::span<const Named<LimitSpan>> names<LimitSpan>();

}  // namespace cognate::problems
