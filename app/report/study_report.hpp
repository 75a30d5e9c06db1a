/// @file The report of a study: one HTML page that shows its rows.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/rows.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// A whole HTML page that opens from disk and loads nothing: `document` (the `cognate-study/1`
/// summary), the columns of `rows`, and what it takes to write the file of each design and, where
/// the base is a four-bar, to draw it. Of very many rows the best and an even selection of the
/// others are kept. Text of the user's cannot become markup.
std::string study_report_html(const nlohmann::ordered_json& document, const problems::Study& study,
                              const StudyRows& rows);

}  // namespace cognate::app
