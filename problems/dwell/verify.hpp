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

/// The output at equal steps of a turn and at its end, followed through whole turns, radians or a
/// length; empty where the mechanism is not assembled at one of them.
std::vector<double> output_over_turn(const DwellProblem& problem, const NamedMechanism& mechanism,
                                     int steps);

/// Half of the band of the output in `dwell` where that begins at the crank angle `start`.
double half_band(const DwellProblem& problem, const NamedMechanism& mechanism, const Dwell& dwell,
                 double start);

}  // namespace cognate::problems
