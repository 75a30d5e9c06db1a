/// @file What `kind = "function-generation"` specifies where the mechanism is a longer chain than a
/// four-bar. Angles are in radians, lengths in the file's unit.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/chain/front/measure.hpp"
#include "problems/chain/problem.hpp"
#include "problems/chain/topology.hpp"
#include "problems/function/problem.hpp"
#include "problems/layers/layers.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// `[constraints]` of functions of chains.
struct ChainFunctionConstraints {
  /// Of every dyad that is a joint, radians; the narrower side counts.
  Range transmission_angle{0, 3.14159265358979323846};
  /// Where the mechanism is assembled and its transmission angles are limited: while the function
  /// is generated, or over the whole turn of the crank.
  LimitSpan over = LimitSpan::range;
  std::optional<ErrorLimit> error{};  ///< of what is minimised
};

/// `kind = "function-generation"` with a chain as its mechanism: an angle of the output, or the
/// displacement of a slider, that is a function of the crank's angle.
struct ChainFunctionProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  std::string mechanism = "six-bar";  ///< `mechanism.type`
  std::vector<Topology> topologies;   ///< at least one; `trace` is the second point of the output
  /// The angle from the first point to the second; or the displacement of a slider along its guide:
  /// the guide's name, then the pin's.
  std::array<std::string, 2> output{"G", "F"};
  std::variant<FunctionOfX, AnglePairs> target;
  FunctionObjective objective = FunctionObjective::least_squares;  ///< or minimax
  std::vector<double> sample_at;  ///< sample abscissae in x; empty for angle pairs
  ChainFunctionConstraints constraints;
  Solve solve;
  std::optional<ChainMeasure> against{};  ///< of a front; empty: the error alone counts
  WarningLimits warnings{};
  std::optional<Tolerances> tolerances{};
  std::optional<DesignLayers> layers{};
};

/// Whether the output is the displacement of a slider.
bool slides(const ChainFunctionProblem& problem);

template <>
struct KindTraits<ChainFunctionProblem> {
  static constexpr std::string_view kWord = "function-generation";
  /// Whether the mechanism of a function is a longer chain than a four-bar.
  static bool takes(reading::TableReader& document);
  static ChainFunctionProblem read(reading::TableReader& document,
                                   const std::filesystem::path& folder);
  static reading::Written written(const ChainFunctionProblem& problem);
  static tl::expected<ChainFunctionProblem, std::vector<std::string>> checked(
      const ChainFunctionProblem& problem);
};

struct Result;
struct Run;

/// Designs whose output errs least from the function, its start angles being free.
/// `Design::error` is in radians, or in the file's unit where a slider is the output, at the
/// samples; `max` also between them. The same problem and
/// seed give the same designs for any number of threads.
Result solve(const ChainFunctionProblem& problem, const Run& run);

}  // namespace cognate::problems
