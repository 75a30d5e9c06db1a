/// @file `[raster]`: which dimensions of a design take single values only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/basics/range.hpp"
#include "synthesis/raster/values.hpp"

namespace cognate::problems {

/// The values that a dimension, or each of a group, may take: multiples of `step`, or `values`;
/// without either any value.
struct RasterRule {
  std::optional<double> step;
  std::vector<double> values;

  bool is_free() const { return !step && values.empty(); }
};

/// `[raster]`.
struct Raster {
  static constexpr int kBoxes = 20'000;

  std::vector<std::pair<std::string, RasterRule>> rules;  ///< by key, as the file has them
  int boxes = kBoxes;                                     ///< that branch and bound may examine

  /// What holds for dimension `key` of the group `group`, which may be empty: its own key, else its
  /// group's, else `length`; null where any value will do.
  const RasterRule* rule(std::string_view key, std::string_view group = {}) const;
  /// Whether the file has that very key.
  bool has(std::string_view key) const;
};

/// The values of `rule` within `range`, its ends kept to rounding. Infinite ends are replaced by
/// `reach`, which is finite.
synthesis::RasterValues values_within(const RasterRule& rule, const Range& range,
                                      const Range& reach);

}  // namespace cognate::problems
