/// @file Following one solution of a path problem with given parts while the data change.
#pragma once

#include <complex>
#include <vector>

#include "synthesis/exact/nine_point/side_condition.hpp"

namespace cognate::synthesis::constrained {

using Complex = std::complex<double>;

/// The data of a problem over the complex numbers, where bars are independent: displacements, the
/// rotations of the first `t.size()` of them, and conditions; 2·t + (d − t) + conditions = 8.
template <class Real>
struct DataOf {
  std::vector<std::complex<Real>> d, d_bar, t;
  std::vector<SideConditionOf<Real>> conditions;
};
using Data = DataOf<double>;

/// A solution: the pivots and the logarithms of the rotations that are not given.
template <class Real>
struct StateOf {
  PivotUnknowns<std::complex<Real>> pivots{};
  std::vector<std::complex<Real>> log_t;
};
using State = StateOf<double>;

enum class PathEnd { finite, infinite, lost };

struct TrackedPath {
  PathEnd end = PathEnd::lost;
  State state;
};

/// How carefully a path is followed.
struct TrackingTolerances {
  double largest_step = 0.1;
  double first_correction = 3e-4;  ///< of Newton's method, relative, beyond which a step is halved
  bool extended = false;           ///< `long double`, where paths stall in the noise of doubles
};

/// Follows `start`, a solution of `from`, to the data `to` on the segment between them: Runge and
/// Kutta's method of order four, corrected by Newton's. `infinite`: a pivot grows beyond all
/// bounds.
TrackedPath follow(const State& start, const Data& from, const Data& to,
                   const TrackingTolerances& care);

/// Newton's method until it stalls; false where it does not converge.
bool converge(State& state, const Data& data);

/// What is known of a solution at its data.
struct Quality {
  double residual = 0;   ///< as PathRoot has it
  double condition = 0;  ///< as PathRoot has it: Frobenius norm of the pivots' derivatives
};
Quality quality(const State& state, const Data& data);

/// How many of the equations, eight at most, are independent at a state.
int rank(const State& state, const Data& data);

}  // namespace cognate::synthesis::constrained
