/// @file How a cam runs: masses, spring and load in `[follower]`, `[drive]`, `[contact]`.
#pragma once

#include <string>

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads them into `problem`, whose follower is known.
void read_cam_operation(TableReader& document, TableReader& follower, CamProblem& problem);

/// Faults a preload that is left out where it is requested; all of `problem` must have been read.
void check_preload(TableReader& follower, const CamProblem& problem);

/// The keys without which forces, or with `stress` contact stress, of `problem` cannot be known, as
/// a part of a message; empty where they can.
std::string missing_for_forces(const CamProblem& problem, bool stress);

}  // namespace cognate::problems::reading
