/// @file What `cognate solve` prints: the designs as a table, what they miss, and the work done.
#pragma once

#include <string>

#include "app/console/design_columns.hpp"
#include "app/console/screen.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// `heading`, the status in words, the quantities of the synthesis, one row for each of the first
/// 20 designs (number, error or quantities, class, transmission angle, time ratio, dimensions,
/// residual and condition of an exact synthesis, defects, constraints, origin; see
/// design_columns.hpp), then for each of these that violates a constraint what it violates, the
/// certificate, the notes, and the time. Errors are in the unit of length for paths and in degrees
/// for functions. On a screen with colours these mark what is met and missed; a narrow one has the
/// columns in blocks.
std::string design_table(const std::string& heading, const ColumnChoice& choice,
                         const problems::Result& result, const Screen& screen);

}  // namespace cognate::app
