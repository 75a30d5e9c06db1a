/// @file How far a table of a function scatters about a smooth curve.
#pragma once

#include <optional>
#include <span>
#include <utility>

namespace cognate::problems {

/// Standard deviation of the scatter of `rows` (x increasing or decreasing, y), as a share of the
/// range of y; empty where the table may be smooth.
///
/// Each row is compared with the cubic through its two neighbours on either side. What remains of a
/// smooth table keeps its sign from row to row, however steep it is; at a kink or a jump it
/// alternates, but at four rows only. What remains of independent errors alternates everywhere,
/// in four of five steps at equal spacing. The scale is their lower quartile, so that outliers and
/// kinks do not decide. A wave of fewer than six rows a period cannot be known from scatter.
std::optional<double> scatter_share(std::span<const std::pair<double, double>> rows);

}  // namespace cognate::problems
