/// @file The report of a study: one HTML page that shows its rows.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/study/rows.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// Where the base file analyses a four-bar: its dimensions by their keys in the file, each a number
/// or, where it is varied, {"variable": index}; and under "start" where the drive starts, in
/// radians. Empty for any other base.
std::optional<nlohmann::ordered_json> study_linkage(const problems::Study& study);

/// The columns with their values, the rows' numbers, how they came out and which are best; the base
/// file in pieces; the linkage where the base is a four-bar. Varied numbers are whole, metrics
/// have nine digits; a value that a row lacks is null, or index −1.
nlohmann::ordered_json study_report_data(const problems::Study& study, const StudyRows& rows);

/// The indices of the rows drawn, ascending: all, or as many as a page can hold, the best first and
/// of the others an even selection.
std::vector<std::size_t> drawn_study_rows(const StudyRows& rows);

/// A whole HTML page that opens from disk and loads nothing: `document` (the `cognate-study/1`
/// summary), the columns of `rows`, and what it takes to write the file of each design and, where
/// the base is a four-bar, to draw it. Of very many rows the best and an even selection of the
/// others are kept. Text of the user's cannot become markup. `database`: the name of the file of
/// rows, which commands on the page name; empty: beside the report, under its name.
std::string study_report_html(const nlohmann::ordered_json& document, const problems::Study& study,
                              const StudyRows& rows, std::string_view database = {});

}  // namespace cognate::app
