#include "problems/linkage/driven_range.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// Solvers keep the cosines this much inside, so that rounding does not open a linkage at the ends.
constexpr double kRangeMargin = 1e-11;

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

/// An angle on a way, and whether it moves with either end.
struct Place {
  double angle = 0, by_from = 0, by_to = 0;
};

/// The angle on the way nearest to 0 or to π, modulo 2π.
Place extreme(const Range& way, bool shortest) {
  const double aim = shortest ? 0 : kPi;
  if (aim + kTurn * std::ceil((way.min - aim) / (kTurn)) <= way.max) return {aim, 0, 0};
  const double near = std::remainder(way.min - aim, kTurn);
  const double far = std::remainder(way.max - aim, kTurn);
  return std::abs(near) <= std::abs(far) ? Place{way.min, 1, 0} : Place{way.max, 0, 1};
}

}  // namespace

DrivenRange::DrivenRange(const Constraints& constraints, const Range& increments)
    : is_limited_(constraints.transmission_angle || constraints.no_circuit_defect ||
                  constraints.no_order_defect),
      increments_(increments) {
  if (!constraints.transmission_angle) return;
  greatest_cosine_ = std::cos(constraints.transmission_angle->min);
  least_cosine_ = std::cos(constraints.transmission_angle->max);
}

void DrivenRange::evaluate(const DrivenCrank& at, std::span<double> values,
                           std::span<DrivenSlopes> slopes) const {
  std::array<WaySlopes, kLimits> all{};
  evaluate(at.links, {increments_.min + at.offset, increments_.max + at.offset}, values,
           slopes.empty() ? std::span<WaySlopes>{} : all);
  for (std::size_t row = 0; row < slopes.size(); ++row) {
    std::copy_n(all[row].begin(), 4, slopes[row].begin());
    slopes[row][4] = all[row][4] + all[row][5];
  }
}

void DrivenRange::evaluate(const Lengths<double>& links, const Range& way, std::span<double> values,
                           std::span<WaySlopes> slopes) const {
  if (!is_limited_) return;
  for (const bool shortest : {true, false}) {
    const Place place = extreme(way, shortest);
    const TransmissionCosine<double> mu({links.crank, links.coupler, links.rocker, links.frame},
                                        place.angle);
    const std::size_t row = shortest ? 0 : 1;
    const double sense = shortest ? -1 : 1;
    values[row] = sense * (mu.value - (shortest ? greatest_cosine_ : least_cosine_)) - kRangeMargin;
    if (slopes.empty()) continue;
    for (std::size_t i = 0; i < 4; ++i) slopes[row][i] = sense * mu.slopes[i];
    slopes[row][4] = place.by_from * sense * mu.slopes[4];
    slopes[row][5] = place.by_to * sense * mu.slopes[4];
  }
}

void DrivenRange::add_hessian(const DrivenCrank& at, std::span<const double> weights,
                              std::span<double, 25> out) const {
  if (!is_limited_) return;
  using Jet = ceres::Jet<double, 5>;
  const auto& [crank, coupler, rocker, frame] = at.links;
  for (const bool shortest : {true, false}) {
    const Place place =
        extreme({increments_.min + at.offset, increments_.max + at.offset}, shortest);
    const double moves = place.by_from + place.by_to;
    Jet angle(place.angle, 4);
    angle.v[4] = moves;
    const TransmissionCosine<Jet> mu(
        {Jet(crank, 0), Jet(coupler, 1), Jet(rocker, 2), Jet(frame, 3)}, angle);
    const double weight = shortest ? -weights[0] : weights[1];
    for (int i = 0; i < 5; ++i) {
      const double share = i == 4 ? moves * weight : weight;
      for (int j = 0; j < 5; ++j) out[5 * i + j] += share * mu.slopes[i].v[j];
    }
  }
}

}  // namespace cognate::problems
