/// @file A four-bar as a function generator, and how far it is from what is requested.
#pragma once

#include <optional>
#include <span>

#include "analysis/linkage/closure.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A four-bar in one assembly with the angles from which input and output are counted, measured
/// from the directed line A→D.
struct FunctionGenerator {
  Lengths<double> links;
  Assembly assembly = Assembly::open;
  double input_start = 0;
  double output_start = 0;
};

/// `angle` less whole turns, in [−π, π].
double wrapped(double angle);

/// Structural errors of one generator: output angle obtained minus wanted, in (−π, π].
class StructuralError {
 public:
  explicit StructuralError(const FunctionGenerator& generator);

  /// Empty where the linkage does not close.
  std::optional<double> at(const synthesis::AnglePair& wanted) const;

  /// The sum of squares over `wanted`, infinite where the linkage does not close at one of them.
  double sum_of_squares(std::span<const synthesis::AnglePair> wanted) const;

  /// The pairs of the domain where |e| is greatest locally and at least half of what it is
  /// anywhere, between samples too; see `error_peaks`. Empty for angle pairs, and where the linkage
  /// does not close over the domain.
  std::vector<synthesis::AnglePair> peaks(const FunctionSamples& wanted) const;

  /// Whether the input turns over the whole of `sweep`, increments from its start, by the ranges of
  /// the crank (`crank_ranges`).
  bool closes_over(const Range& sweep) const;

  /// Σ e², its root mean and max |e| over the samples, the maximum over the whole domain for
  /// functions. All infinite where the linkage does not close at the samples; where it does not
  /// between them the maximum is that of the samples.
  TargetError over(const FunctionSamples& wanted) const;

 private:
  FunctionGenerator generator_;
  Closure<double> closure_;
};

/// The linkage with A at the origin and D on the positive x axis.
FourBar four_bar(const FunctionGenerator& generator);

/// The start angle of the output that minimises the sum of squares for small errors: the mean
/// direction of the output obtained less the increments wanted. Empty where the linkage does not
/// close at one of them.
std::optional<double> best_output_start(const FunctionGenerator& generator,
                                        std::span<const synthesis::AnglePair> wanted);

}  // namespace cognate::problems
