/// @file The lengths of a cam: `[mechanism]`, `[bounds]`, and some in `[follower]`.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The tables in which the lengths of a cam stand.
struct CamLengthTables {
  TableReader& follower;
  TableReader& mechanism;
  TableReader& bounds;
};

/// Reads `problem.lengths` of the follower, which is known, and faults lengths that it has no use
/// for or that lie outside their bounds.
void read_cam_lengths(CamLengthTables& tables, CamProblem& problem);

/// Faults lengths given that cannot be put together, or not through all of the motion.
void check_cam_assembly(CamLengthTables& tables, const CamProblem& problem);

}  // namespace cognate::problems::reading
