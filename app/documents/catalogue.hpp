/// @file What this version can do, as data: for `cognate list`, for the documents, for the tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::app {

/// Something that has a name in a file, and what it means in a few words.
struct Entry {
  std::string_view name;
  std::string_view meaning;
};

/// A key under `metrics` of a design, levels separated by dots; `unit` is "1" for pure numbers and
/// empty for words.
struct Metric {
  std::string_view key;
  std::string_view unit;
  std::string_view meaning;
};

template <class List>
inline constexpr std::size_t kSizeOf = std::tuple_size_v<List>;
template <class Row, std::size_t Size>
inline constexpr std::size_t kSizeOf<Row[Size]> = Size;

/// The names and meanings in `lists` of entries or of declared keys, one after the other.
template <class... Lists>
constexpr auto entries_of(const Lists&... lists) {
  std::array<Entry, (kSizeOf<Lists> + ...)> all{};
  auto next = all.begin();
  const auto append = [&](const auto& list) {
    for (const auto& key : list) *next++ = {key.name, key.meaning};
  };
  (append(lists), ...);
  return all;
}

/// A list with the declared quantities over the cycle between its parts.
template <class Row, std::size_t First, std::size_t Last, class Declared>
constexpr auto with_cycle_quantities(const Row (&first)[First], const Declared& declared,
                                     const Row (&last)[Last]) {
  std::array<Row, First + problems::kCycleQuantities.size() + Last> all{};
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
