/// @file Objectives other than the error: how each is measured on a finished design
/// and how it becomes a bound for a search.
#pragma once

#include <optional>
#include <string_view>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The limits of a problem that a measure may tighten.
struct DesignLimits {
  Constraints constraints;
  Bounds bounds;
};

/// A measure as its table says it. Values are in the file's unit, angles in radians.
struct ObjectiveRule {
  DesignObjective measure;
  std::string_view column;  ///< its name in tables of designs, with its unit; in degrees for _deg
  std::string_view words;   ///< in a sentence: "the minimum transmission angle"
  bool greatest_is_best = false;
  double best = 0;  ///< what no design passes
  /// Whether it is a quantity to be added to designs; their metrics have it else.
  bool is_quantity = true;
  double (*value)(const Design& design);
  /// Lets `limits` allow no design worse than `value`; false where they then allow none at all.
  bool (*limit)(DesignLimits& limits, double value);

  /// As tables say it, degrees for angles.
  double shown(double value) const;
};

/// The rule of any measure but the error.
const ObjectiveRule& rule_of(DesignObjective measure);

}  // namespace cognate::problems
