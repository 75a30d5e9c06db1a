/// @file Parts of the result document `cognate-result/1`; kinds/basics/kind.hpp puts them together.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/linkage/result.hpp"

namespace cognate::app {

/// The begin of a document: `format`, `version`, `seed`, `status` and `problem`.
nlohmann::ordered_json document_head(problems::Status status, std::uint64_t seed,
                                     nlohmann::ordered_json problem);

/// What a result says in sentences.
struct Sentences {
  const std::vector<std::string>& notes;
  std::vector<std::string> warnings;
};

/// `document` with `warnings`, `notes` and `work`. The error says which number was NaN or infinite:
/// no such document may be written.
tl::expected<nlohmann::ordered_json, std::string> finished_document(nlohmann::ordered_json document,
                                                                    const Sentences& sentences,
                                                                    const problems::Work& work);

/// The `[mechanism]` table of a mechanism in the file's own terms. Of a chain it holds the tables
/// `pivot`, `crank` or `slider`, `dyad` and `point` too.
nlohmann::ordered_json mechanism_json(const problems::NamedMechanism& mechanism);

/// An entry of `designs`. Errors are in the target's unit, of an `angular` one in radians and
/// also as `rms_deg`, `max_deg`. `cognate_of` and `mirror_of` are indices into `designs` from 0.
/// What has no value is left out, but for `metrics.time_ratio`, which is then null; so are
/// quantities, a condition number and a precision residual that are not finite.
nlohmann::ordered_json design_json(const problems::Design& design, bool angular);

/// `facts` and `certificate` of a synthesis; tables that would be empty are left out.
void add_linkage_facts(nlohmann::ordered_json& document, const problems::Result& result);

/// These and before them `loci` and `families`. A column of a family has null where it has no
/// value; a branch of a locus is broken where a point is not finite.
void add_linkage_findings(nlohmann::ordered_json& document, const problems::Result& result);

/// As `add_quantities`, without those whose number does not exist.
void add_finite_quantities(nlohmann::ordered_json& table,
                           std::vector<problems::Quantity> quantities);

/// An entry of a design's `constraints`, with its name in words, relation and unit
/// (constraint_words.hpp; `angular`: of an output that turns); infinite numbers, which JSON cannot
/// hold, give null.
nlohmann::ordered_json to_json(const problems::ConstraintCheck& check, bool angular = false);

/// The table `work` of a result.
nlohmann::ordered_json to_json(const problems::Work& work);

/// The text of `document`, indented, a list of numbers on one line, with a newline at its end.
/// Reading a number back gives the same double; text that is not UTF-8 has its stray bytes replaced
/// by U+FFFD.
std::string write_json(const nlohmann::ordered_json& document);

}  // namespace cognate::app
