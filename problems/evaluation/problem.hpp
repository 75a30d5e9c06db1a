/// @file What an analysis file (`kind = "analysis"`) says, as values. Angles are in radians.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "analysis/mechanism/forces.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/layers/layers.hpp"
#include "problems/mechanism/load_rule.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// `[drive]`: `steps` equal steps from `start` to `end`, both included (`steps` + 1 rows). For a
/// driving slider the coordinate is a length, else an angle from the x axis.
struct DriveSweep {
  double start = 0;
  double end = 0;
  int steps = 360;
  DriveRate rate;
};

/// `[output]`: what is requested; what is not is not computed.
struct AnalysisOutput {
  bool position = true;
  bool velocity = true;
  bool acceleration = true;
  bool transmission = true;
  bool curvature = false;  ///< of the paths of the named points, and their landmarks
  bool reactions = false;
  bool torque = false;
  std::vector<int> points;  ///< indices of the named points to report; all that move when empty
  std::vector<int> instant_geometry;  ///< the bodies whose poles and circles are requested
  bool curve = false;                 ///< measures of a four-bar's coupler curve over its circuit
  bool cognates = false;              ///< Roberts' cognates of a four-bar with a coupler point
  std::optional<int> foot{};          ///< index of the named point whose gait is measured
  std::optional<double> duty{};       ///< its duty factor; empty: see analysis/mechanism/gait.hpp
};

/// `kind = "analysis"`.
struct AnalysisProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  NamedMechanism mechanism;
  DriveSweep drive;
  AnalysisOutput output;
  std::vector<Inertia> inertias;  ///< one for each body; all zero where the file gives none
  std::vector<LoadRule> loads;
  Vec2d gravity{};
  std::optional<Tolerances> tolerances{};
  std::optional<LayerSizes> layers{};
};

template <>
struct KindTraits<AnalysisProblem> {
  static constexpr std::string_view kWord = "analysis";
  static AnalysisProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const AnalysisProblem& problem);
  static tl::expected<AnalysisProblem, std::vector<std::string>> checked(
      const AnalysisProblem& problem);
};

/// Whether it has masses or loads, so that forces are computed.
inline bool has_forces(const AnalysisProblem& problem) {
  return !problem.loads.empty() ||
         std::ranges::any_of(problem.inertias, [](const Inertia& inertia) {
           return inertia.mass > 0 || inertia.moment > 0;
         });
}

/// Whether what drives the mechanism is a slider rather than a crank.
inline bool drive_slides(const AnalysisProblem& problem) {
  return driven_by_length(problem.mechanism.mechanism.drive);
}

}  // namespace cognate::problems
