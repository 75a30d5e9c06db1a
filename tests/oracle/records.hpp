/// @file The published problems of records.toml.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cognate {

struct PublishedError {
  std::string method;
  double error = 0;  ///< sum of squares
  std::optional<long> evaluations;
};

struct Record {
  std::filesystem::path file;  ///< of the problem
  std::string source;
  double best_known = 0;  ///< sum of squares
  bool exact = false;     ///< the target can be met exactly
  std::vector<PublishedError> published;
};

/// Reads records.toml; throws what the parser throws.
std::vector<Record> read_records();

/// Whether `error` reaches the record: within 1e-6 relative, or, for exact ones, within 1e-20 of
/// the squared size `squared_size` of the target.
bool reaches(const Record& record, double error, double squared_size);

}  // namespace cognate
