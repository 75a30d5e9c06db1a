/// @file What `kind = "function-generation"` with `target.dwell` specifies: an output that stands
/// still while the crank turns on. Angles are in radians, lengths in the file's unit.
#pragma once

#include <array>
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
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// `target.dwell`: a part of the crank's turn in which the output is to stand still.
struct Dwell {
  double over = 0;                      ///< its length, in (0, 2π)
  std::optional<double> from;           ///< crank angle at which it begins; empty: found
  std::optional<double> half_band_max;  ///< of the output about its middle, radians or lengths
};

/// `[constraints]` of dwells.
struct DwellConstraints {
  /// Of every dyad that is a joint over the turn, radians; the narrower side counts.
  Range transmission_angle{0, 3.14159265358979323846};
};

/// `kind = "function-generation"` with a dwell.
struct DwellProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::string mechanism = "six-bar";  ///< `mechanism.type`
  std::vector<Topology> topologies;   ///< at least one; `trace` is the second point of the output
  /// The angle from the first point to the second; or the displacement of a slider along its guide:
  /// the guide's name, then the pin's.
  std::array<std::string, 2> output{"G", "F"};
  std::vector<Dwell> dwells;    ///< one or two, in the order of the crank's turn
  std::optional<double> apart;  ///< of two: by how much their levels differ at least
  double swing_min = 0;         ///< of the output over the turn; a slider has one above 0
  DwellConstraints constraints;
  Solve solve;
  std::optional<ChainMeasure> against{};  ///< of a front; empty: the error alone counts
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
  std::optional<Raster> raster{};
};

/// Whether the output is the displacement of a slider.
bool slides(const DwellProblem& problem);

template <>
struct KindTraits<DwellProblem> {
  static constexpr std::string_view kWord = "function-generation";
  /// Whether a function has dwells.
  static bool takes(reading::TableReader& document);
  static DwellProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const DwellProblem& problem);
  static tl::expected<DwellProblem, std::vector<std::string>> checked(const DwellProblem& problem);
};

struct Result;
struct Run;

/// Designs whose half band, the greatest deviation of the output from its level in a dwell, is
/// least. `Design::error.max` is the half band, radians or a length; `Design::crank_angles` holds
/// where each dwell begins and ends.
Result solve(const DwellProblem& problem, const Run& run);

}  // namespace cognate::problems
