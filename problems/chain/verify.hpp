/// @file What a chain that was found is and whether it satisfies its problem, computed by the
/// evaluator of mechanisms body by body: nothing of the point form that the search uses enters.
#pragma once

#include <optional>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// How far the curve strays between the targets, root mean square, where it does.
inline constexpr QuantityKey<double> kStrayKey{"stray_between_points"};

/// `mechanism`, of the topology, with its errors at the crank angles `angles` (one for each target,
/// in order), the transmission angles of each joint over the motion limited, defects and checks.
/// `placement`: of a target that may be moved; errors are in the target's own unit.
Design verified(const ChainPathProblem& problem, const Topology& topology, NamedMechanism mechanism,
                const std::vector<double>& angles,
                const std::optional<CurvePlacement>& placement = std::nullopt);

/// Transmission angles over `motion`: of each joint as a quantity, and the extremes of all.
void measure_transmission(const Topology& topology, const NamedMechanism& mechanism,
                          const AssemblyRanges& motion, Metrics& metrics);

/// The check of a limit in radians against these extremes; none where it limits nothing.
void check_transmission(const Range& limit, Design& design);

/// Whether the chain is assembled all along `motion`, over a turn of a three-pin link back to where
/// it began.
void check_circuit(const Topology& topology, const NamedMechanism& mechanism,
                   const AssemblyRanges& motion, Design& design);

}  // namespace cognate::problems
