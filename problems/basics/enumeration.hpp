/// @file Words in a row, as a sentence has them.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

namespace cognate::problems {

/// "a", "a and b", "a, b and c"; empty of no words.
inline std::string enumeration(std::span<const std::string> words) {
  if (words.size() < 2) return words.empty() ? std::string() : words.front();
  const auto all_but_last = words.first(words.size() - 1);
  return fmt::format("{} and {}", fmt::join(all_but_last, ", "), words.back());
}

}  // namespace cognate::problems
