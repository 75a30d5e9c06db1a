/// @file What the report page of a machine shows beside the result document, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/machine/result.hpp"

namespace cognate::app {

/// The table of each motion, with the rows thinned that cannot be seen, the quantities, and the
/// mechanism over a turn of its drive (null where the file gives none). Numbers that are only drawn
/// are rounded to seven significant digits.
nlohmann::ordered_json machine_report_data(const problems::MachineProblem& problem,
                                           const problems::MachineResult& result);

}  // namespace cognate::app
