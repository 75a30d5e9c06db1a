/// @file Which rows of a table are drawn.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// Indices of the rows to draw, increasing: all of them where `columns` hold at most `cells` values
/// and at most `most` rows, else rows in equal steps, first and last among them, and also the
/// rows in which a column is least or greatest, so that no peak is cut. At least two steps are kept
/// however many columns there are; empty without rows.
std::vector<std::size_t> drawn_rows(std::span<const problems::Column> columns, std::size_t most,
                                    std::size_t cells);

}  // namespace cognate::app
