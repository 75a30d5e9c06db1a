/// @file The least and greatest transmission angle of a dyad over the assembly ranges of a motion.
#pragma once

#include <optional>

#include "analysis/mechanism/assembly_ranges.hpp"

namespace cognate {

/// A transmission angle μ in [0, π] (as DyadClosure has it) and where it stands.
struct AngleAt {
  double drive = 0;
  double angle = 0;
};

/// Extremes of μ. The pressure angle of a slider is |π/2 − μ|; the acute form of μ is least at one
/// of the two.
struct TransmissionExtremes {
  AngleAt least;
  AngleAt greatest;

  double acute_least() const;        ///< the least of min(μ, π − μ)
  double greatest_pressure() const;  ///< the greatest of |π/2 − μ|
};

/// Of dyad `dyad`: at ends of ranges, or where dμ/dq = 0, refined to rounding. Empty where nothing
/// of the assembly ranges can be assembled.
std::optional<TransmissionExtremes> transmission_extremes(const Mechanism<double>& mechanism,
                                                          const AssemblyRanges& assembly_ranges,
                                                          int dyad);

}  // namespace cognate
