/// @file How a leg walks: what the closed path of its foot is like while the foot stands.
#pragma once

#include <functional>
#include <optional>

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A foot at an angle of the crank.
struct FootState {
  Vec2d at;
  Vec2d rate;  ///< derivative by the crank's angle
};

/// The foot along the crank's turn, of period 2π; the ground is parallel to the x axis, below.
using FootPath = std::function<FootState(double crank)>;

/// What a step is like. The ground is the lowest level of the foot over the turn; in stance, a part
/// of the turn from `from` to `to`, the foot stays within `band` above it.
struct Gait {
  double duty = 0;          ///< share of the turn in stance (duty factor), in (0, 1)
  double from = 0, to = 0;  ///< crank angles, `from` in [0, 2π)
  double stride = 0;        ///< extent of the stance along the ground
  double height = 0;        ///< of the step: extent of the path across the ground over the turn
  double band = 0;          ///< highest level in stance above the ground
  double square = 0;        ///< mean, of the foot's deviation from the middle of the band
  int sense = 1;            ///< of x in stance: the body walks the other way
  double speed_min = 0;  ///< of the foot in that sense, over stride/(to − from), its mean speed
  double speed_max = 0;  ///< where it does not turn round

  /// How far the foot rises in stance, as a share of the stride.
  double flatness() const { return band / stride; }
};

/// The share of the step height up to which the foot stands where no duty factor is given.
inline constexpr double kStanceShare = 0.15;

/// The gait of the duty factor `duty`, in (0, 1): of all parts of the turn that long, that in which
/// the foot rises least above the ground. Many do where its highest level is inside and not at the
/// ends; of these the stance is the one whose ends have one level, of several such the one with the
/// lowest ends, then with the longest stride. Mirroring the path or running through it the other
/// way gives the same stance. Without `duty` the stance is the longest part in which the foot stays
/// within `kStanceShare` of the step height. Of equal ones the first from the crank angle 0 on.
/// Levels and strides that differ by 1e-9 of the step height and of the stride are equal. Extremes
/// are refined between 720 samples by zeros of the rates. Empty where the path is not finite all
/// along, or has no height or no stride.
std::optional<Gait> gait(const FootPath& path, std::optional<double> duty = std::nullopt);

/// The gait of a point of a mechanism driven by a crank that turns fully, without change points.
std::optional<Gait> gait(const Mechanism<double>& mechanism, const Attached<double>& foot,
                         std::optional<double> duty = std::nullopt);

}  // namespace cognate
