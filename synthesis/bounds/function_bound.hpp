/// @file A lower bound of the structural error of a function generator over a box of proportions.
///
/// Over a box each output angle is affine in the position in the box up to a small rest (see
/// proportion_box.hpp), so the sum of squared errors is a convex quadratic of at most four
/// variables up to a term of the errors times that rest. The output's start angle, where it is
/// free, is the mean of the errors. Angles count less whole turns.
#pragma once

#include <optional>
#include <vector>

#include "synthesis/bounds/path_bound.hpp"
#include "synthesis/bounds/proportion_box.hpp"

namespace cognate::synthesis {

enum class LimitOfOutput { outer, inner };  ///< crank and coupler extended or folded

/// The crank angle from A→D at a limit position, over the first three sides of a box.
struct LimitAngle {
  double middle = 0;  ///< at the box's middle
  /// For t in [−1, 1]³ the angle exceeds `middle` by slope·t, up to `radius`.
  std::array<double, 3> slope{};
  double radius = 0;
  double reach = 0;  ///< by how much it may differ from `middle` in all
};

/// Empty where no linkage of the box has that limit position. From the triangle A–C–D with the side
/// A–C = l₁ + l₂ or l₂ − l₁, its terms divided by l₂ + l₃ so that infinite lengths are no
/// exception.
std::optional<LimitAngle> limit_angle(const ProportionBox& box, LimitOfOutput limit);

/// What is desired: increments of input and output angle from their starts.
struct DesiredFunction {
  std::vector<double> input, output;
  std::optional<double> output_start;  ///< from A→D; empty: free, or that of `start`
  /// Where the input starts: at the box's phase, or at a limit position of the output, whose angle
  /// then is the output's start.
  std::optional<LimitOfOutput> start;
  LengthLimits lengths;
};

/// Bounds of Σ e² over boxes.
class FunctionBound {
 public:
  FunctionBound(DesiredFunction wanted, const ProportionLimits& limits);

  /// No more than the sum of squares anywhere in the box, at most `wanted`. Infinite where no
  /// linkage of the box satisfies the limits.
  BoxBound operator()(const ProportionBox& box, double wanted) const;

 private:
  struct ErrorRange;

  bool enclose(const ProportionBox& box, std::vector<DirectionRange>& directions) const;
  std::vector<ErrorRange> errors(const std::vector<DirectionRange>& directions) const;
  double bound(const std::vector<DirectionRange>& directions, double wanted) const;

  DesiredFunction function_;
  ProportionLimits limits_;
  bool refers_;  ///< whether errors count from the first direction: the output at the start
  bool free_;    ///< whether the output may start anywhere
};

}  // namespace cognate::synthesis
