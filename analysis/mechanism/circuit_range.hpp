/// @file An output over a whole circuit of the mechanism, through all its branches.
#pragma once

#include <functional>
#include <optional>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/travel.hpp"

namespace cognate {

/// How far an output goes on a circuit.
struct CircuitRange {
  double stroke = 0;         ///< a length, or radians: 2π for an output that turns fully
  bool turns_fully = false;  ///< an angle that comes round with another number of turns
};

/// Of the circuit on which `run`, an assembly range of `mechanism`, lies, beyond the ends
/// of its assembly ranges. A drive that turns fully goes through it in one turn, or two
/// where there are change points. Any other goes back and forth between dead points, at each of
/// which a dyad passes to its other assembly, until it comes round. Empty where that is not found:
/// where guides become parallel, and once `stop` says so.
std::optional<CircuitRange> circuit_range(const Mechanism<double>& mechanism,
                                          const AssemblyRange& run, const Travel& travel,
                                          const std::function<bool()>& stop = {});

}  // namespace cognate
