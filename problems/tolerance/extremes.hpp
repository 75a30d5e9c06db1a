/// @file Exact worst cases of a quantity over its positions.
#pragma once

#include <cstddef>
#include <span>

#include "analysis/tolerance/sensitivity.hpp"
#include "problems/tolerance/figures.hpp"
#include "synthesis/bounds/interval.hpp"

namespace cognate::problems {

/// Sets `low`, `high` and `worst_exact` of the figures of quantity `q`: of scalars at every
/// position; of points where the distance is greatest, found by bounds of it at all positions.
/// Where one position has none, the figures are not `exact`.
void set_extremes(const AffineMechanism& mechanism, const ToleranceQuestion& question,
                  std::size_t q, std::span<const synthesis::Interval> box,
                  const SensitivityTable& table, ToleranceFigures& figures);

}  // namespace cognate::problems
