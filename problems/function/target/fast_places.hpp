/// @file Where a function varies too fast for equal steps.
#pragma once

#include <functional>
#include <vector>

namespace cognate::problems {

/// The places, ascending, by which equal steps over [0, 1] have to be halved, some again and again,
/// until between neighbours the function is a cubic to a 1e-8 of its greatest less its least value.
/// At a kink or jump halving ends at a 2⁻³⁰th of a step; and after some ten thousand places in all,
/// the longer steps being halved first.
///
/// `value` is finite. Each step is judged by a cubic through four of its places and by three
/// others, which do not lie evenly: a function that oscillates more than twice in a step may go
/// unseen.
std::vector<double> fast_places(const std::function<double(double)>& value, int steps);

}  // namespace cognate::problems
