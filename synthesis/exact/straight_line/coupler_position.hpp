/// @file A linkage at one position, as the local theory of straight lines needs it.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "analysis/coupler_curve/contact.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank.hpp"

namespace cognate::synthesis {

/// What may guide a coupler. A coupler point of a four-bar is ignored.
using CouplerLinkage = std::variant<FourBar, SliderCrank>;

/// The coupler's motion about a position of the crank. Vectors are in global directions and in the
/// linkage's unit, points counted from the crank pin B.
struct CouplerPosition {
  ContactSeries series;
  double size = 0;              ///< the longest link
  std::optional<Vec2d> slider;  ///< the slider's pin C, where there is one

  /// A point counted from B, in the coupler's axes (the first from B to C).
  Vec2d in_coupler(const Vec2d& from_pin) const { return conj(series.direction[0]) * from_pin; }
};

/// Empty where the linkage does not close at `crank_angle` (from the x axis), in its own assembly.
std::optional<CouplerPosition> coupler_position(const CouplerLinkage& linkage, double crank_angle);

/// Where the crank can stand, as angles from the x axis, but for what is closer than `margin` to a
/// change point, which ends a range: beyond it the assembly is another motion's.
std::vector<CrankRange> crank_ranges(const CouplerLinkage& linkage, double margin);

/// The range about `crank_angle`, which may have any number of turns, up to the next change points.
std::optional<CrankRange> range_about(const CouplerLinkage& linkage, double crank_angle);

}  // namespace cognate::synthesis
