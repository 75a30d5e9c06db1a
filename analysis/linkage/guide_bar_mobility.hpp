/// @file What a guide-bar can do, from its dimensions alone.
///
/// Angles count counter-clockwise from the directed line A→C between crank pivot and guide pivot.
/// With crank l₁, frame l₄ = |C − A|, offset e and assembly σ = ±1, at the crank angle θ
///
///     r² = |B − C|² = (l₄ − l₁)² + 4 l₁ l₄ sin²(θ/2),   s = σ √(r² − e²),
///
/// and the bar's direction is that of (B − C)/(s + i e). Without offset and with the frame the
/// longer it is the oscillating guide-bar of Li & Xu 2011, chapter 1. What is said here of the bar
/// holds for the block of an oscillating block (see as_guide_bar), half a turn further.
///
/// Crank and frame are positive and finite, and the results do not depend on their unit.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/mobility.hpp"

namespace cognate {

/// How the bar moves: it swings while the crank turns where l₄ ≥ l₁ + |e|, it turns with the crank
/// where l₁ ≥ l₄ + |e|; otherwise the crank does not turn fully. A change point counts with the
/// first that holds.
enum class GuideBarClass { oscillating, rotating, no_rotation };
GuideBarClass mobility_class(const GuideBar& mechanism);

/// "oscillating", "rotating" or "no-rotation".
std::string_view name(GuideBarClass mobility);

/// Whether the bar's line reaches the crank pin anywhere: |e| ≤ l₁ + l₄.
bool can_assemble(const GuideBar& mechanism);

/// Whether the crank turns fully: |l₄ − l₁| ≥ |e|, true within rounding of equality.
bool crank_rotates(const GuideBar& mechanism);

/// Whether |l₄ − l₁| equals |e|, within 16 ε of the longest: at θ = 0 the two assemblies meet.
bool is_change_point(const GuideBar& mechanism);

/// Where the mechanism closes, r ≥ |e|: [0, 2π], or [θ₀, 2π − θ₀] where the crank does not turn
/// fully; none where it cannot be assembled. The ends of the latter are dead points of the crank.
std::vector<CrankRange> crank_ranges(const GuideBar& mechanism);

/// The direction of the bar, in [−π, π], at a crank angle; empty where the mechanism does not close
/// and where the crank pin falls on the guide pivot.
std::optional<double> bar_angle(const GuideBar& mechanism, double crank_angle);

/// A place where the bar turns back, the crank standing across it; angles in [−π, π].
struct BarLimit {
  double crank_angle = 0;
  double bar_angle = 0;
};

/// The limits with the crank to the left and to the right of the bar's direction u: the guide line
/// touches both the crank circle and the circle of radius |e| about C. Both exist for an
/// oscillating bar, none for a rotating one; they are dead points of the bar as the driver.
std::array<std::optional<BarLimit>, 2> bar_limits(const GuideBar& mechanism);

/// The angle asin((l₁ − e)/l₄) + asin((l₁ + e)/l₄) between the limits of an oscillating bar; empty
/// for any other.
std::optional<double> swing(const GuideBar& mechanism);

/// The time ratio K = (π + swing)/(π − swing) of an oscillating bar, so that without offset crank =
/// frame · sin(swing/2). Empty for any other, and for a swing of half a turn (crank = frame).
std::optional<double> time_ratio(const GuideBar& mechanism);

/// The ratio K ≥ 1 of the crank angles in which a rotating bar makes the half turns from and back
/// to the direction `bar_angle`: a slide driven by the bar that has its limits there returns
/// quicker by this (Whitworth's quick return). Greatest where the bar stands across the frame.
/// Empty for a bar that does not rotate.
std::optional<double> half_turn_time_ratio(const GuideBar& mechanism, double bar_angle);

/// Least and greatest |s|, from the foot of the perpendicular from C on the guide line to the
/// block.
struct BlockTravel {
  double nearest = 0;
  double farthest = 0;
};

/// Over the whole range of the crank; empty where the mechanism cannot be assembled.
std::optional<BlockTravel> block_travel(const GuideBar& mechanism);

/// The pressure angle of the bar in [0, π/2], between the block's force, across the guide, and the
/// bar's velocity at the block: sin = |e|/r, zero without offset. Empty where the mechanism does
/// not close.
std::optional<double> pressure_angle(const GuideBar& mechanism, double crank_angle);

/// The greatest pressure angle over the whole range of the crank, and over `range`, which must lie
/// in one of `crank_ranges`: where the crank comes nearest to θ = 0.
std::optional<double> greatest_pressure_angle(const GuideBar& mechanism);
std::optional<double> greatest_pressure_angle(const GuideBar& mechanism, const CrankRange& range);

}  // namespace cognate
