/// @file What a kind of problem says of itself, beside its problem.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace cognate::problems {

namespace reading {
class TableReader;
struct Written;
}  // namespace reading

/// Of each kind of problem:
/// - `kWord`, how files write it, `kind = "…"`;
/// - where it shares that word with a kind before it, `takes(document)`, whether a document is its
///   own and not of the other;
/// - `read(document, folder)`, the problem in a file's tables, complete if no fault was added to
///   them; files that it names are looked for in `folder`, there are none where that is empty;
/// - `written(problem)`, the tables of which `read` makes it, with every default filled in, in the
///   order in which results show them;
/// - `checked(problem)`, the problem with what may be left empty filled in, as the reader fills it
///   in; or its faults.
template <class Problem>
struct KindTraits;

/// Everything that is wrong with `problem`, as the reader of files would say it; empty where it is
/// valid. Of an invalid problem nothing is computed: its faults are notes beside Status::invalid.
template <class Problem>
std::vector<std::string> validate(const Problem& problem) {
  auto checked = KindTraits<Problem>::checked(problem);
  return checked ? std::vector<std::string>{} : std::move(checked.error());
}

}  // namespace cognate::problems
