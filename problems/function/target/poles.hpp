/// @file Poles of a function that samples step over.
#pragma once

#include <functional>
#include <optional>

#include "problems/basics/range.hpp"

namespace cognate::problems::reading {

/// Where |y| grows without bound on `domain`, as far as doubles show: from each local maximum
/// of |y| among samples at `intervals` equal steps, |y| is followed to its greatest value in steps
/// that halve. At a pole it still grows in the last digits of x; a peak, however steep, levels off
/// before. Empty where there is none. Logarithmic poles are not seen.
std::optional<double> find_pole(const std::function<double(double)>& y, const Range& domain,
                                int intervals);

}  // namespace cognate::problems::reading
