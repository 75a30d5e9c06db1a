#include "problems/study/study.hpp"

#include <algorithm>

namespace cognate::problems {

std::int64_t design_count(const Study& study) {
  std::int64_t count = study.samples;
  for (const StudyVariable& variable : study.variables) {
    if (!variable.range) count *= static_cast<std::int64_t>(variable.values.size());
  }
  return count;
}

std::vector<std::string> study_columns(const Study& study) {
  std::vector<std::string> columns;
  for (const StudyVariable& variable : study.variables) columns.push_back(variable.key);
  columns.insert(columns.end(), study.metrics.begin(), study.metrics.end());
  return columns;
}

}  // namespace cognate::problems
