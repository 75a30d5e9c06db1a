/// @file Problems of exact function generation and what their results say.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "problems/function/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::exact_functions {

inline FunctionProblem parsed(const std::string& text) {
  const auto problem = parse_task(text);
  if (!problem) throw std::invalid_argument(problem.error().front().message);
  return std::get<FunctionProblem>(*problem);
}

inline FunctionProblem from_library(const char* name) {
  const auto problem = read_task(std::filesystem::path(kLibraryFolder) / "function" / name);
  if (!problem) throw std::invalid_argument(problem.error().front().message);
  return std::get<FunctionProblem>(*problem);
}

inline std::string pairs_file(const std::string& rows, const std::string& more) {
  return "kind = \"function-generation\"\n[target]\npairs_deg = " + rows + "\n" + more;
}

inline bool says(const Result& result, const std::string& part) {
  return std::ranges::any_of(
      result.notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

}  // namespace cognate::problems::exact_functions
