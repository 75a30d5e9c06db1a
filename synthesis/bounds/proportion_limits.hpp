/// @file Limits of lengths and of the transmission angle over a box of proportions.
#pragma once

#include <array>

#include "synthesis/bounds/proportion_box.hpp"

namespace cognate::synthesis {

/// Limits of crank, coupler, rocker and frame, in one unit of length.
struct LengthLimits {
  std::array<double, 4> least{};
  std::array<double, 4> greatest{};  ///< possibly infinite
};

/// Between which lengths the crank may be where the four lengths satisfy `limits`: `low` and
/// `high`. False where that is impossible.
bool crank_range(const ProportionRanges& ranges, const LengthLimits& limits, double& low,
                 double& high);

/// Further conditions on the linkages.
struct ProportionLimits {
  enum class Class { any, grashof, non_grashof, rocker_shortest, coupler_shortest };
  Class required = Class::any;  ///< beyond what the box's `Proportions` ensure
  double greatest_ratio = 0;    ///< of the longest link to the shortest
  /// Limits of the transmission angle: over the full turn, or where the crank does not turn fully
  /// at the points alone, which is a weaker demand than the file's.
  double transmission_min = 0, transmission_max = 0;
};

/// Whether a linkage of the box may satisfy `limits`, as far as link lengths alone say.
bool may_satisfy(const ProportionRanges& ranges, const ProportionLimits& limits, bool turning);

/// Whether the transmission angle may satisfy its lower limit where d is in `least`, to its upper
/// limit where it is in `greatest`.
bool may_transmit(const ProportionRanges& ranges, const ProportionLimits& limits,
                  const Interval& least, const Interval& greatest);

}  // namespace cognate::synthesis
