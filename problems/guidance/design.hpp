/// @file Two dyads that guide a body as a design: the mechanism, how it is judged, what it reaches.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "problems/basics/quantity_key.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/exact/motion/guided_mechanism.hpp"

namespace cognate::problems {

/// Of the body's first axis in its link's axes.
inline constexpr AngleKey kBodyAngleKey{"body_angle_in_link_deg"};
/// The greatest over all poses.
inline constexpr AngleKey kAngleErrorKey{"angle_error_max_deg"};

/// The error of a body that misses its poses by these distances.
TargetError error_of(std::span<const double> misses);

/// Two dyads of a problem; the first is driven where it can be.
struct DyadPair {
  synthesis::GuidingDyad first;
  synthesis::GuidingDyad second;
};

/// The longest of links, coupler and frame; 0 where a pair has none of them.
double longest_link(const DyadPair& pair);

/// How good a mechanism is: `violation` of its constraints first (see verify.hpp), then `merit`:
/// the least acute transmission angle in radians, and a tenth of that at the poses alone (which
/// distinguishes linkages that pass through a change point; of two slides, of their angle), less
/// 0.1·ln(1 + longest link/extent of the poses), and for the greatest ratio of lengths of links and
/// ways of slides less 0.02·ln(ratio/3) beyond 3 and less 0.2·ln(ratio/10) beyond 10; a ratio
/// beyond 1000 is worse than all others.
struct Judgement {
  double violation = 0;
  double merit = 0;

  bool is_better_than(const Judgement& other) const {
    return violation != other.violation ? violation < other.violation : merit > other.merit;
  }
};

/// Empty where the dyads make no mechanism, or one whose numbers are none. `reached`: where the
/// body stands at each pose of the problem, on both dyads.
std::optional<Judgement> judge(const MotionProblem& problem, const DyadPair& pair,
                               std::span<const synthesis::Pose> reached);
/// Of dyads that guide the body exactly.
std::optional<Judgement> judge(const MotionProblem& problem, const DyadPair& pair);

/// The design of a pair that `judge` accepts. Its error is the distance of the body's origin, as
/// the kernel places it at the drive positions, from the poses; `quantities` hold the error of the
/// angle, the dyads, and how the body's axes lie in its link. Empty where rounding keeps the body
/// from its poses by more than a part in 1e6 of their extent.
std::optional<Design> motion_design(const MotionProblem& problem, const DyadPair& pair,
                                    const std::string& origin);

/// The design of a pair by least squares, its body standing at `reached` where it is nearest to the
/// problem's poses: its error counts places and, weighted, angles, and `quantities` have their
/// errors apart. Empty where the dyads make no mechanism or the kernel cannot place it.
std::optional<Design> nearest_design(const MotionProblem& problem, const DyadPair& pair,
                                     std::span<const synthesis::Pose> reached,
                                     const std::string& origin);

/// The dyads of a design that is a four-bar, its crank's first; the inverse of the former two.
/// Empty of any other design.
std::optional<DyadPair> pair_of(const MotionProblem& problem, const Design& design);

/// The mechanism with the names that users know its parts by; the body's origin is its coupler
/// point, or a point "P" of its link.
NamedMechanism named_mechanism(const synthesis::GuidedMechanism& guided);

}  // namespace cognate::problems
