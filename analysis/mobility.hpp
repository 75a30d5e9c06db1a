/// @file What a four-bar can do, from its link lengths alone: nothing here computes a position.
#pragma once

#include <optional>
#include <vector>

#include "analysis/four_bar.hpp"

namespace cognate {

/// Grashof's classes by the link that turns fully. The crank is the driven link A–B.
enum class MobilityClass { crank_rocker, double_crank, rocker_crank, double_rocker, triple_rocker };

/// Grashof's criterion, shortest + longest ≤ sum of the other two, and which link is the shortest:
/// crank → crank-rocker, frame → double-crank, rocker → rocker-crank, coupler → double-rocker; no
/// link turns fully: triple rocker. A change point (equality) counts as Grashof. Only there can two
/// links be the shortest; the first of crank, frame, rocker, coupler then names the class, so that
/// a parallelogram with a short crank is a crank-rocker.
///
/// Here and below lengths are positive and finite, and the results do not depend on their unit.
MobilityClass mobility_class(const Lengths<double>& links);

/// Shortest + longest − the other two, relative to the longest: negative for Grashof linkages,
/// within a few units of rounding of zero at a change point.
double grashof_excess(const Lengths<double>& links);

/// Whether the linkage is at a change point: |grashof_excess| ≤ 16 ε.
bool is_change_point(const Lengths<double>& links);

/// Whether the links can form a closed loop at all: longest ≤ sum of the others.
bool can_assemble(const Lengths<double>& links);

/// Whether the crank turns fully: d = |B − D| takes every value between |l₄ − l₁| and l₄ + l₁,
/// which holds for a Grashof linkage whose crank or frame is the shortest link. True within
/// rounding of a change point as `is_change_point` has it.
bool crank_rotates(const Lengths<double>& links);

/// A range of the crank angle counted counter-clockwise from A→D, `from` ≤ `to` ≤ `from` + 2π.
struct CrankRange {
  double from = 0;
  double to = 0;
};

/// Where the linkage closes: [0, 2π] for a crank that turns fully; one range about the direction
/// towards or away from D for a triple rocker; two ranges, mirror images in A–D, for the other
/// Grashof linkages; none where the links cannot be assembled. From tan²(θ/2) with d = |l₂ − l₃|
/// and d = l₂ + l₃.
std::vector<CrankRange> crank_ranges(const Lengths<double>& links);

/// Least and greatest transmission angle μ = ∠BCD in [0, π].
struct TransmissionAngles {
  double min = 0;
  double max = 0;
  double acute_min = 0;  ///< the least of min(μ, π − μ)
};

/// Over the whole range of the crank: tan²(μ/2) = (d² − (l₂ − l₃)²)/((l₂ + l₃)² − d²) with d = |B −
/// D| at its extremes, |l₄ ∓ l₁| for a crank that turns fully. At a limit of the crank's range μ is
/// 0 or π. Not numbers where the links cannot be assembled.
TransmissionAngles transmission_angles(const Lengths<double>& links);

/// Over `range` alone: at its ends, and where crank and frame are collinear if that lies inside.
TransmissionAngles transmission_angles(const Lengths<double>& links, const CrankRange& range);

/// The positions of the follower where crank and coupler are collinear; angles from A→D for the
/// `open` assembly (the mirror image, all angles negated, for `crossed`). `outer`: extended, A–C =
/// l₁ + l₂; `inner`: folded, A–C = |l₂ − l₁|. Empty where that position does not exist, and where C
/// falls on A, which leaves the crank's direction open. In [−π, π].
struct LimitPosition {
  double crank_angle = 0;
  double rocker_angle = 0;
};
std::optional<LimitPosition> outer_limit(const Lengths<double>& links);
std::optional<LimitPosition> inner_limit(const Lengths<double>& links);

/// The time ratio K ≥ 1 = (π + θ)/(π − θ) of a crank-rocker, θ the angle between the crank's two
/// limit directions; empty where the crank does not turn fully or the follower has no limits.
std::optional<double> time_ratio(const Lengths<double>& links);

}  // namespace cognate
