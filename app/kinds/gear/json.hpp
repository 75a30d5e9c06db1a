/// @file The result documents of a gear and of gear pairs.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>

#include "problems/gear/result.hpp"

namespace cognate::app {

/// The document `cognate-result/1` of a gear: one design, its `mechanism` a table of type "gear",
/// and `gear` with the columns of its flank.
tl::expected<nlohmann::ordered_json, std::string> result_document(
    const problems::GearProblem& problem, const problems::GearResult& result, std::uint64_t seed);

/// That of gear pairs, each design's `mechanism` a table of type "gear-pair" with all that gives
/// the pair, and `facts` of the search.
tl::expected<nlohmann::ordered_json, std::string> result_document(
    const problems::GearPairProblem& problem, const problems::GearPairResult& result,
    std::uint64_t seed);

/// The entry of `designs` of the gear, and of the best pair where there is one (with the `facts` of
/// the search).
nlohmann::ordered_json best_design_json(const problems::GearProblem& problem,
                                        const problems::GearResult& result);
nlohmann::ordered_json best_design_json(const problems::GearPairProblem& problem,
                                        const problems::GearPairResult& result);

/// The tables `mechanism` of these.
nlohmann::ordered_json mechanism_json(const problems::GearProblem& problem);
nlohmann::ordered_json mechanism_json(const problems::GearPairDesign& design);

}  // namespace cognate::app
