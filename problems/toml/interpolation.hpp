/// @file Functions of x that a problem file gives as a table.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace cognate::problems::reading {

/// A function of x and its derivative, which may be called from many threads.
struct Interpolant {
  std::function<double(double)> value;
  std::function<double(double)> slope;
};

/// The piecewise cubic through `table`, at least two (x, y) with increasing x, whose slopes keep it
/// monotone between neighbours wherever the table is (F.N. Fritsch, J. Butland, "A method for
/// constructing local monotone piecewise cubic interpolants", 1984). Beyond its ends it keeps the
/// end's value.
Interpolant interpolant(const std::vector<std::pair<double, double>>& table);

/// Its value alone.
std::function<double(double)> interpolate(const std::vector<std::pair<double, double>>& table);

/// Straight lines from row to row of `table`, which is as above.
std::function<double(double)> straight_lines(const std::vector<std::pair<double, double>>& table);

}  // namespace cognate::problems::reading
