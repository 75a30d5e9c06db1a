/// @file What a kind of problem says of itself, beside its problem.
#pragma once

#include <filesystem>
#include <string_view>

namespace cognate::problems {

namespace reading {
class TableReader;
}

/// Of each kind of problem:
/// - `kWord`, how files write it, `kind = "…"`;
/// - `read(document, folder)`, the problem in a file's tables, complete if no fault was added to
///   them; files that it names are looked for in `folder`, there are none where that is empty;
/// - `checked(problem)`, the problem with what may be left empty filled in, as the reader fills it
///   in; or its faults.
template <class Problem>
struct KindTraits;

}  // namespace cognate::problems
