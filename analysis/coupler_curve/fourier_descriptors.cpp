#include "analysis/coupler_curve/fourier_descriptors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cognate {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Vec2d unit_at(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The part of an integral over one step between samples, over the step: by the polynomial through
/// six samples about it (weights of its antiderivative, of order h⁷).
double step_integral(const std::vector<double>& f, std::size_t i) {
  const std::size_t n = f.size();
  const auto at = [&](std::size_t k) { return f[(i + k + n - 2) % n]; };
  return (11 * (at(0) + at(5)) - 93 * (at(1) + at(4)) + 802 * (at(2) + at(3))) / 1440;
}

/// The other way round: c₋ₖ in place of cₖ.
void reverse(FourierDescriptors& found) {
  std::ranges::reverse(found.coefficients);
}

/// Turns the curve by β and starts it so that cₖ is multiplied by e^{i(β + kα)}.
void turn(FourierDescriptors& found, double turned, double started) {
  for (int k = -kHarmonics; k <= kHarmonics; ++k) {
    Vec2d& c = found.coefficients[static_cast<std::size_t>(k + kHarmonics)];
    c = unit_at(turned + k * started) * c;
  }
}

double angle(const Vec2d& c) {
  return std::atan2(c.y, c.x);
}

/// As `FourierDescriptors` has it. A coefficient that is nothing but rounding has no direction.
void normalise(FourierDescriptors& found) {
  constexpr double kNothing = 1e-12;
  if (norm(found.of(1)) < norm(found.of(-1))) reverse(found);
  const double first = angle(found.of(1));
  const double last = norm(found.of(-1)) > kNothing ? angle(found.of(-1)) : first;
  turn(found, -0.5 * (first + last), -0.5 * (first - last));
  if (found.of(2).x < -kNothing) turn(found, kTurn / 2, kTurn / 2);
}

}  // namespace

FourierDescriptors DescriptorFinder::operator()(const CurveSamples& curve) {
  const std::size_t count = curve.size();
  speed_.resize(count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    speed_[i] = std::sqrt(curve.dx[i] * curve.dx[i] + curve.dy[i] * curve.dy[i]);
    sum += speed_[i];
  }
  // With φ = 2πs/L, integration by parts: 2πi k cₖ = ∮ P′ e^{−ikφ}, and L = 2π sum/count.
  FourierDescriptors found;
  double along = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d rate{curve.dx[i], curve.dy[i]};
    const Vec2d back = unit_at(-kTurn * along / sum);
    Vec2d power = back;
    for (int k = 1; k <= kHarmonics; ++k, power = power * back) {
      Vec2d& forward = found.coefficients[static_cast<std::size_t>(kHarmonics + k)];
      Vec2d& backward = found.coefficients[static_cast<std::size_t>(kHarmonics - k)];
      forward = forward + rate * power;
      backward = backward + rate * conj(power);
    }
    along += step_integral(speed_, i);
  }
  for (int k = 1; k <= kHarmonics; ++k) {
    Vec2d& forward = found.coefficients[static_cast<std::size_t>(kHarmonics + k)];
    Vec2d& backward = found.coefficients[static_cast<std::size_t>(kHarmonics - k)];
    forward = (1 / (k * sum)) * Vec2d{forward.y, -forward.x};
    backward = (1 / (k * sum)) * Vec2d{-backward.y, backward.x};
  }
  normalise(found);
  return found;
}

}  // namespace cognate
