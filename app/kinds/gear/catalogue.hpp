/// @file What a gear's file may ask for, as data: for `cognate list`, for the documents, for the
/// tests.
#pragma once

#include <span>

#include "app/documents/catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {

/// The tables of `kind = "gear"` and of `kind = "gear-pair"` and their keys.
std::span<const KeyedEntry> gear_tables();
std::span<const KeyedEntry> gear_pair_tables();

/// Keys of the metrics of a gear, which a pair has of each of its gears under "pinion." and
/// "wheel.".
std::span<const Metric> gear_metrics();

/// Keys of the metrics of a pair besides these.
std::span<const Metric> gear_pair_metrics();

/// Columns of the table of a gear's flank.
std::span<const Metric> gear_columns();

}  // namespace cognate::app
