/// @file What a slider-crank can do, from its dimensions alone.
///
/// Crank angles θ count counter-clockwise from the slide direction; displacements count along it
/// from the foot of the perpendicular from the pivot. With crank l₁, coupler l₂, offset e (positive
/// to the left of the slide direction) and assembly σ = ±1, the slider stands at
///
///     s = l₁ cos θ + σ l₂ cos α,   sin α = (l₁ sin θ − e)/l₂,
///
/// α being its pressure angle (Li & Xu 2011, chapter 1). What is said of the crank holds for a
/// fixed block too (see as_slider_crank), with the rod for the slider.
///
/// Lengths are positive and finite, and the results do not depend on their unit.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank.hpp"

namespace cognate {

/// Which link turns fully: the crank where l₂ ≥ l₁ + |e|, the coupler where l₁ ≥ l₂ + |e|, or
/// neither. A change point counts with the crank first.
enum class SliderCrankClass { rotating_crank, rotating_coupler, no_rotation };
SliderCrankClass mobility_class(const SliderCrank& mechanism);

/// "rotating-crank", "rotating-coupler" or "no-rotation".
std::string_view name(SliderCrankClass mobility);

/// Whether the links reach the slide line at all: |e| ≤ l₁ + l₂.
bool can_assemble(const SliderCrank& mechanism);

/// Whether the crank turns fully: l₂ ≥ l₁ + |e|, true within rounding of equality.
bool crank_rotates(const SliderCrank& mechanism);

/// Whether the longer of crank and coupler equals the shorter plus |e|, within 16 ε of it: the
/// links may then lie in one line across the slide, where the two assemblies meet.
bool is_change_point(const SliderCrank& mechanism);

/// A place in the motion.
struct SliderPosition {
  double crank_angle = 0;   ///< in [−π, π] unless said otherwise
  double displacement = 0;  ///< of the slider
};

/// Where the two assemblies meet at a change point, at θ = ±π/2 and s = 0: empty unless
/// `is_change_point`, two for a centred slider-crank of equal links.
std::vector<SliderPosition> change_points(const SliderCrank& mechanism);

/// Where the mechanism closes, |l₁ sin θ − e| ≤ l₂: [0, 2π] for a crank that turns fully; one range
/// about −π/2 or π/2, from which the line leans away or to which the offset brings it nearer; two,
/// about 0 and π; none where it cannot be assembled.
std::vector<CrankRange> crank_ranges(const SliderCrank& mechanism);

/// Dead points of the crank as the driver: the ends of its ranges, where the coupler stands across
/// the slide. Angles as in `crank_ranges`.
std::vector<SliderPosition> dead_points(const SliderCrank& mechanism);

/// Where the slider stands at a crank angle, and its pressure angle in [−π/2, π/2]; empty where the
/// mechanism does not close.
std::optional<double> displacement(const SliderCrank& mechanism, double crank_angle);
std::optional<double> pressure_angle(const SliderCrank& mechanism, double crank_angle);

/// Where crank and coupler are collinear, dead points of the slider as the driver: `outer`
/// extended, A–C = l₁ + l₂; `inner` folded, A–C = |l₂ − l₁|; in the given assembly. Empty where
/// that position does not exist, and where C falls on A, which leaves the crank's direction open.
std::optional<SliderPosition> outer_limit(const SliderCrank& mechanism);
std::optional<SliderPosition> inner_limit(const SliderCrank& mechanism);

/// The stroke √((l₁ + l₂)² − e²) − √((l₁ − l₂)² − e²) between the limits on one circuit; where
/// neither link turns fully, the slider passes from one side of the pivot to the other: 2 √((l₁ +
/// l₂)² − e²). Empty where the mechanism cannot be assembled.
std::optional<double> stroke(const SliderCrank& mechanism);

/// How far the slider goes in the assembly given while the crank turns over `range` alone, which
/// must lie in one of `crank_ranges` (or may be any of a crank that turns fully): between its ends
/// and the limits inside. Empty where an end does not close.
std::optional<double> stroke(const SliderCrank& mechanism, const CrankRange& range);

/// The time ratio K ≥ 1 = (π + δ)/(π − δ) of a crank that turns fully, δ the angle between the
/// crank's two limit directions; 1 without offset. Empty where the crank does not turn fully and
/// where it has no inner limit.
std::optional<double> time_ratio(const SliderCrank& mechanism);

/// Least, greatest and steepest (largest |α|) pressure angle of the slider.
struct PressureAngles {
  double min = 0;
  double max = 0;
  double steepest = 0;
};

/// Over the whole range of the crank: at θ = ∓π/2, or ∓π/2 itself where the crank does not pass
/// there. Empty where the mechanism cannot be assembled.
std::optional<PressureAngles> pressure_angles(const SliderCrank& mechanism);

/// Over `range` alone, which must lie in one of `crank_ranges`: at its ends, and at θ = ±π/2 if
/// that lies inside. Empty where an end does not close.
std::optional<PressureAngles> pressure_angles(const SliderCrank& mechanism,
                                              const CrankRange& range);

}  // namespace cognate
