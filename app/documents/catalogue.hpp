/// @file What this version can do, as data: for `cognate list`, for the documents, for the tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <span>
#include <string_view>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::app {

/// Something that has a name in a file, and what it means in a few words.
struct Entry {
  std::string_view name;
  std::string_view meaning;
  std::string_view type{};  ///< what it holds, where one word says it: "number", "boolean", …
  std::vector<std::string_view> (*values)() = nullptr;  ///< the words that it takes
};

/// A key under `metrics` of a design, levels separated by dots; `unit` is "1" for pure numbers and
/// empty for words.
struct Metric {
  std::string_view key;
  std::string_view unit;
  std::string_view meaning;
  std::string_view symbol{};  ///< of a standard, "d_a"; of several keys one for each
};

template <class List>
inline constexpr std::size_t kSizeOf = std::tuple_size_v<List>;
template <class Row, std::size_t Size>
inline constexpr std::size_t kSizeOf<Row[Size]> = Size;

template <class Key>
constexpr Entry entry_of(const Key& key) {
  if constexpr (requires { key.form; }) {
    return {key.name, key.meaning, problems::reading::to_word(key.form), key.words};
  } else if constexpr (requires { key.type; }) {
    return key;
  } else {
    return {key.name, key.meaning};
  }
}

/// The entries in `lists` of entries or of declared keys, one after the other.
template <class... Lists>
constexpr auto entries_of(const Lists&... lists) {
  std::array<Entry, (kSizeOf<Lists> + ...)> all{};
  auto next = all.begin();
  const auto append = [&](const auto& list) {
    for (const auto& key : list) *next++ = entry_of(key);
  };
  (append(lists), ...);
  return all;
}

/// A list with the declared quantities over the cycle between its parts.
template <class First, class Declared, class Last>
constexpr auto with_cycle_quantities(const First& first, const Declared& declared,
                                     const Last& last) {
  using Row = std::ranges::range_value_t<First>;
  std::array<Row, kSizeOf<First> + problems::kCycleQuantities.size() + kSizeOf<Last>> all{};
  std::ranges::copy(last,
                    std::ranges::transform(problems::kCycleQuantities,
                                           std::ranges::copy(first, all.begin()).out, declared)
                        .out);
  return all;
}

/// The keys of `[solve]`.
std::span<const Entry> solve_options();

/// Every key that may stand under `metrics` of a design that was found.
std::span<const Metric> metrics();

/// Every key that may stand under `facts` of a result.
std::span<const Metric> quantities();

}  // namespace cognate::app
