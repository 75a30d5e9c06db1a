/// @file The quantities of a result as a table for people.
#pragma once

#include <span>
#include <string>

#include "app/console/screen.hpp"
#include "app/documents/catalogue.hpp"
#include "problems/basics/quantity.hpp"

namespace cognate::app {

/// A row for each quantity: its name, value and unit, and of metrics `with_symbols` the symbol that
/// a standard gives it; empty where there are none.
std::string quantity_table(std::span<const problems::Quantity> quantities, const Screen& screen,
                           std::span<const Metric> with_symbols = {});

}  // namespace cognate::app
