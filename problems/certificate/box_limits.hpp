/// @file Whether any linkage of a box satisfies the limits of lengths and transmission angle.
#pragma once

#include <array>
#include <optional>

#include "problems/certificate/link_angles.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// Limits in the file's unit, each as far as the check of a finished design lets it be passed.
class BoxLimits {
 public:
  /// `lengths` of crank, coupler, rocker and frame.
  BoxLimits(const std::array<Range, 4>& lengths, const Constraints& constraints, double ratio);

  /// Crank lengths that the four lengths allow over a box; empty where there are none, or where a
  /// limit of the proportions is surely broken.
  std::optional<QuadInterval> crank_lengths(const QuadBox& box, const QuadProportions& p) const;
  /// Whether the transmission angle may keep its limits with the diagonal's square in `least`, and
  /// with that in `greatest`.
  bool may_transmit(const QuadProportions& p, const QuadInterval& least,
                    const QuadInterval& greatest) const;

 private:
  bool may_keep_ratio(const QuadProportions& p) const;

  std::array<std::optional<Quad>, 4> least_, greatest_;
  Quad ratio_;
  std::optional<QuadInterval> cosine_of_min_, cosine_of_max_;
};

}  // namespace cognate::problems
