/// @file What a four-bar can do, from its link lengths alone: nothing here computes a position.
#pragma once

#include <optional>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/assembly.hpp"

namespace cognate {

/// Grashof's classes by the link that turns fully. The crank is the driven link A–B.
enum class MobilityClass { crank_rocker, double_crank, rocker_crank, double_rocker, triple_rocker };

/// Grashof's criterion, shortest + longest ≤ sum of the other two, and which of crank and rocker
/// turns fully: crank alone (it is the shortest) → crank-rocker, both (the frame is) →
/// double-crank, rocker alone → rocker-crank, neither (the coupler is) → double-rocker; no link
/// turns fully against another: triple rocker.
///
/// A change point (equality within `kChangePointTolerance`) counts as Grashof: it has the class
/// that it borders. Only there can two links be the shortest, and both of them turn against their
/// neighbours: parallelograms, rhombi and kites whose frame is one of the two short links are
/// double-cranks, a kite with short crank and coupler is a crank-rocker, one with short coupler and
/// rocker a rocker-crank.
///
/// Here and below lengths are positive and finite, and the results do not depend on their unit.
MobilityClass mobility_class(const Lengths<double>& links);

/// Four-bars with a change point, by which of their links are equal.
enum class ChangePointClass {
  none,           ///< shortest + longest differs from the sum of the other two
  single,         ///< equal sums alone: one such position
  parallelogram,  ///< opposite links equal: it moves as parallelogram or as antiparallelogram
  kite_b_on_d,    ///< crank = frame and coupler = rocker: B can lie on D
  kite_c_on_a,    ///< crank = coupler and rocker = frame: C can lie on A
  rhombus         ///< all equal
};

/// Which sums of two lengths are equal within `kChangePointTolerance`.
struct EqualSums {
  bool first = false;   ///< l₃ + l₄ = l₁ + l₂
  bool second = false;  ///< l₂ + l₄ = l₁ + l₃
  bool third = false;   ///< l₁ + l₄ = l₂ + l₃
};
EqualSums equal_sums(const Lengths<double>& links);

/// By `equal_sums`: two of them make lengths equal in pairs.
ChangePointClass change_point_class(const Lengths<double>& links);

/// Shortest + longest − the other two, relative to the longest: negative for Grashof linkages,
/// within a few units of rounding of zero at a change point.
double grashof_excess(const Lengths<double>& links);

/// Whether the linkage is at a change point: all its links can lie on one line.
bool is_change_point(const Lengths<double>& links);

/// Whether the links can form a closed loop at all: longest ≤ sum of the others.
bool can_assemble(const Lengths<double>& links);

/// Whether the crank turns fully: d = |B − D| takes every value between |l₄ − l₁| and l₄ + l₁,
/// which holds for a Grashof linkage whose crank or frame is the shortest link. True within
/// rounding of a change point as `is_change_point` has it.
bool crank_rotates(const Lengths<double>& links);

/// Whether the rocker turns fully, as the crank does in `crank_rotates`.
bool rocker_rotates(const Lengths<double>& links);

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
