#include "problems/function/target/derivatives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr int kPolynomialDegree = 24;
constexpr int kWindows = 14;
constexpr double kShrink = 0.7;

using Coefficients = std::array<double, kPolynomialDegree + 1>;

/// The part of the domain about x, `width` wide, moved inwards where it would leave the domain.
Range window_about(double x, const Range& domain, double width) {
  const double low = std::clamp(x - 0.5 * width, domain.min, domain.max - width);
  return {std::max(low, domain.min), std::min(low + width, domain.max)};
}

/// The Chebyshev coefficients of the polynomial through f at the extreme points of a window.
Coefficients interpolant(const std::function<double(double)>& f, const Range& window) {
  const double middle = 0.5 * (window.min + window.max), half = 0.5 * (window.max - window.min);
  Coefficients values{}, result{};
  for (int j = 0; j <= kPolynomialDegree; ++j) {
    const double t = std::cos(kPi * j / kPolynomialDegree);
    values[j] = f(std::clamp(middle + half * t, window.min, window.max));
  }
  for (int k = 0; k <= kPolynomialDegree; ++k) {
    double sum = 0;
    for (int j = 0; j <= kPolynomialDegree; ++j) {
      const double end = j == 0 || j == kPolynomialDegree ? 0.5 : 1;
      // The angle is reduced by whole turns before it is rounded.
      sum +=
          end * values[j] * std::cos(kPi * ((j * k) % (2 * kPolynomialDegree)) / kPolynomialDegree);
    }
    result[k] = sum * (k == 0 || k == kPolynomialDegree ? 1.0 : 2.0) / kPolynomialDegree;
  }
  return result;
}

/// The coefficients of the derivative by t in [−1, 1].
Coefficients slope(const Coefficients& c) {
  Coefficients d{};
  for (int k = kPolynomialDegree; k > 0; --k) {
    const double above = k + 1 <= kPolynomialDegree ? d[k + 1] : 0;
    d[k - 1] = above + 2 * k * c[k];
  }
  d[0] *= 0.5;
  return d;
}

double value(const Coefficients& c, double t) {
  double b1 = 0, b2 = 0;
  for (int k = kPolynomialDegree; k > 0; --k) {
    const double b0 = 2 * t * b1 - b2 + c[k];
    b2 = b1;
    b1 = b0;
  }
  return t * b1 - b2 + c[0];
}

/// The degree behind which coefficients are rounding; kPolynomialDegree where they do not fall so
/// far, so that the polynomial is not the function.
int resolved_degree(const Coefficients& c) {
  double largest = 0;
  for (const double coefficient : c) largest = std::max(largest, std::abs(coefficient));
  const double noise = 8 * std::numeric_limits<double>::epsilon() * largest;
  int degree = kPolynomialDegree;
  while (degree > 0 && std::abs(c[degree]) <= noise) --degree;
  return degree;
}

/// A bound of Σ |Tⱼ⁽ᵏ⁾(t)| up to `degree`: what derivatives make of rounding in the coefficients.
/// V. A. Markov's bound holds everywhere, Bernstein's form of it away from the ends.
double amplification(int degree, std::size_t k, double t) {
  double sum = 0;
  for (int j = 1; j <= degree; ++j) {
    double end = 1, inside = 1;
    for (std::size_t i = 0; i < k; ++i) {
      const auto order = static_cast<double>(i);
      end *= (j * j - order * order) / (2 * order + 1);
      inside *= j / std::sqrt(std::max(1 - t * t, 1e-300));
    }
    sum += std::min(std::max(end, 0.0), 2 * inside);
  }
  return sum;
}

/// What one window says.
std::vector<Derivative> in_window(const std::function<double(double)>& f, double x,
                                  const Range& window, std::size_t count, bool& resolved) {
  const double half = 0.5 * (window.max - window.min);
  const double t = std::clamp((x - window.min) / half - 1, -1.0, 1.0);
  Coefficients c = interpolant(f, window);
  const int degree = resolved_degree(c);
  resolved = degree <= kPolynomialDegree - 3;
  double change = 0;
  for (int k = 1; k <= kPolynomialDegree; ++k) {
    if (k > degree) c[k] = 0;
    change = std::max(change, std::abs(c[k]));
  }
  const double noise =
      16 * std::numeric_limits<double>::epsilon() * std::max(std::abs(c[0]), change);
  std::vector<Derivative> result;
  double unit = 1;
  for (std::size_t k = 1; k <= count; ++k) {
    c = slope(c);
    unit /= half;
    const double slope_there = unit * value(c, t);
    const double size = std::max(std::abs(slope_there), unit * change);
    const double error = unit * noise * amplification(degree, k, t);
    result.push_back({slope_there, size > 0 ? std::min(1.0, error / size) : 0});
  }
  return result;
}

}  // namespace

std::vector<Derivative> derivatives(const std::function<double(double)>& f, double x,
                                    const Range& domain, std::size_t count) {
  std::vector<Derivative> found(count, Derivative{0, 1});
  double width = domain.max - domain.min;
  for (int i = 0; i < kWindows; ++i, width *= kShrink) {
    bool resolved = false;
    found = in_window(f, x, window_about(x, domain, width), count, resolved);
    if (resolved) return found;
  }
  for (Derivative& derivative : found) derivative.relative_error = 1;
  return found;
}

}  // namespace cognate::problems
