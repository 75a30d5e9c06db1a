/// @file From the minima of a search of chains to the designs of its problem, in the file's units
/// and verified.
#pragma once

#include <functional>
#include <vector>

#include "problems/chain/search.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The crank's angles at all targets, radians; those of a timed path follow from the first.
std::vector<double> angles_of_targets(const ChainMinimum& found);

/// Different designs in the order of `found`, at most `options.designs`: of those that meet every
/// limit, or where none does of all. `verify`: the design of a minimum.
std::vector<Design> designs_of_minima(const Solve& options, const std::vector<ChainMinimum>& found,
                                      const std::function<Design(const ChainMinimum&)>& verify);

/// The same of the points of a path. `scale`: that of the search.
std::vector<Design> designs_of_minima(const ChainPathProblem& problem, const TargetScale& scale,
                                      const std::vector<ChainMinimum>& found);

}  // namespace cognate::problems
