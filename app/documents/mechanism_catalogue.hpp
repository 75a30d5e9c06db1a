/// @file The mechanisms that can be analysed and the keys of their tables, as data: for
/// `cognate list`, for the documents, for the tests.
#pragma once

#include <span>
#include <string_view>

#include "app/documents/catalogue.hpp"

namespace cognate::app {

/// A table of a file, or a type of one, and its keys.
struct KeyedEntry {
  std::string_view name;
  std::string_view meaning;
  std::span<const Entry> keys;
};

/// The values of `mechanism.type`, with the keys of `[mechanism]` except `type`.
std::span<const KeyedEntry> mechanisms();

/// The values of `dyad.type`, with the keys of `[[dyad]]` except `type` and `names`.
std::span<const KeyedEntry> dyads();

/// The other tables of an analysis.
std::span<const KeyedEntry> analysis_tables();

}  // namespace cognate::app
