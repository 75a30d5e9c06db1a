/// @file The problem of a document that a page hands over, by the reader of its kind.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::page {

/// The problem of `document`; what is wrong with it is in `faults`.
template <class Problem>
Problem problem_of(const problems::reading::Table& document, problems::reading::FaultList& faults) {
  problems::reading::TableReader reader(document, faults);
  reader.know({"kind"});
  std::string title = reader.text("title").value_or("");
  const auto unit = reader.choice<problems::LengthUnit>("length_unit");
  auto problem = problems::KindTraits<Problem>::read(reader, {});
  reader.finish();
  problem.title = std::move(title);
  problem.length_unit = unit;
  return problem;
}

}  // namespace cognate::page
