/// @file Which back end a file's `solve.solver` means.
#pragma once

#include <string>

#include "problems/linkage/linkage_limits.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// `auto` is Gauss–Newton: see tests/bench for the evidence.
synthesis::Backend backend_of(SolverChoice choice);

/// The `origin` of a design from where its start came: Gauss–Newton refines every start, and
/// another solver, where the file names one, finishes the best.
std::string search_origin(synthesis::Backend backend, std::string start = "search");

/// What `origin` adds to where a start came from: " + gauss-newton", and another solver.
std::string refined_by(synthesis::Backend backend);

}  // namespace cognate::problems
