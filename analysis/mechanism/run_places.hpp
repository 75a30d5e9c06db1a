/// @file Places at which a range of the drive is looked at.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {

/// Parts of the drive's scale that rounding leaves no places in.
inline constexpr double kNoWidth = 64 * std::numeric_limits<double>::epsilon();

/// Places over `run` of `assembly_ranges` in order, both ends included: crowded towards its ends,
/// and to rounding towards dead points, next to which a quantity that goes with the root of the
/// distance may yet turn back.
inline std::vector<double> run_places(const AssemblyRanges& assembly_ranges,
                                      const AssemblyRange& run) {
  std::vector<double> all = crowded(run.from, run.to, assembly_ranges.cells(run));
  const double least = kNoWidth * assembly_ranges.scale;
  const auto crowd = [&](double end, double next) {
    for (double step = (next - end) / 4; std::abs(step) > least; step /= 4) {
      all.push_back(end + step);
    }
  };
  const double second = all[1], last_but_one = all[all.size() - 2];
  if (run.from_dyad >= 0) crowd(run.from, second);
  if (run.to_dyad >= 0) crowd(run.to, last_but_one);
  std::ranges::sort(all);
  return all;
}

}  // namespace cognate
