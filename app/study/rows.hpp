/// @file Rows of a study as its report draws them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "problems/study/block.hpp"

namespace cognate::app {

/// All rows kept, or where these are many the best and an even selection of the others.
struct StudyRows {
  std::vector<std::string> columns;  ///< as `problems::study_columns`
  std::vector<std::int64_t> ids;     ///< ascending
  std::vector<problems::RunStatus> statuses;
  std::vector<bool> best;  ///< on the front of several objectives, or among the first of one
  std::vector<problems::Cell> cells;  ///< row by row
  std::int64_t total = 0;             ///< how many rows the study holds
};

}  // namespace cognate::app
