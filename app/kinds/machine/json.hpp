/// @file A machine's problem and its result as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>

#include "problems/machine/result.hpp"

namespace cognate::app {

/// The tables of the file (`kind`, `title`, `mechanism`, `link`, `load`, `gravity`, `equivalent`,
/// `motor`, `flywheel`, `brake`, `run`) under its own keys, with every default written out.
nlohmann::ordered_json to_json(const problems::MachineProblem& problem);

/// What is written as the mechanism of the one design: the file's, or where it has none a table of
/// type "equivalent" with its inertia and torque.
nlohmann::ordered_json machine_mechanism_json(const problems::MachineProblem& problem);

/// The document `cognate-result/1` of a machine, as `schema/cognate-result-1.schema.json`
/// describes: one design, its origin `given`, with the facts as `metrics`, and `machine` with the
/// table of each motion. Values that do not exist are null in a table and missing in `metrics`.
tl::expected<nlohmann::ordered_json, std::string> result_document(
    const problems::MachineProblem& problem, const problems::MachineResult& result,
    std::uint64_t seed);

}  // namespace cognate::app
