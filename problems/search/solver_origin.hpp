/// @file How the `origin` of a design names the solvers that made it.
#pragma once

#include <initializer_list>
#include <string>

#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// The `origin` of a design from where its start came: Gauss–Newton refines every start, and
/// another solver, where the file names one, finishes the best.
std::string search_origin(synthesis::Solver solver, std::string start = "search");

/// The `origin` of a design that these solvers, one after the other, made of the starts of a
/// search.
std::string search_origin(std::initializer_list<synthesis::Solver> solvers);

/// What `origin` adds to where a start came from: " + gauss-newton", and another solver.
std::string refined_by(synthesis::Solver solver);

}  // namespace cognate::problems
