/// @file `[target]` of chains: points or a closed curve, and their timing.
#pragma once

#include <filesystem>

#include "problems/chain/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The points, whether they are closed, and their crank angles. Drawings are looked for in
/// `folder`; without one they are refused. `target.point` is left to the caller.
void read_chain_target(TableReader& target, const std::filesystem::path& folder,
                       ChainPathProblem& problem);

}  // namespace cognate::problems::reading
