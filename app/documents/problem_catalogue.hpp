/// @file What a synthesis problem's file may ask for, as data: for `cognate list`, for the
/// documents, for the tests.
#pragma once

#include <span>

#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {

/// The tables with the same keys in every synthesis problem for which they have a meaning.
std::span<const KeyedEntry> common_tables();

}  // namespace cognate::app
