/// @file What starts of function generation are chosen by: their errors over some of the samples.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "problems/function/starts.hpp"

namespace cognate::problems {

/// Weight of violated limits among the errors.
inline constexpr double kPenalty = 10;

/// Completes and scores generators of one problem. It must outlive this object, which any thread
/// may use.
class FunctionScreen {
 public:
  FunctionScreen(const FunctionProblem& problem, std::vector<synthesis::AnglePair> wanted);

  const FunctionProblem& problem() const { return problem_; }
  const std::vector<synthesis::AnglePair>& wanted() const { return wanted_; }
  const std::array<Range, 4>& ranges() const { return ranges_; }
  /// Whether the file leaves no choice of a length: 0 crank, 1 coupler, 2 rocker, 3 frame.
  bool fixed(int i) const { return ranges_[i].min == ranges_[i].max; }

  /// `links` in the unit of the lengths that are fixed, or of the bounds' middle, within limits.
  Lengths<double> scaled(const Lengths<double>& links) const;

  /// The nearest angle within `bounds`, modulo 2π.
  double clamped_start(double angle, const std::optional<Range>& bounds) const;

  /// With the start angles of the problem, the output's where it is given: one for both
  /// assemblies, or one for each that has the dead centre to start from.
  std::vector<FunctionGenerator> started(FunctionGenerator generator) const;

  /// Each of what `started` gives in its better assembly, with the mean square of the errors'
  /// chords and the penalty of a violated limit of the transmission angle; infinite where it does
  /// not close. In SIMD lanes; the output's start angle is not set.
  std::vector<FunctionStartPoint> screened(const std::vector<FunctionGenerator>& all) const;

  /// Sets the start angles that follow from the rest; the error is the mean square of true errors,
  /// with that penalty.
  FunctionStartPoint scored(FunctionGenerator generator) const;

  /// The better assembly of a linkage, scored.
  FunctionStartPoint best_assembly(FunctionGenerator generator) const;

 private:
  /// What a violated limit of the transmission angle counts among mean squares.
  double penalty(const FunctionGenerator& generator) const;
  bool starts_free() const { return problem_.start == FunctionStart::free; }
  std::vector<Assembly> assemblies() const;

  const FunctionProblem& problem_;
  std::vector<synthesis::AnglePair> wanted_;
  std::array<Range, 4> ranges_;
  Range sweep_;  ///< of the input from its start
};

}  // namespace cognate::problems
