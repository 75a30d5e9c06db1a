/// @file An analysis with its mechanism by joints as drawn.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "problems/evaluation/problem.hpp"
#include "problems/toml/document.hpp"

namespace cognate::problems {

/// The document of `problem` with the joints of its mechanism where they stand at the beginning of
/// the drive, instead of dimensions; masses and loads are the same, the output is the default, and
/// tolerances and layers, which are of dimensions, are left out. A sentence where there is no such
/// drawing: see `drawing_of`; also at a dead point.
tl::expected<reading::Table, std::string> written_as_drawn(const AnalysisProblem& problem);

}  // namespace cognate::problems
