/// @file Four-bars two of whose lengths run to infinity together: a joint then moves on a line.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// What such a four-bar tends to: a slider-crank, seen from the pivot of its short link.
struct SliderLimit {
  bool slider_drives = false;  ///< the crank is long, so that the short link is the rocker
  Vec2d pivot;                 ///< of the short link, whose length is `crank`
  double crank = 0, coupler = 0;
  /// From the pivot to the slide's line, at a right angle to it; C is at C = pivot + foot + x·t
  /// with t at a right angle to `foot`'s direction `normal`.
  double offset = 0;
  Vec2d normal;
};

/// Empty where the frame and the rocker, or the frame and the crank, are not both at least 30 times
/// as long as the other links and the coupler point's distance from B.
std::optional<SliderLimit> slider_limit(const FourBar& linkage);

/// Leaves of designs that differ only in lengths running to infinity, and by so much as these
/// still lack of it, the first, which is the best, and adds a note on what each such design tends
/// to. Indices of cognates and mirror images follow.
void merge_long_links(Result& result);

}  // namespace cognate::problems
