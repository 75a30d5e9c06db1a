/// @file The last digits of a root: Newton's method on the equations as they were asked.
#pragma once

#include <Eigen/Core>

namespace cognate::synthesis {

template <int N>
using Unknowns = Eigen::Matrix<double, N, 1>;

/// N equations in N unknowns at some point: values and their derivatives.
template <int N>
struct Linearised {
  Unknowns<N> value;
  Eigen::Matrix<double, N, N> slope;
};

/// A root as far as the equations resolve it.
template <int N>
struct Root {
  Unknowns<N> x;
  double residual = 0;  ///< largest |equation|
  double condition = 0;  ///< ‖J‖₁‖J⁻¹‖₁ of the slopes with columns scaled to unit length; infinite
                         ///< where J is singular
};

/// What Newton's method takes from the unknowns.
template <int N>
Unknowns<N> newton_step(const Linearised<N>& here);

/// `Root::condition` of these slopes.
template <int N>
double slope_condition(const Eigen::Matrix<double, N, N>& slope);

/// `x` after a few steps of Newton's, each kept only where it lessens the largest residual.
/// `equations(x)` gives a `Linearised<N>`, N being 3, 4 or 5. Nothing is allocated.
template <int N, class Equations>
Root<N> polish(const Equations& equations, const Unknowns<N>& start) {
  constexpr int kSteps = 4;
  const auto largest = [](const Unknowns<N>& value) { return value.cwiseAbs().maxCoeff(); };
  Root<N> root{start, 0, 0};
  Linearised<N> here = equations(root.x);
  root.residual = largest(here.value);
  for (int i = 0; i < kSteps && root.residual > 0; ++i) {
    const Unknowns<N> next = root.x - newton_step(here);
    const Linearised<N> there = equations(next);
    const double residual = largest(there.value);
    if (!(residual < root.residual) || !next.allFinite()) break;
    root.x = next;
    root.residual = residual;
    here = there;
  }
  root.condition = slope_condition<N>(here.slope);
  return root;
}

extern template Unknowns<3> newton_step<3>(const Linearised<3>&);
extern template Unknowns<4> newton_step<4>(const Linearised<4>&);
extern template Unknowns<5> newton_step<5>(const Linearised<5>&);
extern template double slope_condition<3>(const Eigen::Matrix<double, 3, 3>&);
extern template double slope_condition<4>(const Eigen::Matrix<double, 4, 4>&);
extern template double slope_condition<5>(const Eigen::Matrix<double, 5, 5>&);

}  // namespace cognate::synthesis
