/// @file The keys of a table, each declared once: its reader, what is written of it and
/// `cognate list` run over the declarations.
#pragma once

#include <type_traits>
#include <vector>

#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// What stands behind a key. `any`: what one word does not say; the meaning does.
enum class KeyForm { any, number, speed, integer, boolean, word, text, range, point, box };

/// Empty for `any`.
constexpr std::string_view to_word(KeyForm form) {
  constexpr std::string_view kWords[] = {"",     "number", "speed", "integer", "boolean",
                                         "word", "text",   "range", "point",   "box"};
  return kWords[static_cast<std::size_t>(form)];
}

/// Which integers a key takes.
struct IntegerRule {
  int min = 1, max = 1;
};

/// A key as everyone sees it.
struct KeyDeclaration {
  std::string_view name;  ///< in `cognate list`, where that of its table and a dot may precede it
  std::string_view meaning;  ///< there
  KeyForm form = KeyForm::any;
  NumberRule rule = kNumber;
  IntegerRule integers{};
  std::vector<std::string_view> (*words)() = nullptr;  ///< those allowed; of `word` alone

  constexpr std::string_view in_table() const { return name.substr(name.find('.') + 1); }
  constexpr bool is_angle() const { return name.find("_deg") != std::string_view::npos; }
};

/// A key and how it gets to its member and from there. An optional member has no default, and its
/// key is left out where it is empty. Angles are in radians, in files in degrees under keys that
/// say
/// `_deg`. Without functions it has rules of its own, and the reader of its table takes it.
template <class Struct>
struct Key : KeyDeclaration {
  void (*read)(TableReader& table, const KeyDeclaration& key, Struct& values) = nullptr;
  void (*write)(const Struct& values, const KeyDeclaration& key, TableWriter& table) = nullptr;
};

namespace detail {

template <class T>
struct Bare {
  using Type = T;
};
template <class T>
struct Bare<std::optional<T>> {
  using Type = T;
};

template <class Struct, class Member>
Struct struct_of(Member Struct::*);
template <class Struct, class Member>
typename Bare<Member>::Type value_of(Member Struct::*);

template <class Value>
constexpr KeyForm form_of() {
  if constexpr (std::is_same_v<Value, double>) return KeyForm::number;
  if constexpr (std::is_same_v<Value, int>) return KeyForm::integer;
  if constexpr (std::is_same_v<Value, bool>) return KeyForm::boolean;
  if constexpr (std::is_enum_v<Value>) return KeyForm::word;
  if constexpr (std::is_same_v<Value, std::string>) return KeyForm::text;
  if constexpr (std::is_same_v<Value, Range>) return KeyForm::range;
  if constexpr (std::is_same_v<Value, Vec2d>) return KeyForm::point;
  if constexpr (std::is_same_v<Value, Box>) return KeyForm::box;
}

template <class Value>
std::optional<Value> read_value(TableReader& table, const KeyDeclaration& key) {
  const std::string_view name = key.in_table();
  const double unit = key.is_angle() ? radians(1) : 1;
  if constexpr (std::is_same_v<Value, double>) {
    const auto number = key.form == KeyForm::speed ? table.turning_speed(name, key.rule)
                                                   : table.number(name, key.rule);
    return number ? std::optional(*number * unit) : std::nullopt;
  }
  if constexpr (std::is_same_v<Value, Range>) {
    const auto range = table.range(name, key.rule);
    return range ? std::optional(Range{range->min * unit, range->max * unit}) : std::nullopt;
  }
  if constexpr (std::is_same_v<Value, int>) {
    return table.integer(name, key.integers.min, key.integers.max);
  }
  if constexpr (std::is_same_v<Value, bool>) return table.boolean(name);
  if constexpr (std::is_same_v<Value, std::string>) return table.text(name);
  if constexpr (std::is_same_v<Value, Vec2d>) return table.point(name);
  if constexpr (std::is_same_v<Value, Box>) return table.box(name);
  if constexpr (std::is_enum_v<Value>) return table.choice<Value>(name);
}

template <class Enum>
std::vector<std::string_view> words_of() {
  std::vector<std::string_view> all;
  for (const auto& named : names<Enum>()) all.push_back(named.name);
  return all;
}

/// The key of `Member`, a pointer to one.
template <auto Member>
constexpr auto declared(KeyDeclaration declaration) {
  using Struct = decltype(struct_of(Member));
  using Value = decltype(value_of(Member));
  if (declaration.form == KeyForm::any) declaration.form = form_of<Value>();
  if constexpr (std::is_enum_v<Value>) declaration.words = words_of<Value>;
  Key<Struct> key{declaration};
  key.read = [](TableReader& table, const KeyDeclaration& own, Struct& values) {
    // What the file does not say stays as it is, whether the member is optional or not.
    // NOLINTNEXTLINE(bugprone-optional-value-conversion)
    if (auto value = read_value<Value>(table, own)) values.*Member = std::move(*value);
  };
  key.write = [](const Struct& values, const KeyDeclaration& own, TableWriter& table) {
    if constexpr (std::is_enum_v<Value>) {
      table.set_name(own.in_table(), values.*Member);
    } else if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, Range>) {
      own.is_angle() ? table.set_deg(own.in_table(), values.*Member)
                     : table.set(own.in_table(), values.*Member);
    } else {
      table.set(own.in_table(), values.*Member);
    }
  };
  return key;
}

}  // namespace detail

/// The key of a member, a number or a range by `rule`.
template <auto Member>
constexpr auto key(std::string_view name, std::string_view meaning,
                   const NumberRule& rule = kNumber) {
  return detail::declared<Member>({.name = name, .meaning = meaning, .rule = rule});
}

/// Of an integer.
template <auto Member>
constexpr auto key(std::string_view name, std::string_view meaning, const IntegerRule& integers) {
  return detail::declared<Member>({.name = name, .meaning = meaning, .integers = integers});
}

/// Of a speed in rad/s, which `NAME_rpm` gives in turns a minute.
template <auto Member>
constexpr auto speed_key(std::string_view name, std::string_view meaning, const NumberRule& rule) {
  return detail::declared<Member>(
      {.name = name, .meaning = meaning, .form = KeyForm::speed, .rule = rule});
}

/// One with rules of its own, which the reader of its table takes.
template <class Struct>
constexpr Key<Struct> own_key(std::string_view name, std::string_view meaning,
                              KeyForm form = KeyForm::any) {
  return {{.name = name, .meaning = meaning, .form = form}};
}

template <class Keys, class Struct>
void read_keys(TableReader& table, const Keys& keys, Struct& values) {
  for (const Key<Struct>& key : keys) {
    if (key.read) key.read(table, key, values);
  }
}

template <class Keys, class Struct>
TableWriter& write_keys(const Struct& values, const Keys& keys, TableWriter& table) {
  for (const Key<Struct>& key : keys) {
    if (key.write) key.write(values, key, table);
  }
  return table;
}

}  // namespace cognate::problems::reading
