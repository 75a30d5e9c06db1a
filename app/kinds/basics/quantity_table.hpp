/// @file The quantities of a result as a table for people.
#pragma once

#include <span>
#include <string>

#include "app/console/screen.hpp"
#include "problems/basics/quantity.hpp"

namespace cognate::app {

/// A row for each quantity: its name, value and unit; empty where there are none.
std::string quantity_table(std::span<const problems::Quantity> quantities, const Screen& screen);

}  // namespace cognate::app
