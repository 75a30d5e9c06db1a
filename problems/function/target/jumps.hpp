/// @file Where a function jumps.
#pragma once

#include <functional>
#include <vector>

#include "problems/basics/range.hpp"

namespace cognate::problems::reading {

/// The angles in [0, 2π), increasing, at which `f` jumps by a hundredth of what it varies over the
/// turn or more; 0 where its value before 2π is not that at 0. Searched in `intervals` equal parts,
/// of two jumps in one of which only one is found; each to the last digit.
std::vector<double> find_jumps(const std::function<double(double)>& f, int intervals);

/// Likewise the places of `domain` where `f`, finite on it, jumps by a hundredth of what it varies
/// there or more: of a value that holds at an end alone, that end or the number next to it.
std::vector<double> find_jumps(const std::function<double(double)>& f, const Range& domain,
                               int intervals);

}  // namespace cognate::problems::reading
