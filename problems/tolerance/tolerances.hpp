/// @file `[tolerance]`: how far the dimensions of what is made may be off. Lengths are in the
/// file's unit.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/tolerance/grades.hpp"

namespace cognate::problems {

/// A dimension lies between its nominal value − minus and + plus, neither of them negative.
struct Deviation {
  double plus = 0;
  double minus = 0;
};

/// A deviation, or the grade of a standard, by which it follows from the dimension itself.
using ToleranceValue = std::variant<Deviation, ToleranceGrade>;

/// Of one dimension, or of those of one name ("coupler_point": both coordinates).
struct NamedTolerance {
  std::string dimension;
  ToleranceValue value;
};

/// The radial clearance of a pin in its hole: half the difference of their diameters.
struct PinClearance {
  std::string joint;
  double radial = 0;
};

/// How dimensions are distributed over their tolerance. `normal`: about its middle, half its width
/// being three standard deviations; `uniform`: each value as likely.
enum class ToleranceDistribution { normal, uniform };

/// What must stay within the limit of an allocation: the worst case of first order, or the root sum
/// of squares.
enum class AllocationBasis { worst_case, rss };

/// What makes a dimension dearer: its tolerance ±t costs `factor`/t.
struct CostFactor {
  std::string dimension;
  double factor = 1;
};

/// `[tolerance] allocate`: the tolerances of least cost Σ factor/t that keep the error within
/// `limit`.
struct Allocation {
  double limit = 0;  ///< of the judged quantity, in the file's unit, degrees of an angle
  AllocationBasis basis = AllocationBasis::worst_case;
  std::vector<CostFactor> costs;  ///< 1 for every dimension that is not named
};

/// `[tolerance]`.
struct Tolerances {
  std::optional<ToleranceValue> length;  ///< of every length that is not named, no pivots'
  std::optional<ToleranceValue> pivots;  ///< of each coordinate of a fixed pivot
  std::vector<NamedTolerance> dimensions;
  std::vector<PinClearance> clearances;
  ToleranceDistribution distribution = ToleranceDistribution::normal;
  int samples = 100000;             ///< of Monte Carlo; 0: none
  std::string of;                   ///< an analysis: the point judged; empty: the output
  std::optional<double> max_error;  ///< a good sample errs by no more, in degrees of an angle
  std::optional<Allocation> allocation;
};

template <>
std::span<const Named<ToleranceDistribution>> names<ToleranceDistribution>();
template <>
std::span<const Named<AllocationBasis>> names<AllocationBasis>();

}  // namespace cognate::problems
