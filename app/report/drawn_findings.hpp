/// @file Findings of a synthesis other than its designs, for drawing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "problems/linkage/result.hpp"

namespace cognate::app {

/// For each locus its `name` and `branches`, lists of points, thinned to what can be seen.
nlohmann::ordered_json drawn_loci(std::span<const problems::Locus> loci);

/// For each family its `name` and `columns` (`name`, `values`, null where there is none), every row
/// of them or, of very many, some.
nlohmann::ordered_json drawn_families(std::span<const problems::Family> families);

}  // namespace cognate::app
