/// @file The report: one HTML page that shows a result.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cognate::app {

/// `page` (of page.hpp) with `data` and `result_document`, which is embedded as it is but for
/// tables, curves and lists of segments that would make the page too large. Text of the user's
/// cannot become markup.
std::string report_page(std::string page, nlohmann::ordered_json data,
                        const nlohmann::ordered_json& result_document);

}  // namespace cognate::app
