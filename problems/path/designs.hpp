/// @file Paths found as designs: checked, without repetition, cognates beside them, best first.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// The root of the mean square of which an objective of the search is the weighted sum.
double rms_of(const PathProblem& problem, double sum_of_squares);

// What error_limit.hpp and objectives.hpp ask of a kind, found by the type of its problem.

/// What the error of a problem is: the root mean square distance, squares by their weights. A
/// smaller one means a smaller objective.
ErrorMeasure error_measure(const PathProblem& problem);

/// That error of a design, a length.
double error_of(const PathProblem& problem, const Design& design);

/// Errors up to this are rounding: the target is met.
double met_error(const PathProblem& problem);

/// The designs of a problem, which must outlive them.
class PathDesigns {
 public:
  /// `size`: of the path, in the file's unit.
  PathDesigns(const PathProblem& problem, double size);

  /// Adds the design and its timed cognate, unless they are known.
  void add(const FourBar& linkage, const std::vector<double>& crank_angles, std::string origin);

  /// Adds a design that is on the raster, where its cognates are not.
  void add_alone(const FourBar& linkage, const std::vector<double>& crank_angles);

  /// A design that meets every constraint; empty where one does not.
  std::optional<Design> accepted(const FourBar& linkage,
                                 const std::vector<double>& crank_angles) const;

  bool any_feasible() const { return !feasible_.empty(); }

  /// Those that break a constraint and are better than any that does not, best first.
  std::vector<Design> better_but_violating() const;

  /// By their errors.
  void sort();

  /// The best designs, with cognates named: feasible ones if there are any. Among those that meet
  /// the points to rounding the better transmission angle comes first.
  std::vector<Design> take();

 private:
  double objective(const Design& design) const;
  Design verified(const FourBar& linkage, const std::vector<double>& crank_angles) const;
  Design verified(const FourBar& linkage, std::span<const Vec2d> targets,
                  const std::vector<double>& crank_angles) const;
  Design moved(const FourBar& linkage, const std::vector<double>& crank_angles) const;
  void judge_following(Design& design) const;
  bool add_one(const FourBar& linkage, const std::vector<double>& crank_angles);
  bool insert(Design design);

  const PathProblem& problem_;
  double exact_below_;
  std::string origin_;  ///< of the designs that are being added
  std::vector<Design> feasible_, violating_;
};

}  // namespace cognate::problems
