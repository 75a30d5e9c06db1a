/// @file `[follower]`: its type and what presses it on the cam.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// "a translating roller", for messages.
std::string_view in_words(cam::FollowerType type);

/// Whether a second roller stands on the other side of the cam, on the same line.
bool has_opposite_roller(const CamProblem& problem);

/// The keys `type`, `side`, `closure`, `breadth` and `arms_deg`. False, with a fault, where there
/// is no type, without which little can be said of the other tables.
bool read_follower(TableReader& follower, CamProblem& problem);

}  // namespace cognate::problems::reading
