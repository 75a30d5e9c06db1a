#include "problems/study/filter.hpp"

#include <algorithm>

namespace cognate::problems {

bool passes(const StudyFilter& filter, const Cell& value) {
  if (const auto* word = std::get_if<std::string>(&value)) {
    return std::ranges::find(filter.words, *word) != filter.words.end();
  }
  const auto* number = std::get_if<double>(&value);
  return number && filter.words.empty() && *number >= filter.min && *number <= filter.max;
}

}  // namespace cognate::problems
