/// @file What a result reports of its search.
#pragma once

#include <vector>

#include "problems/basics/quantity.hpp"
#include "synthesis/search/statistics.hpp"

namespace cognate::problems {

using synthesis::SearchStatistics;

inline std::vector<Quantity> quantities(const SearchStatistics& statistics) {
  return {{"starts", double(statistics.starts)},
          {"best_hits", double(statistics.best_hits)},
          {"chance_of_unseen_minimum", statistics.unseen}};
}

}  // namespace cognate::problems
