/// @file What a leg that was found is and whether it satisfies its problem, computed by the
/// evaluator of mechanisms body by body: nothing of the point form that the search uses enters.
#pragma once

#include <optional>

#include "analysis/mechanism/gait.hpp"
#include "problems/leg/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// How the foot of `mechanism`, of the topology, walks at the duty factor `duty`; see `gait`.
std::optional<Gait> foot_gait(const Topology& topology, const NamedMechanism& mechanism,
                              double duty);

/// `mechanism`, of the topology, with its gait at the duty factor `duty`, transmission angles of
/// each joint over the turn, defects and checks. Its errors are infinite where it has no gait.
Design verified(const LegProblem& problem, const Topology& topology, NamedMechanism mechanism,
                double duty);

}  // namespace cognate::problems
