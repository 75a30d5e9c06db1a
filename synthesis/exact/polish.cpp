#include "synthesis/exact/polish.hpp"

#include <Eigen/LU>
#include <cmath>

namespace cognate::synthesis {

template <int N>
Unknowns<N> newton_step(const Linearised<N>& here) {
  return here.slope.partialPivLu().solve(here.value);
}

template <int N>
double slope_condition(const Eigen::Matrix<double, N, N>& slope) {
  const Eigen::Matrix<double, N, N> scaled = slope.colwise().normalized();
  const Eigen::Matrix<double, N, N> inverse = scaled.inverse();
  const auto one_norm = [](const auto& m) { return m.cwiseAbs().colwise().sum().maxCoeff(); };
  const double condition = one_norm(scaled) * one_norm(inverse);
  return std::isfinite(condition) ? condition : HUGE_VAL;
}

template Unknowns<3> newton_step<3>(const Linearised<3>&);
template Unknowns<4> newton_step<4>(const Linearised<4>&);
template Unknowns<5> newton_step<5>(const Linearised<5>&);
template double slope_condition<3>(const Eigen::Matrix<double, 3, 3>&);
template double slope_condition<4>(const Eigen::Matrix<double, 4, 4>&);
template double slope_condition<5>(const Eigen::Matrix<double, 5, 5>&);

}  // namespace cognate::synthesis
