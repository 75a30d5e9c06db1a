/// @file What `kind = "leg"` specifies: a chain whose foot walks. Angles are in radians, lengths in
/// the file's unit; the ground is parallel to the x axis, below.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/chain/front/measure.hpp"
#include "problems/chain/topology.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// Of what legs are best.
enum class LegObjective {
  flatness,  ///< the least band over the stride, at the duty factor given
  duty       ///< the greatest duty factor at which the flatness is within its limit
};

/// `[target]` of legs; see analysis/mechanism/gait.hpp for what each is of a foot's path.
struct LegTarget {
  double duty = 0.5;  ///< duty factor; where it is the objective, the least
  double stride = 1;  ///< met exactly: a leg may be scaled
  std::optional<double> height_min, height_max;  ///< of the step
  std::optional<double> flatness_max;            ///< with `LegObjective::duty` it must be there
  LegObjective objective = LegObjective::flatness;
};

/// `[constraints]` of legs.
struct LegConstraints {
  /// Of every dyad that is a joint over the turn, radians; the narrower side counts.
  Range transmission_angle{0, 3.14159265358979323846};
  /// Of the foot in stance, relative to its mean: below 0 it may step back.
  std::optional<double> foot_speed_min, foot_speed_max;
};

/// `kind = "leg"`.
struct LegProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::string mechanism = "klann";   ///< `mechanism.type`
  std::vector<Topology> topologies;  ///< at least one; `trace` is the foot
  /// Of a published leg: each link, side of a plate and distance of a pivot from the crank's is
  /// within this factor of the published one at the stride, unless the file gives or bounds it
  /// elsewhere. Lines with a coordinate given or bounded have no limit of distance.
  std::optional<double> near;
  LegTarget target;
  LegConstraints constraints;
  Solve solve;
  std::optional<ChainMeasure> against{};  ///< of a front; empty: the error alone counts
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
};

template <>
struct KindTraits<LegProblem> {
  static constexpr std::string_view kWord = "leg";
  static LegProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const LegProblem& problem);
  static tl::expected<LegProblem, std::vector<std::string>> checked(const LegProblem& problem);
};

struct Result;
struct Run;

/// Legs, the best first. `Design::error` is the deviation of the foot in stance from the middle of
/// its band, in the file's unit; `Design::crank_angles` are where the stance begins and ends.
Result solve(const LegProblem& problem, const Run& run);

template <>
std::span<const Named<LegObjective>> names<LegObjective>();

}  // namespace cognate::problems
