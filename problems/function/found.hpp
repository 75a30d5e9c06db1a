/// @file Minima of a function search on their way: their order, their merging, their refinement.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/function/generator.hpp"
#include "problems/function/model.hpp"
#include "problems/function/samples.hpp"
#include "problems/function/starts.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// Violations of a model's constraints up to this count as none: less than the checks of a design
/// allow, which are relative to its own links. Refinements go to a tenth.
inline constexpr double kFunctionFeasibility = 1e-10;

/// The problem as it stands and with each class whose crank turns fully.
class ConfinedFunctions {
 public:
  explicit ConfinedFunctions(const FunctionProblem& problem);

  const FunctionProblem& plain() const { return plain_; }
  /// The problem that a search from a linkage of these lengths stays in: see `confining_class`.
  const FunctionProblem& of(const Lengths<double>& links) const;
  /// Of a linkage whose crank does not turn fully, the problem confined to its class: to stay where
  /// limits are those of the part used.
  const FunctionProblem& staying(const Lengths<double>& links) const;

 private:
  FunctionProblem plain_, crank_rocker_, double_crank_, rocker_crank_, double_rocker_,
      triple_rocker_;
};

/// A start, or what has been made of it, and the problem it is confined to.
struct FunctionFound {
  FunctionGenerator generator;
  StartOrigin origin = StartOrigin::search;
  const FunctionProblem* problem = nullptr;
  double objective = 0;
  double violation = 0;
  bool valid = false;
  int hits = 1;  ///< how many starts have come here
};

/// Feasible ones first, then by objective or violation.
bool is_better(const FunctionFound& a, const FunctionFound& b);

/// How minima are ranked and distinguished.
struct FunctionRules {
  using Candidate = FunctionFound;

  static bool has_value(const FunctionFound& found) { return found.valid; }
  static bool precedes(const FunctionFound& a, const FunctionFound& b) { return is_better(a, b); }
  /// Confined to the same class, and closer than `tolerance` in the logarithms of lengths and in
  /// angles.
  static bool is_same(const FunctionFound& known, const FunctionFound& other, double tolerance);
  static void absorb(FunctionFound& known, const FunctionFound& same);
  static double value(const FunctionFound& found);
  /// Whether their objectives agree to a hundredth, or are rounding: refinements that end early
  /// stop at places of their own near one minimum.
  static bool is_near(const FunctionFound& best, const FunctionFound& other);
};

/// Refines minima of one problem and counts the work. What it is made of must outlive it.
///
/// A minimum whose crank turns fully, though it was confined to no class, is confined to the class
/// that it has reached, so that its transmission angle is limited over the full turn, as the check
/// of the design has it. Where the class that its start had leads to a better one within, that
/// counts: many optima lie at the border of two classes.
class FunctionRefiner {
 public:
  FunctionRefiner(const ConfinedFunctions& confined, const Run& run, const Deadline& deadline)
      : confined_(confined), run_(run), deadline_(deadline) {}

  const ConfinedFunctions& confined() const { return confined_; }

  /// Gives `found` the class that it has reached, and drops what was known of it; false if it has
  /// one already, or needs none.
  bool confine(FunctionFound& found) const;

  /// Confines `found`, whose crank does not turn fully, to the class that it has; what was known of
  /// it is dropped.
  void stay(FunctionFound& found) const;

  /// Goes on from where `found` stands, by the loss of the problem; keeps the result
  /// unless it is worse by the same objective.
  void refine(FunctionFound& found, const FunctionSamples& wanted, synthesis::Objective objective,
              synthesis::Solver solver, int iterations) const;

  const synthesis::WorkCounter& solved() const { return solved_; }

 private:
  void refine_once(FunctionFound& found, const FunctionSamples& wanted,
                   synthesis::Objective objective, synthesis::Solver solver, int iterations) const;

  const ConfinedFunctions& confined_;
  const Run& run_;
  const Deadline& deadline_;
  synthesis::WorkCounter solved_;
};

}  // namespace cognate::problems
