/// @file The mechanism of a file, its links and loads, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/evaluation/problem.hpp"

namespace cognate::app {

/// The `[mechanism]` table of a mechanism in the file's own terms. Of a chain it holds the tables
/// `pivot`, `crank` or `slider`, `dyad` and `point` too.
nlohmann::ordered_json mechanism_json(const problems::NamedMechanism& mechanism);

/// The tables `[[link]]` of a problem, and one of its `[[load]]`, in the axes of their bodies.
nlohmann::ordered_json links_json(const problems::AnalysisProblem& problem);
nlohmann::ordered_json load_json(const problems::AnalysisProblem& problem,
                                 const problems::LoadRule& load);

}  // namespace cognate::app
