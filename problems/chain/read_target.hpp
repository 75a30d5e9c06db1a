/// @file `[target]` of chains: points or a closed curve, and their timing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The points, whether they are closed, and their crank angles. Drawings are looked for in
/// `folder`; without one they are refused. `target.point` is left to the caller.
void read_chain_target(TableReader& target, const std::filesystem::path& folder,
                       ChainPathProblem& problem);

/// Targets that may be timed.
struct TimedTargets {
  std::size_t count;
  bool closed, drops_end;  ///< whether the last, the first again, was left out: its angle is too
  std::string_view noun, whole;  ///< "point" of a "path"
};

/// `target.timing` and `target.crank_deg`, radians; empty where the timing is free.
std::vector<double> read_chain_timing(TableReader& target, const TimedTargets& of);

}  // namespace cognate::problems::reading
