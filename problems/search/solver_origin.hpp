/// @file How the `origin` of a design names the solvers that made it.
#pragma once

#include <string>

#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// The `origin` of a design from where its start came: Gauss–Newton refines every start, and
/// another solver, where the file names one, finishes the best.
std::string search_origin(synthesis::Solver solver, std::string start = "search");

/// What `origin` adds to where a start came from: " + gauss-newton", and another solver.
std::string refined_by(synthesis::Solver solver);

}  // namespace cognate::problems
