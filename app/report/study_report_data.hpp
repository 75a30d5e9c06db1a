/// @file What the page of a study draws.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/study/rows.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// The columns with their values, the rows' numbers, how they came out and which are best; the base
/// file in pieces; the linkage where the base is a four-bar. Varied numbers are whole, metrics
/// have nine digits; a value that a row lacks is null, or index −1.
nlohmann::ordered_json study_report_data(const problems::Study& study, const StudyRows& rows);

/// The indices of the rows drawn, ascending: all, or as many as a page bears, the best first and of
/// the others an even selection.
std::vector<std::size_t> drawn_study_rows(const StudyRows& rows);

}  // namespace cognate::app
