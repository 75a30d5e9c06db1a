/// @file What a mechanism is, by its type and dimensions alone.
#pragma once

#include <vector>

#include "problems/evaluation/result.hpp"

namespace cognate::problems {

/// `class`, `mobility`, and where the type has a closed form `change_point` and
/// `crank_turns_fully`. The class of a four-bar is Grashof's, of a slider-crank, a guide-bar and
/// their inversions which link turns; a double slider has its type's name and a chain the types of
/// its dyads: "RPR+RRP chain". Of a four-bar also `rocker_turns_fully`. `change_point_kind`
/// (analysis/linkage/change_point.hpp) and `moves_as`: of a four-bar with a change point, the
/// motion on which it stands at the drive's `start`.
std::vector<Fact> type_facts(const NamedMechanism& mechanism, double start);

}  // namespace cognate::problems
