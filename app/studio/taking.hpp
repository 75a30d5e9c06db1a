/// @file What is taken along of the studio's last result: files as `cognate export` writes them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/console/options.hpp"

namespace cognate::app {

/// What pages can ask for: {"formats": [word …], "options": [name …], "flags": [name …]}.
nlohmann::ordered_json taking_choices();

/// {"files": [{"name", "text"} …], "notes": [text …], "summary"}, or {"faults": [text …]}, of a
/// design of `result`. `asked` has the options of `cognate export` by their names without dashes:
/// texts or numbers, and true or false of flags. `stem`: of the names of the files.
nlohmann::ordered_json taken(const nlohmann::ordered_json& result,
                             const nlohmann::ordered_json& asked, const std::string& stem,
                             const Options& options);

}  // namespace cognate::app
