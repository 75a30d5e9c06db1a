/// @file Machines of texts, and what is reported of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "problems/machine/result.hpp"
#include "problems/read.hpp"

namespace cognate::test {

/// The machine of `text`, the file's first line left out.
inline problems::MachineProblem parse(const std::string& text) {
  const auto problem =
      problems::parse_task<problems::MachineProblem>("kind = \"machine\"\n" + text);
  if (problem) return *problem;
  for (const problems::Fault& fault : problem.error()) {
    ADD_FAILURE() << fault.line << ":" << fault.column << ": " << fault.message;
  }
  return {};
}

inline problems::MachineResult result_of(const std::string& text) {
  return problems::run_machine(parse(text), {});
}

inline double quantity(const problems::MachineResult& result, const std::string& name) {
  for (const problems::Quantity& each : result.quantities) {
    if (each.name == name) return std::get<double>(each.value);
  }
  ADD_FAILURE() << "no " << name;
  return std::nan("");
}

inline const std::vector<double>& column(const problems::MachineMotion& motion,
                                         const std::string& name) {
  return std::ranges::find(motion.columns, name, &problems::Column::name)->values;
}

inline bool says(const problems::MachineResult& result, const std::string& words) {
  return std::ranges::any_of(
      result.notes, [&](const std::string& note) { return note.find(words) != note.npos; });
}

}  // namespace cognate::test
