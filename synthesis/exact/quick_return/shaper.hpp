/// @file The shaper's six-bar of a given time ratio and stroke: a guide-bar that pushes a ram
/// through a connecting rod.
///
/// The bar, of length L about C, swings by θ symmetrically about the perpendicular to the ram's
/// line, so that its end stands equally high at both limits and the stroke is H = 2 L sin(θ/2),
/// for any height of the ram's line and the length of the rod (Li & Xu 2011, example 1-4).
/// Between the limits the end of the bar rises by L (1 − cos(θ/2)). The rod, a two-force member,
/// leans least where the ram's line halves that rise, at L cos²(θ/4) above C.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "synthesis/exact/quick_return/quick_return.hpp"

namespace cognate::synthesis {

/// What is desired and given: K > 1 and the stroke, the frame or the crank, and of the connecting
/// rod its length or the pressure angle, in (0, π/2), that the ram may reach. All lengths positive.
struct ShaperTask {
  double time_ratio = 2;
  double stroke = 0;
  std::optional<double> frame, crank;
  std::optional<double> rod, pressure;
  std::optional<double> ram_height;  ///< of the ram's line over C; empty: where the rod leans least
};

/// C in the origin, the crank pivot at (0, frame), the ram on y = ram_height and ahead of the bar's
/// end towards −x, where it goes slowly with a crank turning counter-clockwise.
struct Shaper {
  double crank = 0;
  double frame = 0;
  double bar = 0;
  double rod = 0;
  double ram_height = 0;
  double pressure = 0;  ///< the steepest pressure angle of the ram, radians
};

/// Every way out.
enum class ShaperOutcome {
  solved,
  no_swing,   ///< K = 1: the bar would not swing
  short_rod,  ///< the rod does not reach from the bar's end to the ram's line everywhere
  overshoot   ///< the rod leans so far that the ram turns back before the bar does
};

/// The shaper, where `outcome` is `solved`.
struct ShaperSolution {
  ShaperOutcome outcome = ShaperOutcome::solved;
  Shaper shaper;
};

/// Whether the ram of a shaper whose dimensions are all given turns back where the bar does, and
/// only there; sets its pressure angle. `half_swing`: of the bar.
ShaperOutcome judge(Shaper& shaper, double half_swing);

/// The shaper of a task, or why there is none.
ShaperSolution shaper(const ShaperTask& task);

/// The crank (body 1), the block (2) and the bar (3), the rod (4) and the ram (5).
Mechanism<double> as_mechanism(const Shaper& shaper);

/// What the ram does over a turn of the crank, as the analysis kernel follows it.
struct RamMotion {
  double stroke = 0;
  double time_ratio = 1;
  double left = 0;   ///< crank angle from the x axis at the ram's left limit
  double right = 0;  ///< at its right one
};
std::optional<RamMotion> simulate(const Shaper& shaper);

}  // namespace cognate::synthesis
