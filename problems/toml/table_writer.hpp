/// @file A problem written down as the document that its reader reads.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/names.hpp"
#include "problems/basics/range.hpp"
#include "problems/toml/document.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// A value as a document holds it.
Node node(bool value);
Node node(int value);
Node node(double value);
Node node(std::string_view text);
Node node(const Vec2d& point);
Node node(const Range& range);
Node node(const Box& box);
Node node(Array array);
Node node(Table table);
inline Node node(const std::string& text) {
  return node(std::string_view(text));
}
inline Node node(const char* text) {
  return node(std::string_view(text));
}

template <class T>
Node node(const std::pair<T, T>& two);
template <class T>
Node node(const std::vector<T>& list);
template <class T, std::size_t Size>
Node node(const std::array<T, Size>& list);

template <class List>
Array array_of(const List& list) {
  Array array;
  for (const auto& entry : list) array.push_back(node(entry));
  return array;
}
template <class T>
Node node(const std::pair<T, T>& two) {
  return node(Array{node(two.first), node(two.second)});
}
template <class T>
Node node(const std::vector<T>& list) {
  return node(array_of(list));
}
template <class T, std::size_t Size>
Node node(const std::array<T, Size>& list) {
  return node(array_of(list));
}

/// An angle, or a range of them, in degrees.
Node node_deg(double angle);
Node node_deg(const Range& range);

/// The keys of one table.
class TableWriter {
 public:
  template <class T>
  TableWriter& set(std::string_view key, const T& value) {
    return add(key, node(value));
  }
  template <class T>
  TableWriter& set(std::string_view key, const std::optional<T>& value) {
    return value ? set(key, *value) : *this;
  }
  template <class T>
  TableWriter& set_deg(std::string_view key, const T& angle) {
    return add(key, node_deg(angle));
  }
  template <class T>
  TableWriter& set_deg(std::string_view key, const std::optional<T>& angle) {
    return angle ? set_deg(key, *angle) : *this;
  }
  /// By its name in files; a number that is no value of the enumeration has none.
  template <class Enum>
  TableWriter& set_name(std::string_view key, Enum value) {
    return set(key, to_string(value));
  }
  template <class Enum>
  TableWriter& set_name(std::string_view key, const std::optional<Enum>& value) {
    return value ? set_name(key, *value) : *this;
  }

  TableWriter& add(std::string_view key, Node value);
  TableWriter& append(Table entries);
  Table take() { return std::move(table_); }
  bool empty() const { return table_.empty(); }

 private:
  Table table_;
};

inline Node node(TableWriter writer) {
  return node(writer.take());
}

/// The problem that the reader of its kind makes of its document, or every fault of both.
template <class Problem>
tl::expected<Problem, std::vector<std::string>> read_back(const Problem& given) {
  const Written written = KindTraits<Problem>::written(given);
  FaultList found;
  TableReader document(written.document, found);
  document.know({"kind", "title", "length_unit"});
  Problem problem = KindTraits<Problem>::read(document, {});
  document.finish();
  std::vector<std::string> faults = written.faults;
  for (Fault& fault : std::move(found).sorted()) faults.push_back(std::move(fault.message));
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return problem;
}

}  // namespace cognate::problems::reading
