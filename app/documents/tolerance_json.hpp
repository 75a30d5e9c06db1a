/// @file The tolerances of a design as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/tolerance/result.hpp"

namespace cognate::app {

/// `tolerance` of an entry of `designs`, as the schema describes it. What is not known is null.
nlohmann::ordered_json tolerance_json(const problems::ToleranceResult& result);

}  // namespace cognate::app
