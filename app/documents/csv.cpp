#include "app/documents/csv.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace cognate::app {
namespace {

constexpr std::string_view kLineEnd = "\r\n";

void append_text(std::string& line, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
}

void append_number(std::string& line, double value) {
  if (!std::isfinite(value)) return;
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  line.append(digits.data(), end);
}

}  // namespace

std::string csv_text(std::span<const problems::Column> columns, const CsvWords& words) {
  std::string text;
  const auto append_line = [&](std::string_view word, auto&& append_cell) {
    append_text(text, word);
    bool first = words.name.empty();
    for (const problems::Column& column : columns) {
      if (!first) text += ',';
      first = false;
      append_cell(column);
    }
    text += kLineEnd;
  };
  append_line(words.name, [&](const problems::Column& column) { append_text(text, column.name); });
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    append_line(words.name.empty() ? "" : words.cells[row],
                [&](const problems::Column& column) { append_number(text, column.values[row]); });
  }
  return text;
}

}  // namespace cognate::app
