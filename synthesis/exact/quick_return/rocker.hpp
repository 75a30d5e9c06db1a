/// @file Crank-rockers of a given time ratio, rocker and swing.
///
/// The rocker's pivot D is the origin and the bisector of its swing φ the y axis, so that the
/// limits are C₁,₂ = (∓h, y₀) with h = l₃ sin(φ/2), y₀ = l₃ cos(φ/2). At the limits crank and
/// coupler are collinear, |AC| = l₂ ± l₁, and the crank pivot A sees C₁C₂ under θ (see
/// quick_return.hpp). In elliptic coordinates about C₁ and C₂,
///
///     |x| = l₁ l₂/h,   |y − y₀| = √((h² − l₁²)(l₂² − h²))/h,
///
/// that condition is l₁² cos²(θ/2) + l₂² sin²(θ/2) = h². With q = (l₂/h)² − 1 as the parameter of
/// an arc, t = tan(θ/2), c = cot(φ/2) and s = ∓1 for the near and the far arc, all is linear in q:
///
///     (l₁/h)² = 1 − t² q,   |y − y₀| = h t q,   l₄² = l₃² + h² q (1 − t² + 2 s c t),
///
/// so that each condition on one length has one solution on each arc, and its mirror image. The
/// linkage passes both limits on one circuit where A–D does not part C₁ from C₂: for 0 < q < q̂,
///
///     q̂ = cos(φ/2) cos(φ/2 + s θ)/sin²(θ/2),
///
/// at whose end crank, coupler, rocker and frame are collinear. Nothing here is singular at K = 1,
/// where the circles become the line C₁C₂. Graphical form: Li & Xu 2011, section 3; ranges: VDI
/// 2130.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/quick_return.hpp"

namespace cognate::synthesis {

/// What is desired: K ≥ 1, the rocker's length > 0, and its swing in (0, π).
struct RockerTask {
  double time_ratio = 1;
  double rocker = 0;
  double swing = 0;
};

/// The line a·x + b·y = c of the plane described above; a and b not both 0.
struct PivotLine {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// A crank-rocker that does the task, confirmed by the analysis kernel from its lengths alone.
struct QuickReturnRocker {
  FourBar linkage;  ///< in the plane described above
  PivotArc arc = PivotArc::near;
  bool mirror = false;   ///< A to the right of the bisector: the image of the linkage to its left
  double outer = 0;      ///< crank angle with crank and coupler extended, from the x axis
  double inner = 0;      ///< folded
  double residual = 0;   ///< the larger of the errors of θ and φ, as simulated, radians
  double condition = 1;  ///< change of A over l₂ with θ and with what was given; at least 1
  TransmissionAngles transmission;
};

/// What an arc can do: lengths strictly between these bounds, each of which is monotonic along it.
/// Infinite at K = 1 for coupler and frame, where the crank is h itself.
struct ArcLimits {
  LengthInterval crank, coupler, frame;
};

/// Empty where no pivot of the arc is the crank pivot of a crank-rocker: near, where θ ≥ 90° + φ/2;
/// far, where θ ≥ 90° − φ/2.
std::optional<ArcLimits> arc_limits(const RockerTask& task, PivotArc arc);

/// What leaves a whole curve of solutions, or none, where a length or a line is given.
enum class RockerDegeneracy {
  none,
  any_coupler,     ///< K = 1, and the crank given is the only one there is: the coupler is free
  one_frame,       ///< D is the centre of the near arc's circle: the frame is the rocker's length
  line_is_the_arc  ///< K = 1, and the line is that of C₁C₂, on which every pivot may stand
};

/// All crank-rockers of a task, and what leaves a whole curve of them.
struct RockerSolutions {
  std::vector<QuickReturnRocker> designs;  ///< near arc before far; each before its mirror image
  RockerDegeneracy degeneracy = RockerDegeneracy::none;
  int circuit_defects = 0;  ///< pivots found from which the limits lie on two circuits
};

/// All solutions with the given crank, coupler or frame, or with A on a line.
RockerSolutions rockers_with_crank(const RockerTask& task, double crank);
RockerSolutions rockers_with_coupler(const RockerTask& task, double coupler);
RockerSolutions rockers_with_frame(const RockerTask& task, double frame);
RockerSolutions rockers_on_line(const RockerTask& task, const PivotLine& line);

/// Limits of the lengths, infinite where there are none, of the longest over the shortest link, and
/// of the transmission angle BCD over the turn of the crank, radians.
struct RockerBounds {
  LengthInterval crank, coupler, frame;
  double link_ratio_max = std::numeric_limits<double>::infinity();
  double transmission_min = 0;
  double transmission_max = kPi;
};

/// Of each arc (and both mirror images) the linkage whose least transmission angle (the least of μ
/// and π − μ) is greatest within `bounds`; the better arc first. With r = (l₂/h)² it stands at the
/// one root in (1, 1 + q̂) of
///
///     r + r² + κ r³ = 1/sin²(θ/2),   κ = sin(φ/2 + s θ) sin(φ/2)/cos²((φ + s θ)/2),
///
/// or at the bound that comes first: the angle falls monotonically on both sides of the root. At
/// K = 1 it grows with the coupler, towards 90° − φ/2, and no linkage is the best: it is then taken
/// among those whose link ratio is at most `free_link_ratio`, unless a bound ends the family or
/// only longer couplers satisfy the bounds.
///
/// Where linkages of an arc have their lengths within `bounds` and none satisfies the ratio and the
/// transmission angles too, the one that comes nearest to them.
RockerSolutions best_rockers(const RockerTask& task, const RockerBounds& bounds);

/// The link ratio up to which `best_rockers` looks at K = 1: 10, or three times the least possible,
/// l₃/h, where that is more.
double free_link_ratio(const RockerTask& task);

/// The linkage of an arc, left of the bisector, whose coupler is `coupler`, at a share of the way
/// along the arc: a point of the family of all solutions.
struct RockerFamilyPoint {
  Lengths<double> links;
  Vec2d pivot_a;
  double transmission = 0;  ///< the least of μ and π − μ
};

/// `count` ≥ 2 points of an arc within `bounds`, evenly spread in h/l₂ (which is finite however far
/// the pivot), without the ends of the arc itself, where a link vanishes or all are collinear.
std::vector<RockerFamilyPoint> rocker_family(const RockerTask& task, PivotArc arc,
                                             const RockerBounds& bounds, int count);

}  // namespace cognate::synthesis
