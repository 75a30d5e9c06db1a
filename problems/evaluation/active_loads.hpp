/// @file Which loads act at a position of the mechanism.
#pragma once

#include <span>
#include <vector>

#include "analysis/mechanism/forces.hpp"
#include "analysis/mechanism/motion_state.hpp"
#include "analysis/mechanism/travel.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

/// The ends of a body's travel over the whole motion, counted as `travelled` does (see
/// analysis/mechanism/travel.hpp): least and greatest displacement along its slide; of a body that
/// turns the angles counter-clockwise from one to the other.
struct Stroke {
  double least = 0;
  double greatest = 0;
};

/// Decides which loads act; prepared once, allocates nothing after.
///
/// The sense of a body is that of its own travel: a body that slides advances in the direction of
/// its guide or slot (relative to the body that has it); one that turns, floating links included,
/// counter-clockwise. A load with a sense does not act on a body at rest; slower than what rounding
/// leaves of the mechanism's greatest velocity, 64 ε, is at rest. The ends of `between` and
/// `within_stroke` belong to them, to within 1e-12 of a radian or of the stroke.
class ActiveLoads {
 public:
  /// `strokes`: of the body of each rule; needed only where a rule has `within_stroke`.
  ActiveLoads(const Mechanism<double>& mechanism, std::span<const LoadRule> rules,
              std::span<const Stroke> strokes = {});

  /// Those that act at the drive coordinate `drive` (radians, or a driving slider's displacement),
  /// which changes at `speed`. Valid until the next call.
  template <int Order>
  std::span<const Load> at(double drive, double speed,
                           std::span<const BodyMotion<double, Order>> bodies);

 private:
  struct Scheduled {
    LoadRule rule;
    Travel travel;
    Stroke stroke;
  };

  bool in_interval(const LoadRule& rule, double drive) const;

  bool drive_turns_;
  std::vector<Scheduled> scheduled_;
  std::vector<Load> active_;
};

}  // namespace cognate::problems
