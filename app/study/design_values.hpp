/// @file What a design of a study has, by name.
#pragma once

#include <atomic>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/read.hpp"
#include "problems/study/block.hpp"
#include "problems/study/metric_names.hpp"

namespace cognate::app {

/// What a design came out as, and a value for each name requested.
struct DesignOutcome {
  problems::RunStatus status = problems::RunStatus::no_solution;
  std::vector<problems::Cell> values;
};

/// Solves or analyses `task` on one thread and takes `names` from its best design, asking an
/// analysis for nothing else. Empty if interrupted.
std::optional<DesignOutcome> evaluate(const problems::Task& task,
                                      const std::vector<std::string>& names, std::uint64_t seed,
                                      const std::atomic<bool>* interrupted);

/// The value under `name` in `table`, "a.b[0]" being entry 0 of b in a: a finite number, a word,
/// "true" or "false"; of a list of words all of them, "none" where it is empty. Nothing else is a
/// value.
problems::Cell value_at(const nlohmann::ordered_json& table, std::string_view name);

/// What an analysis is requested whose rows are of no interest: nothing.
problems::AnalysisOutput no_columns();

/// Appends the names, as `value_at` reads them, of all numbers and words within `value`, whose own
/// name is `name`.
void add_values(std::vector<problems::MetricName>& names, const nlohmann::ordered_json& value,
                const std::string& name);

}  // namespace cognate::app
