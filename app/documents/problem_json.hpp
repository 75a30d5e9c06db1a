/// @file A problem as it was read, with every default filled in, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/cam/problem.hpp"
#include "problems/gear/problem.hpp"
#include "problems/kinds.hpp"

namespace cognate::app {

/// The tables of the problem file (`kind`, `title`, `target`, `mechanism`, `bounds`, `constraints`,
/// `solve`) under the file's own keys, angles in degrees where the key ends in `_deg`. A default
/// that stands for a value is written out; what has no value (a free length, an unlimited bound) is
/// left out. Limits of `bounds.length` appear at each of the four links.
nlohmann::ordered_json to_json(const problems::Problem& problem);

/// The same of a cam: `follower`, `motion` (an array of tables), `mechanism`, `bounds`, `target`,
/// `constraints`, and, where the file has them, `drive` and `contact`. A segment's angle or share
/// that is free is a range.
nlohmann::ordered_json to_json(const problems::CamProblem& problem);

/// The same of a gear, `mechanism`, `rack` and `output`, and of a pair, besides `bounds`, `target`,
/// `constraints` and `solve` where it is one that can be searched for.
nlohmann::ordered_json to_json(const problems::GearProblem& problem);
nlohmann::ordered_json to_json(const problems::GearPairProblem& problem);

}  // namespace cognate::app
