/// @file What a file gives, bounds and demands of a linkage of any kind of problem. Angles are in
/// radians, lengths in the file's unit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/basics/range.hpp"
#include "problems/linkage/cycle/cycle_quantities.hpp"
#include "problems/linkage/cycle/operation.hpp"
#include "synthesis/optimise/loss.hpp"

namespace cognate::problems {

/// Dimensions that `[mechanism]` fixes. What is empty is found.
struct Given {
  std::optional<double> crank, coupler, rocker, frame, frame_angle;
  std::optional<Vec2d> pivot_a, pivot_d, coupler_point;
  std::optional<Assembly> assembly;
};

/// `[bounds]`. `length` has already been merged into the four links (the narrower limits hold).
struct Bounds {
  std::optional<Range> crank, coupler, rocker, frame, frame_angle;
  std::optional<Box> pivot_a, pivot_d, coupler_point;
};

/// The classes that `constraints.class` may ask for. `grashof`: any with a fully turning link.
enum class RequiredClass {
  crank_rocker,
  double_crank,
  rocker_crank,
  double_rocker,
  triple_rocker,
  grashof,
  non_grashof
};

/// `[[constraints.clearance]]`: over the full turn of the crank a point stays inside a box (its
/// working envelope) or outside (an obstacle). Sides may be infinite.
struct Clearance {
  MovingPoint point = MovingPoint::coupler_point;
  bool inside = true;
  Box box;
};

/// What a bound on the error limits: the root mean square (over the weights of a path, too) of a
/// distance or of an angle, or the largest angle of a minimax problem.
enum class ErrorMeasure { rms_length, rms_angle, largest_length, largest_angle };

/// Whether the error is an angle, not a length.
constexpr bool is_angle(ErrorMeasure of) {
  return of == ErrorMeasure::rms_angle || of == ErrorMeasure::largest_angle;
}

/// `constraints.rms_error_max`, `max_error_max`, `rms_error_deg_max` or `max_error_deg_max`:
/// lengths or radians.
struct ErrorLimit {
  ErrorMeasure of = ErrorMeasure::rms_length;
  double max = 0;
};

/// `[constraints]` common to linkages. The transmission angle is the angle BCD in [0, π].
struct Constraints {
  std::optional<RequiredClass> required_class;
  std::optional<Range> transmission_angle;
  std::optional<double> link_ratio_max;
  std::optional<Range> time_ratio;  ///< K ≥ 1, of a crank-rocker
  std::optional<Box> pivot_region;
  /// Over the full turn of a crank of class crank_rocker or double_crank; see cycle_limits.hpp.
  std::vector<Clearance> clearances;
  CycleValues cycle_max;   ///< infinite: known of designs, but not limited
  Operation operation;     ///< under which those are meant
  bool full_turn = false;  ///< the crank must turn fully, as for a closed curve
  /// Ranges of crank, coupler, rocker and frame into which one factor for all of them must bring
  /// the lengths; no key of the file, but what bounds leave of a path that may be enlarged.
  std::optional<std::array<Range, 4>> proportions;
  std::optional<ErrorLimit> error;
  bool no_branch_defect = true;
  bool no_order_defect = true;
  bool no_circuit_defect = true;
  bool no_extra_loop = false;  ///< of a closed curve: the whole coupler curve follows it
};

/// Whether a greatest value is given, and less than infinite.
inline bool is_limit(const std::optional<double>& most) {
  return most && std::isfinite(*most);
}

/// Whether a limit over the full turn of the crank is among them.
inline bool limits_turn(const Constraints& constraints) {
  return !constraints.clearances.empty() ||
         std::ranges::any_of(constraints.cycle_max.values, is_limit);
}

/// Whether free points are met one after the other along the motion.
enum class PointOrder { cyclic, any };

/// `solve.objectives`: what of a design is to be best; from `over_cycle` on the quantities over the
/// cycle in their order.
enum class DesignObjective { error, transmission_angle, link_ratio, size, over_cycle };

/// The objective that makes a quantity over the cycle best.
constexpr DesignObjective objective_of(CycleQuantity quantity) {
  return DesignObjective(static_cast<std::size_t>(DesignObjective::over_cycle) +
                         index_of(quantity));
}

/// Whether it is one of those.
constexpr bool is_over_cycle(DesignObjective objective) {
  return objective >= DesignObjective::over_cycle;
}

/// `[solve]`.
struct Solve {
  synthesis::Solver solver = synthesis::Solver::automatic;  ///< `auto`: the problem's own choice
  std::optional<int> starts;  ///< how many starts are refined; empty: chosen by the problem
  int designs = 3;            ///< how many different designs to return, 1…100
  std::vector<DesignObjective> objectives;       ///< empty: the error alone
  synthesis::Loss loss = synthesis::Loss::none;  ///< what an error counts for; least squares only
  double loss_scale = 1;            ///< the error from which the loss differs: length or radians
  std::optional<double> tolerance;  ///< relative change of the error at which a refinement stops
  bool certify = false;             ///< prove how near the best design is to the best possible
  double certify_gap = 1e-3;        ///< the relative gap at which a certificate is complete
  /// With tolerances: the share of what is made whose error is to be least; 1: of all that they
  /// allow, its worst case.
  std::optional<double> robust{};
};

/// `[warnings]`: from where on designs that meet every constraint are warned of; see warnings.hpp.
struct WarningLimits {
  double transmission_angle = 30 * kDegree;  ///< below which its acute value, in radians
  double link_over_target = 10;              ///< longest link over the target's diameter
  double pivot_over_target = 10;             ///< distance of a fixed pivot over it
  double link_ratio = 20;                    ///< longest over shortest link
  double condition = 1e4;                    ///< of the equations of an exact synthesis
};

template <>
std::span<const Named<Assembly>> names<Assembly>();
template <>
std::span<const Named<MobilityClass>> names<MobilityClass>();
template <>
std::span<const Named<RequiredClass>> names<RequiredClass>();
template <>
std::span<const Named<MovingPoint>> names<MovingPoint>();
template <>
std::span<const Named<MovingLink>> names<MovingLink>();
template <>
std::span<const Named<synthesis::Solver>> names<synthesis::Solver>();
template <>
std::span<const Named<PointOrder>> names<PointOrder>();
template <>
std::span<const Named<DesignObjective>> names<DesignObjective>();
template <>
std::span<const Named<ErrorMeasure>> names<ErrorMeasure>();
template <>
std::span<const Named<synthesis::Loss>> names<synthesis::Loss>();

}  // namespace cognate::problems
