/// @file What a finished mechanism of any type is, and whether it satisfies its problem, computed
/// by the analysis kernel from the mechanism alone. Of a four-bar it is what `verify.hpp` says.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// Where a mechanism stands: the coordinate of its drive (angle from the x axis of a crank or a
/// floating link, displacement of a driving slider) and on which side each dyad is assembled, +1 or
/// −1; dyads that have one side alone are not looked at.
struct DriveState {
  double drive = 0;
  std::vector<double> sides;
};

/// Class (in `quantities` for what is no four-bar), transmission angles, time ratio and defects of
/// a mechanism that is to pass through `states` in `order`. It is described in the assembly of the
/// first of them.
///
/// The motion used is the full turn of a drive that turns fully, else the range between the states;
/// where these do not lie in one range, all ranges. Defects: `branch` for a dyad on another side
/// than at first; `circuit` where that side is beyond no dead point of this dyad, for states in
/// different ranges of the drive, and where it cannot be assembled; `order` as for four-bars.
/// Drives closer than 1e-7 (of a radian, or of the drive's scale) count as equal. A mechanism
/// without dyads, whose guided link is itself the drive, has the transmission angle 90°.
///
/// `quantities` add "class" and what `motion_summary.hpp` says of the output.
Metrics mechanism_metrics(const NamedMechanism& mechanism, std::span<const DriveState> states,
                          PointOrder order);

/// The lengths that a mechanism of a type has, by the keys of `[bounds]`.
struct LinkLengths {
  std::optional<double> crank, coupler, rocker, frame;
};
LinkLengths link_lengths(const NamedMechanism& mechanism);

/// Longest over shortest of the links that there are; 1 for fewer than two.
double link_ratio(const LinkLengths& links);

/// Everything that `[bounds]` (lengths and pivots, and of a four-bar its other places too) and
/// `[constraints]` demand, one check for each number they limit, named as `check_constraints` of
/// `verify.hpp` does. `pivot_a` limits the fixed pivot A, which is the driven one, `pivot_d` the
/// other, D; `pivot_region` every named point of the frame. A length or a pivot that the type does
/// not have is not limited.
///
/// Classes are those of four-bars. Of other types `crank-rocker` means a crank that turns fully,
/// `grashof` that some link does, `triple-rocker` and `non-grashof` that none does; no such type is
/// of another class.
std::vector<ConstraintCheck> check_constraints(const Constraints& constraints, const Bounds& bounds,
                                               const NamedMechanism& mechanism,
                                               const Metrics& metrics);

}  // namespace cognate::problems
