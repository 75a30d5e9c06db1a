/// @file The keys of a table, each declared once: its reader, what is written of it and
/// `cognate list` run over the declarations.
#pragma once

#include <variant>

#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// A key and the member that it sets. An optional member has no default, and its key is left out
/// where it is empty. Angles are in radians, in files in degrees under keys that say `_deg`.
template <class Struct>
struct Key {
  std::string_view name;  ///< in `cognate list`, where that of its table and a dot may precede it
  std::string_view meaning;  ///< there
  std::variant<double Struct::*, std::optional<double> Struct::*, std::optional<Range> Struct::*,
               bool Struct::*>
      of;
  NumberRule rule = kNumber;

  constexpr std::string_view in_table() const { return name.substr(name.find('.') + 1); }
  constexpr bool is_angle() const { return name.find("_deg") != std::string_view::npos; }
};

template <class Keys, class Struct>
void read_keys(TableReader& table, const Keys& keys, Struct& values) {
  for (const Key<Struct>& key : keys) {
    const double unit = key.is_angle() ? radians(1) : 1;
    const auto read = [&]<class Member>(Member of) {
      if constexpr (std::is_same_v<Member, bool Struct::*>) {
        values.*of = table.boolean(key.in_table()).value_or(values.*of);
      } else if constexpr (std::is_same_v<Member, std::optional<Range> Struct::*>) {
        const auto range = table.range(key.in_table(), key.rule);
        if (range) values.*of = Range{range->min * unit, range->max * unit};
      } else if (const auto number = table.number(key.in_table(), key.rule)) {
        values.*of = *number * unit;
      }
    };
    std::visit(read, key.of);
  }
}

template <class Keys, class Struct>
TableWriter& write_keys(const Struct& values, const Keys& keys, TableWriter& table) {
  for (const Key<Struct>& key : keys) {
    const auto write = [&](auto of) {
      key.is_angle() ? table.set_deg(key.in_table(), values.*of)
                     : table.set(key.in_table(), values.*of);
    };
    std::visit(write, key.of);
  }
  return table;
}

}  // namespace cognate::problems::reading
