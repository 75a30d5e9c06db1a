/// @file The assembly in which a mechanism stands at most of its positions.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::problems {

/// The side on which most of `positions` are, `open` where as many are on either. `side` gives that
/// of one of them.
template <class Positions, class Side = std::identity>
Assembly prevailing_side(const Positions& positions, Side side = {}) {
  const auto open = std::ranges::count(positions, Assembly::open, side);
  return 2 * open >= std::ssize(positions) ? Assembly::open : Assembly::crossed;
}

}  // namespace cognate::problems
