/// @file The result document of a cam problem.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>

#include "problems/cam/result.hpp"

namespace cognate::app {

/// The document `cognate-result/1` of a cam problem, as `schema/cognate-result-1.schema.json`
/// describes: as that of linkages, `mechanism` a table of type "cam" that alone gives the design's
/// cam, `crank_deg` empty and `error` 0, since a profile gives its motion exactly; besides `proof`
/// of designs, and `segments` and `jumps` of the motion.
tl::expected<nlohmann::ordered_json, std::string> result_document(
    const problems::CamProblem& problem, const problems::CamResult& result, std::uint64_t seed);

/// The entry of `designs` of the best design, where there is one.
nlohmann::ordered_json best_design_json(const problems::CamProblem& problem,
                                        const problems::CamResult& result);

/// The table `mechanism` of a design: follower, every length it has, the motion with what was found
/// of it, and a preload that was found.
nlohmann::ordered_json mechanism_json(const problems::CamProblem& problem,
                                      const problems::CamDesign& design);

}  // namespace cognate::app
