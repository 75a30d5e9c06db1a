/// @file Minima of a motion search on their way: their order and their merging.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/guidance/fit.hpp"
#include "problems/guidance/starts.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {

/// Violations of a model's constraints up to this count as none: less than the checks of a design
/// allow, which are relative to its own links. Refinements go to a tenth.
inline constexpr double kMotionFeasibility = 1e-10;

/// A start, or what has been made of it.
struct MotionFound {
  MotionMinimum minimum;
  bool valid = false;
  int hits = 1;          ///< how many starts have come here
  double violation = 0;  ///< of the file's constraints by the finished design, defects included
};

/// The point of a start, not yet refined.
MotionMinimum begun(const MotionProblem& problem, const MotionStart& start);

/// How far the design of a minimum violates what the file demands, by whichever dyad may drive.
double design_violation(const MotionProblem& problem, const MotionMinimum& minimum);

/// Feasible ones first, then by objective or violation.
bool is_better(const MotionMinimum& a, const MotionMinimum& b);

/// Whether a refinement has ended with less than it began with: a sound design is not given up.
bool is_worse(const MotionFound& refined, const MotionFound& before);

/// How minima are ranked (sound designs first, then by the solver's measure) and distinguished.
struct MotionRules {
  using Candidate = MotionFound;

  static bool has_value(const MotionFound& found) { return found.valid; }
  static bool precedes(const MotionFound& a, const MotionFound& b);
  /// Of one form, and closer than `tolerance`.
  static bool is_same(const MotionFound& known, const MotionFound& other, double tolerance);
  static double value(const MotionFound& found);
  /// Whether both meet the poses to rounding, which none does better.
  static bool is_near(const MotionFound& best, const MotionFound& other) {
    return value(best) <= kMetExactly && value(other) <= kMetExactly;
  }
  /// At least a third of the places are for those that are not sound, which further refinement may
  /// mend.
  static void keep(std::vector<MotionFound>& sorted, std::size_t most);
};

}  // namespace cognate::problems
