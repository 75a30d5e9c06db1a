/// @file What a mechanism with dwells that was found is and whether it satisfies its problem,
/// computed by the evaluator of mechanisms body by body: nothing of the point form that the search
/// uses enters.
#pragma once

#include <vector>

#include "problems/dwell/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// `mechanism`, of the topology, whose dwells begin at the crank angles `starts`, with half bands,
/// swing, transmission angles of each joint over the turn, defects and checks.
Design verified(const DwellProblem& problem, const Topology& topology, NamedMechanism mechanism,
                const std::vector<double>& starts);

}  // namespace cognate::problems
