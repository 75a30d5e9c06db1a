#include "problems/toml/document.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace cognate::problems::reading {
namespace {

Where where_of(const toml::source_region& source, Where otherwise) {
  // Tables that only exist as a part of a dotted key have no place of their own.
  if (source.begin.line == 0) return otherwise;
  return {source.begin.line, source.begin.column};
}

std::ptrdiff_t characters(std::string_view text) {
  return std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
}

// Escapes and threefold quotation marks take more columns than the characters and two marks.
bool is_verbatim(std::string_view text, const toml::source_region& source) {
  return source.begin.line == source.end.line &&
         static_cast<std::ptrdiff_t>(source.end.column) - source.begin.column ==
             characters(text) + 2;
}

Table convert_table(const toml::table& table);

// The parser nests no deeper than 256 values, times the parts of a dotted key (check_key_depth).
Node convert(const toml::node& node, Where otherwise) {
  const Where where = where_of(node.source(), otherwise);
  if (const auto* table = node.as_table()) return {where, convert_table(*table)};
  if (const auto* array = node.as_array()) {
    Array elements;
    elements.reserve(array->size());
    for (const toml::node& element : *array) elements.push_back(convert(element, where));
    return {where, std::move(elements)};
  }
  if (const auto* string = node.as_string()) {
    return {where, string->get(), is_verbatim(string->get(), node.source())};
  }
  if (const auto* integer = node.as_integer()) return {where, integer->get()};
  if (const auto* number = node.as_floating_point()) return {where, number->get()};
  if (const auto* boolean = node.as_boolean()) return {where, boolean->get()};
  return {where, DateOrTime{}};
}

Table convert_table(const toml::table& table) {
  Table entries;
  entries.reserve(table.size());
  for (const auto& [key, node] : table) {
    const Where where = where_of(key.source(), {});
    entries.push_back({std::string(key.str()), where, convert(node, where)});
  }
  std::ranges::stable_sort(entries, {}, &Entry::where);
  return entries;
}

/// A NUL, which only an escape can bring in, ends a string for whoever takes it as a C string: a
/// path would be another one than was checked.
constexpr std::string_view kNul("\0", 1);

Fault nul_fault(Where where, std::string_view what) {
  return {where.line, where.column,
          fmt::format("{} holds the character U+0000; any other one is allowed", what)};
}

std::optional<Fault> find_nul(const Table& table);

std::optional<Fault> find_nul(const Node& node) {
  if (const auto* text = std::get_if<std::string>(&node.value)) {
    if (text->find(kNul) != std::string::npos) return nul_fault(node.where, "this string");
  }
  if (const auto* table = std::get_if<Table>(&node.value)) return find_nul(*table);
  if (const auto* array = std::get_if<Array>(&node.value)) {
    for (const Node& element : *array) {
      if (auto fault = find_nul(element)) return fault;
    }
  }
  return std::nullopt;
}

std::optional<Fault> find_nul(const Table& table) {
  for (const Entry& entry : table) {
    if (entry.key.find(kNul) != std::string::npos) return nul_fault(entry.where, "this key");
    if (auto fault = find_nul(entry.node)) return fault;
  }
  return std::nullopt;
}

/// What a file is that was never meant to be TOML, and what to do; empty where it may be TOML.
std::string_view other_format(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return "";
  if (text[begin] == '<') {
    return "this is HTML, SVG or other XML, not TOML; expected a problem file, which may name a "
           "drawing by target.svg";
  }
  if (text[begin] != '{') return "";
  if (text.find("\"cognate-result/") != std::string_view::npos) {
    return "this is a result of Cognate; 'cognate export' takes it; expected the TOML file "
           "that it came from here";
  }
  return "this is JSON, not TOML; expected a problem file, written key = value";
}

/// What to do about the commonest faults, by what the parser says of them.
std::string_view remedy(std::string_view description) {
  struct Remedy {
    std::string_view said;
    std::string_view done;
  };
  constexpr Remedy kRemedies[] = {
      {"array: encountered end-of-file", "a bracket is not closed"},
      {"could not determine value type", "words stand in quotes, numbers without unit"},
      {"string: encountered", "a string ends with its quotes on the same line"},
      {"string: expected", "a string ends with its quotes on the same line"},
      {"unescaped control characters", "a string ends with its quotes on the same line"},
      {"boolean: expected", "words stand in quotes"},
      {"floating-point: expected", "numbers stand without unit, words in quotes"},
      {"integer: expected", "numbers stand without unit, words in quotes"}};
  for (const Remedy& known : kRemedies) {
    if (description.find(known.said) != std::string_view::npos) return known.done;
  }
  return "see https://toml.io";
}

// The parser's "Error while parsing array: expected …" without its first words.
std::string rule(std::string_view description) {
  constexpr std::string_view kOpening = "Error while parsing ";
  if (description.starts_with(kOpening)) description.remove_prefix(kOpening.size());
  return std::string(description);
}

}  // namespace

tl::expected<Table, Fault> parse_document(std::string_view text) {
  try {
    Table document = convert_table(toml::parse(text));
    if (auto fault = find_nul(document)) return tl::unexpected(*std::move(fault));
    return document;
  } catch (const toml::parse_error& error) {
    const auto other = other_format(text);
    if (!other.empty()) return tl::unexpected(Fault{1, 1, std::string(other)});
    const Where where = where_of(error.source(), {});
    return tl::unexpected(Fault{where.line, where.column,
                                fmt::format("not valid TOML: {}; {}", rule(error.description()),
                                            remedy(error.description()))});
  }
}

}  // namespace cognate::problems::reading
