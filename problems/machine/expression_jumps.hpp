/// @file Where the expressions of a machine jump along the drive's angle.
#pragma once

#include <string>
#include <vector>

#include "problems/toml/expression.hpp"

namespace cognate::problems::reading {

/// The angles in [0, 2π), increasing, at which `parsed`, of the variables phi, w, t, s, v or the
/// first of them, jumps at any of many values of the others: below, between and beyond the numbers
/// that `text` names and the powers of ten from 0.1 to 1000, of either sign but for the time.
/// A jump is as of `find_jumps`.
std::vector<double> jumps_of_expression(const std::string& text, const ParsedExpression& parsed);

}  // namespace cognate::problems::reading
