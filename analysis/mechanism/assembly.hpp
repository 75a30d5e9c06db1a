/// @file The two ways in which a dyad can be put together, and when they are one.
#pragma once

#include "analysis/numbers/constants.hpp"

namespace cognate {

/// On which side of the directed line B→D the joint C lies: `open` to the left,
/// (D − B) × (C − B) > 0, `crossed` to the right.
enum class Assembly { open, crossed };

/// +1 for `open`, −1 for `crossed`: the sign of (D − B) × (C − B).
constexpr double sign(Assembly assembly) {
  return assembly == Assembly::open ? 1.0 : -1.0;
}

/// Sums of lengths that differ by no more than this part of the longest link are equal: lengths
/// rounded to doubles, and what a file's decimal digits or a few operations make of them, cannot be
/// distinguished from equal ones.
inline constexpr double kChangePointTolerance = 16 * kEpsilon;

}  // namespace cognate
