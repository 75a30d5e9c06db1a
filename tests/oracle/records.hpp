/// @file The published problems of records.toml.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "problems/kinds.hpp"
#include "problems/linkage/result.hpp"

namespace cognate {

struct PublishedError {
  std::string method;
  double error = 0;  ///< sum of squares
  std::optional<long> evaluations;
};

using RecordedProblem =
    std::variant<problems::PathProblem, problems::FunctionProblem, problems::MotionProblem>;

struct Record {
  std::string name;  ///< stem of the file, and in parentheses what is changed of it
  RecordedProblem problem;
  std::string source;
  /// Sum of squares, or with `largest` the largest error over the domain.
  double best_known = 0;
  bool largest = false;
  bool exact = false;    ///< the target can be met exactly
  bool infimum = false;  ///< the best known error is approached by ever longer links, not reached
  std::vector<PublishedError> published;
};

/// Reads records.toml and its problems; throws what the parser throws, and std::runtime_error where
/// a problem is faulty.
std::vector<Record> read_records();

/// What `design` makes of the error that the record is about.
double recorded_error(const Record& record, const problems::Design& design);

/// Whether `error` reaches the record: within 1e-6 relative (1e-3 of an infimum), or, for exact
/// ones, within 1e-20 of the squared size of the target.
bool reaches(const Record& record, double error);

}  // namespace cognate
