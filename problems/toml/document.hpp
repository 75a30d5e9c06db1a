/// @file A TOML document as plain values with positions. No type of the parser's appears here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "problems/toml/fault_list.hpp"

namespace cognate::problems::reading {

struct Node;
struct Entry;

using Array = std::vector<Node>;
using Table = std::vector<Entry>;

/// A date or a time: no problem file has a use for them.
struct DateOrTime {};

/// A value and where it begins.
struct Node {
  Where where;
  std::variant<bool, std::int64_t, double, std::string, DateOrTime, Array, Table> value;
  /// Whether this is a string whose characters stand in the file as they are, each in its own
  /// column behind one quotation mark: no escapes, no end of a line.
  bool verbatim = false;
};

/// A key, where it stands, and its value.
struct Entry {
  std::string key;
  Where where;
  Node node;
};

/// "a string", "an array", …: what `node` is, for messages.
std::string_view type_name(const Node& node);

/// A document, and what of a problem no document can say: sizes that disagree, functions that are
/// missing.
struct Written {
  Table document;
  std::vector<std::string> faults;
};

/// The document in `text`, its tables in the order of the file, or the first place where it is no
/// TOML. Throws only std::bad_alloc.
tl::expected<Table, Fault> parse_document(std::string_view text);

}  // namespace cognate::problems::reading
