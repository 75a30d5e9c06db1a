/// @file What a running machine's file may ask for, as data: for `cognate list`, for the documents,
/// for the tests.
#pragma once

#include <span>

#include "app/documents/catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {

/// The tables of `kind = "machine"` besides [mechanism], [[link]], [[point]] and gravity, which are
/// those of an analysis.
std::span<const KeyedEntry> machine_tables();

/// Every key that may stand under `metrics` of a machine.
std::span<const Metric> machine_metrics();

/// The columns of the table of a machine's motion.
std::span<const Metric> machine_columns();

}  // namespace cognate::app
