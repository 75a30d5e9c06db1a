/// @file Texts between a page and a kernel: the page requests `room`, writes its question there,
/// and finds the answer, of the length that a call returns, where `text` says.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "problems/toml/fault_list.hpp"

namespace cognate::page {

/// What the page has put there (see document.hpp).
std::string_view question();

/// Puts `answer` there; its length.
int answer_with(const nlohmann::ordered_json& answer);

/// {"faults": the sentences of these}.
nlohmann::ordered_json faults_json(problems::reading::FaultList faults);

}  // namespace cognate::page
