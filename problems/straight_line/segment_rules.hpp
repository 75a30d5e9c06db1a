/// @file How the segments of a search are ranked and told apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "problems/straight_line/placing.hpp"
#include "problems/straight_line/search.hpp"

namespace cognate::problems {

inline bool is_feasible(const SegmentDesign& found) {
  return found.violation <= kSegmentFeasibility;
}

inline bool is_better(const SegmentDesign& a, const SegmentDesign& b) {
  if (is_feasible(a) != is_feasible(b)) return is_feasible(a);
  return is_feasible(a) ? a.objective < b.objective : a.violation < b.violation;
}

/// Starts are ranked by their promise, what is made of them by the objective.
struct SegmentRules {
  using Candidate = SegmentDesign;
  bool by_promise = true;
  /// While starts are ranked the places of one linkage are different designs, since limits of the
  /// place may leave some of them only.
  bool has_place = false;

  static bool has_value(const SegmentDesign& found) { return std::isfinite(found.violation); }
  bool precedes(const SegmentDesign& a, const SegmentDesign& b) const {
    return by_promise ? a.promise < b.promise : is_better(a, b);
  }
  bool is_same(const SegmentDesign& known, const SegmentDesign& other, double tolerance) const {
    if (!same_segment(other.segment, known.segment, tolerance)) return false;
    return !has_place || !by_promise || same_place(other.segment, known.segment, tolerance);
  }
  double value(const SegmentDesign& found) const {
    return !by_promise && is_feasible(found) ? found.objective : kInfinity;
  }
  /// Half of the places by promise are for those that satisfy the limits already, as far as there
  /// are any: of the others, however straight, none may reach them.
  void keep(std::vector<SegmentDesign>& sorted, std::size_t most) const {
    if (by_promise) {
      const auto sound = static_cast<std::size_t>(std::ranges::count_if(sorted, is_feasible));
      const auto others = std::ranges::stable_partition(sorted, is_feasible);
      const auto places = static_cast<std::ptrdiff_t>(std::min(sound, (most + 1) / 2));
      std::inplace_merge(
          sorted.begin() + places, others.begin(), sorted.end(),
          [](const SegmentDesign& a, const SegmentDesign& b) { return a.promise < b.promise; });
    }
    sorted.resize(most);
  }
};

}  // namespace cognate::problems
