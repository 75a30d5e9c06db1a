/// @file What this version can do, as data: for `cognate list`, for the documents, for the tests.
#pragma once

#include <span>
#include <string_view>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::app {

/// Something that has a name in a file, and what it means in a few words.
struct Entry {
  std::string_view name;
  std::string_view meaning;
};

/// A key under `metrics` of a design, levels separated by dots; `unit` is "1" for pure numbers and
/// empty for words.
struct Metric {
  std::string_view key;
  std::string_view unit;
  std::string_view meaning;
};

/// The values of `kind`.
std::span<const Entry> problem_kinds();

/// The keys of `[solve]`.
std::span<const Entry> solve_options();

/// What `solve.solver = "…"` does.
std::string_view meaning(problems::SolverChoice solver);

/// Every key that may stand under `metrics` of a design that was found.
std::span<const Metric> metrics();

/// Every key that may stand under `facts` of a result.
std::span<const Metric> facts();

/// Every key that may stand under `metrics` of a mechanism that was analysed; what is written in
/// capitals stands for a name of the file's.
std::span<const Metric> analysis_metrics();

/// The columns that an analysis may have, in the same way.
std::span<const Metric> analysis_columns();

}  // namespace cognate::app
