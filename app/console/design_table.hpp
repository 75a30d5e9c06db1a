/// @file The table of designs of any kind: a row for each design.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/console/text_table.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// What stands where a design has nothing.
inline constexpr const char* kNoValue = "–";

/// "all met", or how many are missed.
std::string constraints_text(std::span<const problems::ConstraintCheck> checks);

/// Collects columns, each with one cell for each design; the first numbers the designs.
template <class Design>
class DesignTable {
 public:
  explicit DesignTable(std::span<const Design> designs) : designs_(designs) {
    int number = 0;
    add("#", Align::right, [&](const Design&) { return std::to_string(++number); });
  }

  template <class Cell>
  void add(std::string heading, Align align, Cell cell) {
    Column made{std::move(heading), align, {}};
    std::ranges::transform(designs_, std::back_inserter(made.cells), std::ref(cell));
    columns_.push_back(std::move(made));
  }

  /// The same, unless no design has anything there.
  template <class Cell>
  void add_if_any(std::string heading, Align align, Cell cell) {
    add(std::move(heading), align, cell);
    const auto& cells = columns_.back().cells;
    if (std::ranges::all_of(cells, [](const auto& text) { return text == kNoValue; })) {
      columns_.pop_back();
    }
  }

  void add_constraints() {
    add("constraints", Align::left,
        [](const Design& design) { return constraints_text(design.constraints); });
  }

  std::span<const Design> designs() const { return designs_; }
  std::vector<Column>& columns() { return columns_; }

 private:
  std::span<const Design> designs_;
  std::vector<Column> columns_;
};

}  // namespace cognate::app
