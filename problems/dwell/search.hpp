/// @file The search for mechanisms whose output dwells.
#pragma once

#include <limits>
#include <vector>

#include "problems/dwell/model.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// A minimum, in the unit of its space.
struct DwellMinimum {
  const DwellSpace* space = nullptr;
  DwellDesign design;
  double half_band = 0;  ///< radians, or units of the space
  double violation = 0;  ///< of the constraints, as they are scaled in the model
};

/// Violations of the constraints up to this are none.
inline constexpr double kDwellFeasibility = 1e-7;

/// Where a minimax fit ended.
struct DwellFit {
  DwellDesign design;
  double half_band = std::numeric_limits<double>::infinity();
  double violation = std::numeric_limits<double>::infinity();
};

/// A fit from `start` within the bounds of `space`, its free parameters and the starts of dwells
/// that are not given being sought. `is_final`: with as many nodes as finished designs have.
DwellFit fit_dwell(const DwellSpace& space, const DwellDesign& start, bool is_final,
                   const Deadline& deadline);

struct DwellSearchResult {
  std::vector<DwellMinimum> designs;  ///< best first; different ones
  synthesis::SearchStatistics statistics;
};

/// Minimax fits from starts whose dyad of the output is joined to a point that moves along a circle
/// while the output dwells, then from disturbed good designs: the valleys are curved and narrow.
DwellSearchResult search_dwells(const std::vector<DwellSpace>& spaces, const Solve& options,
                                const Run& run, const Deadline& deadline, Work& work);

}  // namespace cognate::problems
