/// @file The designs that a search of chains found, as its answer.
#pragma once

#include <vector>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Those of `designs`, best first, that meet every limit, or where none does all; of these the
/// first `most`.
std::vector<Design> feasible_or_all(std::vector<Design> designs, int most);

/// How the search that found these ended.
Status status_of(const std::vector<Design>& designs, const Deadline& deadline);

}  // namespace cognate::problems
