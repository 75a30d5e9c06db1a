/// @file The result document `cognate-result/1`.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/kinds.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// The document `cognate-result/1` of a run: `format`, `version`, `seed`, `status`, `problem`,
/// `designs` (best first), `loci`, `families`, `facts`, `certificate`, `notes`, `work`, as
/// `schema/cognate-result-1.schema.json` describes. Angles are in degrees under keys that end in
/// `_deg`; errors are in the target's unit, for function generation in radians and besides as
/// `rms_deg`, `max_deg`. `cognate_of` and `mirror_of` are indices into `designs` from 0. What has
/// no value is left out, but for `metrics.time_ratio`, which is then null; so are facts, a
/// condition number and a precision residual that are not finite. A column of a family has null
/// where it has no value; a branch of a locus is broken where a point is not finite.
///
/// The error says which number was NaN or infinite: no such document may be written.
tl::expected<nlohmann::ordered_json, std::string> result_document(const problems::Problem& problem,
                                                                  const problems::Result& result,
                                                                  std::uint64_t seed);

/// The entry of `designs` of the best design, where there is one, and what the result tells in
/// single numbers (`facts`, `certificate`). Numbers that are not finite may be among them.
nlohmann::ordered_json best_design_json(const problems::Problem& problem,
                                        const problems::Result& result);

/// As `add_facts`, without those whose number does not exist.
void add_finite_facts(nlohmann::ordered_json& table, std::vector<problems::Fact> facts);

/// An entry of a design's `constraints`; infinite numbers, which JSON cannot hold, give null.
nlohmann::ordered_json to_json(const problems::ConstraintCheck& check);

/// The table `work` of a result.
nlohmann::ordered_json to_json(const problems::Work& work);

/// The text of `document`, indented, a list of numbers on one line, with a newline at its end.
/// Reading a number back gives the same double; text that is not UTF-8 has its stray bytes replaced
/// by U+FFFD.
std::string write_json(const nlohmann::ordered_json& document);

}  // namespace cognate::app
