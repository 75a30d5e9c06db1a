/// @file The tolerances of least cost that keep the judged error within a limit.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "analysis/tolerance/sensitivity.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/figures.hpp"
#include "synthesis/tolerance/allocation.hpp"

namespace cognate::problems {

/// For each dimension that has a tolerance in the file, whose size there is not used. To first
/// order: the worst case, or the root sum of squares with the nominal error added.
void add_allocation(const TolerancedMechanism& toleranced, const Tolerances& tolerances,
                    const ToleranceQuestion& question, std::size_t judged,
                    const SensitivityTable& table, ToleranceResult& result);

/// What tolerances are allocated to.
struct AllocatedCosts {
  std::span<const TolerancedDimension> dimensions;
  std::vector<double> costs;      ///< of each, what the tolerance ±1 costs
  std::vector<double> influence;  ///< of each: the greatest rate of the error with it
};

/// The demand that is missed most by given tolerances of all dimensions, or is nearest to it.
using WorstDemand = std::function<synthesis::ToleranceDemand(const std::vector<double>&)>;

/// Sets the tolerances of least cost and what they cost. Of a dimension without influence the
/// tolerance is infinite, which a note says; so does one where none has influence.
void allocate(const AllocatedCosts& to, const WorstDemand& worst, int power,
              ToleranceResult& result);

}  // namespace cognate::problems
