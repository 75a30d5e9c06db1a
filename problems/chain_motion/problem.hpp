/// @file What `kind = "motion-generation"` specifies where the mechanism is a longer chain than a
/// four-bar. Angles are in radians, lengths in the file's unit.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/chain/front/measure.hpp"
#include "problems/chain/problem.hpp"
#include "problems/chain/topology.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/tolerance/tolerances.hpp"
#include "synthesis/exact/motion/pose.hpp"

namespace cognate::problems {

/// `kind = "motion-generation"` with a chain as its mechanism: a link of it carries a body through
/// poses, as near as can be.
struct ChainMotionProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::string mechanism = "six-bar";  ///< `mechanism.type`
  std::vector<Topology> topologies;   ///< at least one; `trace` is the body's origin, on a link
  /// At least 3, neighbours distinct, not all with the origin at one place. `closed`: the first
  /// follows the last, which does not repeat it.
  std::vector<synthesis::Pose> poses;
  bool closed = false;
  /// Crank angles of the poses, of which differences alone count; empty: free, in cyclic order.
  std::vector<double> crank_angles;
  /// The length that an error of one radian counts; empty: the root mean squared distance of the
  /// origin from its mean place.
  std::optional<double> angle_weight{};
  ChainConstraints constraints;  ///< the error: of |Δp|² + (weight Δθ)²
  Solve solve;
  std::optional<ChainMeasure> against{};  ///< of a front; empty: the error alone counts
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};  ///< of the place of the body's origin
  std::optional<DesignLayers> layers{};
};

template <>
struct KindTraits<ChainMotionProblem> {
  static constexpr std::string_view kWord = "motion-generation";
  /// Whether the mechanism that guides a body is named, as longer chains than a four-bar are.
  static bool takes(reading::TableReader& document);
  static ChainMotionProblem read(reading::TableReader& document,
                                 const std::filesystem::path& folder);
  static reading::Written written(const ChainMotionProblem& problem);
  static tl::expected<ChainMotionProblem, std::vector<std::string>> checked(
      const ChainMotionProblem& problem);
};

/// The name of the body's origin, the same in every topology.
const std::string& origin_name(const ChainMotionProblem& problem);

/// The length that a radian counts.
double angle_weight_of(const ChainMotionProblem& problem);

struct Result;
struct Run;

/// Designs for `problem`, each checked by the analysis kernel. The same problem and seed give the
/// same designs for any number of threads.
Result solve(const ChainMotionProblem& problem, const Run& run);

}  // namespace cognate::problems
