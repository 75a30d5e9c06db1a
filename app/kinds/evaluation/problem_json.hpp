/// @file An analysis file as it was read, with every default filled in, as JSON.
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

/// The tables of the analysis file (`kind`, `title`, `mechanism`, `drive`, `output`, `link`,
/// `load`, `gravity`) under the file's own keys, angles in degrees where the key ends in `_deg`.
/// Links and loads are given in the axes of their bodies, whatever points the file named.
nlohmann::ordered_json to_json(const problems::AnalysisProblem& problem);

}  // namespace cognate::app
