#include "app/documents/csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace cognate::app {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

void append_number(std::string& line, double value) {
  if (!std::isfinite(value)) return;
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  line.append(digits.data(), end);
}

/// "C_vx_mm_per_s" of "C_vx_per_s", whose unit is "length/s"; "C_curvature_per_mm", of "1/length".
std::string heading(const problems::Column& column, std::string_view length) {
  constexpr std::string_view kLength = "length", kPer = "_per_";
  const auto at = column.unit.find(kLength);
  if (length.empty() || at == std::string::npos) return column.name;
  std::string name = column.name;
  if (at == 0)
    return name.insert(std::min(name.rfind(kPer), name.size()), "_" + std::string(length));
  name.append(column.unit.starts_with("1/") ? "" : "_N").append(kPer).append(length);
  return column.unit.size() > at + kLength.size() ? name + "2" : name;
}

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += c;
  }
  return cell + '"';
}

std::string csv_text(std::span<const problems::Column> columns, const CsvWords& words,
                     std::string_view length) {
  std::string text;
  const auto append_line = [&](std::string_view word, auto&& append_cell) {
    text += csv_cell(word);
    bool first = words.name.empty();
    for (const problems::Column& column : columns) {
      if (!first) text += ',';
      first = false;
      append_cell(column);
    }
    text += kLineEnd;
  };
  append_line(words.name,
              [&](const problems::Column& column) { text += csv_cell(heading(column, length)); });
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    append_line(words.name.empty() ? "" : words.cells[row],
                [&](const problems::Column& column) { append_number(text, column.values[row]); });
  }
  return text;
}

}  // namespace cognate::app
