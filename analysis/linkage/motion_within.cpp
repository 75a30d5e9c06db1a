#include "analysis/linkage/motion_within.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate {

std::optional<CrankRange> motion_within(std::span<const CrankRange> ranges,
                                        const CrankRange& motion) {
  constexpr double kBeyond = 1e-7;
  for (const CrankRange& range : ranges) {
    if (range.to - range.from >= kTurn) return motion;
    // A motion that fits has its middle within half a turn of the range's.
    const double apart = 0.5 * (motion.from + motion.to) - 0.5 * (range.from + range.to);
    const double shift = std::remainder(apart, kTurn) - apart;
    const double from = motion.from + shift, to = motion.to + shift;
    const bool fits = from >= range.from - kBeyond && to <= range.to + kBeyond;
    if (fits) return CrankRange{std::max(from, range.from), std::min(to, range.to)};
  }
  return std::nullopt;
}

}  // namespace cognate
