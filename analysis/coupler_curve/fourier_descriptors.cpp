#include "analysis/coupler_curve/fourier_descriptors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

/// The integral from the third of six samples to the fourth, over the step: by the polynomial
/// through six samples about it (weights of its antiderivative, of order h⁷).
double step_integral(const double* f) {
  return (11 * (f[0] + f[5]) - 93 * (f[1] + f[4]) + 802 * (f[2] + f[3])) / 1440;
}

/// The other way round: c₋ₖ in place of cₖ.
void reverse(FourierDescriptors& found) {
  std::ranges::reverse(found.coefficients);
}

/// Turns the curve by β and starts it so that cₖ is multiplied by e^{i(β + kα)}.
void turn(FourierDescriptors& found, double turned, double started) {
  for (int k = -kHarmonics; k <= kHarmonics; ++k) {
    Vec2d& c = found.of(k);
    c = unit_vector(turned + k * started) * c;
  }
}

/// As `FourierDescriptors` has it. A coefficient that is nothing but rounding has no direction.
void normalise(FourierDescriptors& found) {
  constexpr double kNothing = 1e-12;
  if (norm(found.of(1)) < norm(found.of(-1))) reverse(found);
  const double first = angle_of(found.of(1));
  const double last = norm(found.of(-1)) > kNothing ? angle_of(found.of(-1)) : first;
  turn(found, -0.5 * (first + last), -0.5 * (first - last));
  if (found.of(2).x < -kNothing) turn(found, kTurn / 2, kTurn / 2);
}

}  // namespace

FourierDescriptors DescriptorFinder::operator()(const CurveSamples& curve) {
  const std::size_t count = curve.size();
  // Two samples before the first and three beyond the last are those of the turn before and after.
  speed_.resize(count + 5);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double speed = std::sqrt(curve.dx[i] * curve.dx[i] + curve.dy[i] * curve.dy[i]);
    speed_[i + 2] = speed;
    sum += speed;
  }
  for (const std::size_t i : {0, 1}) speed_[i] = speed_[i + count];
  for (const std::size_t i : {2, 3, 4}) speed_[i + count] = speed_[i];
  // With φ = 2πs/L, integration by parts: 2πi k cₖ = ∮ P′ e^{−ikφ}, and L = 2π sum/count.
  FourierDescriptors found;
  double along = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d rate{curve.dx[i], curve.dy[i]};
    const Vec2d back = unit_vector(-kTurn * along / sum);
    Vec2d power = back;
    for (int k = 1; k <= kHarmonics; ++k, power = power * back) {
      Vec2d& forward = found.of(k);
      Vec2d& backward = found.of(-k);
      forward = forward + rate * power;
      backward = backward + rate * conj(power);
    }
    along += step_integral(speed_.data() + i);
  }
  for (int k = 1; k <= kHarmonics; ++k) {
    Vec2d& forward = found.of(k);
    Vec2d& backward = found.of(-k);
    forward = (1 / (k * sum)) * Vec2d{forward.y, -forward.x};
    backward = (1 / (k * sum)) * Vec2d{-backward.y, backward.x};
  }
  normalise(found);
  return found;
}

FourierDescriptors descriptors_of(std::span<const Vec2d> points, double length) {
  FourierDescriptors found;
  const auto count = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = -kHarmonics; k <= kHarmonics; ++k) {
      if (k == 0) continue;
      Vec2d& c = found.of(k);
      c = c + unit_vector(-kTurn * k * static_cast<double>(i) / count) * points[i];
    }
  }
  for (Vec2d& c : found.coefficients) c = (kTurn / (length * count)) * c;
  normalise(found);
  return found;
}

double squared_distance(const FourierDescriptors& a, const FourierDescriptors& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const bool mirrored : {false, true}) {
    for (const bool reversed : {false, true}) {
      for (const double even : {1.0, -1.0}) {  // half a turn on, from half a length on
        double sum = 0;
        for (int k = -kHarmonics; k <= kHarmonics; ++k) {
          const Vec2d& other = b.of(reversed ? -k : k);
          const Vec2d turned = (k % 2 == 0 ? even : 1.0) * (mirrored ? conj(other) : other);
          sum += squared_norm(a.of(k) - turned);
        }
        least = std::min(least, sum);
      }
    }
  }
  return least;
}

}  // namespace cognate
