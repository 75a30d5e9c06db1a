/// @file `[tolerance]` of an analysis: what it may name, and what it judges.
#pragma once

#include <optional>

#include "problems/evaluation/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems {

namespace reading {

/// The table where the document has one. It may name the dimensions, turning joints and moving
/// points of `mechanism`, of which no tolerance may leave nothing.
std::optional<Tolerances> read_tolerances(TableReader& document, const NamedMechanism& mechanism);

}  // namespace reading

/// Whether what the tolerances of the problem are judged by is an angle: that of the output.
bool judges_angle(const AnalysisProblem& problem);

}  // namespace cognate::problems
