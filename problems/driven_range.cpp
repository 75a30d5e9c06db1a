#include "problems/driven_range.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cognate::problems {
namespace {

constexpr double kPi = std::numbers::pi;
/// Solvers keep the cosines this much inside, so that rounding does not open a linkage at the ends.
constexpr double kMargin = 1e-11;

/// cos μ at the crank angle θ from the frame: d² = l₁² + l₄² − 2 l₁ l₄ cos θ, written as a square
/// and a product that do not cancel.
template <class T>
struct TransmissionCosine {
  T value;
  std::array<T, 5> slopes;

  TransmissionCosine(const std::array<T, 4>& l, const T& theta) {
    using std::cos;
    using std::sin;
    const T half = sin(T(0.5) * theta), apart = l[3] - l[0];
    const T inverse = T(1.0) / (l[1] * l[2]), product = l[0] * l[3];
    const T square = apart * apart + T(4.0) * product * half * half;
    const T cosine = cos(theta);
    value = T(0.5) * inverse * (l[1] * l[1] + l[2] * l[2] - square);
    slopes = {-(inverse * (l[0] - l[3] * cosine)), inverse * (l[1] - value * l[2]),
              inverse * (l[2] - value * l[1]), -(inverse * (l[3] - l[0] * cosine)),
              -(inverse * product * sin(theta))};
  }
};

}  // namespace

DrivenRange::DrivenRange(const Constraints& constraints, const Range& increments)
    : is_limited_(constraints.transmission_angle || constraints.no_circuit_defect ||
                  constraints.no_order_defect),
      increments_(increments) {
  if (!constraints.transmission_angle) return;
  greatest_cosine_ = std::cos(constraints.transmission_angle->min);
  least_cosine_ = std::cos(constraints.transmission_angle->max);
}

/// The angle on the way nearest to 0 or to π, modulo 2π; by the offset its derivative is 1 at an
/// end, and within, where it is 0, no slope is left either.
double DrivenRange::cosine_angle(double offset, bool shortest) const {
  const double aim = shortest ? 0 : kPi;
  const double from = increments_.min + offset, to = increments_.max + offset;
  const double first = aim + 2 * kPi * std::ceil((from - aim) / (2 * kPi));
  if (first <= to) return aim;
  const double near = std::remainder(from - aim, 2 * kPi), far = std::remainder(to - aim, 2 * kPi);
  return std::abs(near) <= std::abs(far) ? from : to;
}

void DrivenRange::evaluate(const DrivenCrank& at, std::span<double> values,
                           std::span<DrivenSlopes> slopes) const {
  if (!is_limited_) return;
  const auto& [crank, coupler, rocker, frame] = at.links;
  for (const bool shortest : {true, false}) {
    const TransmissionCosine<double> mu({crank, coupler, rocker, frame},
                                        cosine_angle(at.offset, shortest));
    const std::size_t row = shortest ? 0 : 1;
    const double sense = shortest ? -1 : 1;
    values[row] = sense * (mu.value - (shortest ? greatest_cosine_ : least_cosine_)) - kMargin;
    if (slopes.empty()) continue;
    for (std::size_t i = 0; i < mu.slopes.size(); ++i) slopes[row][i] = sense * mu.slopes[i];
  }
}

void DrivenRange::add_hessian(const DrivenCrank& at, std::span<const double> weights,
                              std::span<double, 25> out) const {
  if (!is_limited_) return;
  using Jet = ceres::Jet<double, 5>;
  const auto& [crank, coupler, rocker, frame] = at.links;
  for (const bool shortest : {true, false}) {
    const double aim = shortest ? 0 : kPi, theta = cosine_angle(at.offset, shortest);
    Jet angle(theta, 4);
    if (theta == aim) angle.v[4] = 0;  // it stays while the offset moves
    const TransmissionCosine<Jet> mu(
        {Jet(crank, 0), Jet(coupler, 1), Jet(rocker, 2), Jet(frame, 3)}, angle);
    const double weight = shortest ? -weights[0] : weights[1];
    for (int i = 0; i < 5; ++i) {
      const bool stays = theta == aim && i == 4;
      for (int j = 0; j < 5; ++j) out[5 * i + j] += stays ? 0 : weight * mu.slopes[i].v[j];
    }
  }
}

}  // namespace cognate::problems
