/// @file What evaluating some designs of a study gives.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cognate::problems {

/// One value of a row; none where the design does not have it. Numbers are finite.
using Cell = std::variant<std::monostate, double, std::string>;

/// How a design came out. `invalid`: the base file with its numbers is refused; `filtered`: it does
/// not pass the filters, and what came after the deciding one was not computed.
enum class RunStatus { solved, infeasible, no_solution, invalid, filtered };

/// The rows kept of the designs `first` … `first + count − 1`, by ascending id.
struct StudyBlock {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::int64_t filtered = 0;        ///< designs that did not pass, whether or not kept
  std::vector<std::int64_t> ids;    ///< the numbers of the designs kept
  std::vector<RunStatus> statuses;  ///< one for each row
  std::vector<Cell> cells;          ///< row by row, a value for each of `study_columns`
};

/// Evaluates the designs from `first` on; used by one thread at a time. What it gives of a design
/// depends on nothing but the study, its seed and the design's number. Empty if interrupted.
using BlockEvaluator =
    std::function<std::optional<StudyBlock>(std::int64_t first, std::int64_t count)>;

}  // namespace cognate::problems
