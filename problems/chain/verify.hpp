/// @file What a chain that was found is and whether it satisfies its problem, computed by the
/// evaluator of mechanisms body by body: nothing of the point form that the search uses enters.
#pragma once

#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// `mechanism`, of the topology, with its errors at the crank angles `angles` (one for each target,
/// in order), the transmission angles of each joint over the motion limited, defects and checks.
Design verified(const ChainPathProblem& problem, const Topology& topology, NamedMechanism mechanism,
                const std::vector<double>& angles);

}  // namespace cognate::problems
