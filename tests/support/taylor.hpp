/// @file Truncated Taylor series: a second route to the derivatives of anything that is a template
/// over its number type.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::test {

/// Σ cₖ tᵏ up to t³.
struct Taylor {
  std::array<double, 4> c{};

  Taylor() = default;
  explicit Taylor(double value) : c{value, 0, 0, 0} {}
  Taylor(double c0, double c1, double c2, double c3) : c{c0, c1, c2, c3} {}

  /// The k-th derivative at t = 0.
  double derivative(int k) const {
    constexpr std::array<double, 4> kFactorial{1, 1, 2, 6};
    return c[static_cast<std::size_t>(k)] * kFactorial[static_cast<std::size_t>(k)];
  }

  friend Taylor operator+(const Taylor& a, const Taylor& b) {
    return {a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2], a.c[3] + b.c[3]};
  }
  friend Taylor operator-(const Taylor& a) { return {-a.c[0], -a.c[1], -a.c[2], -a.c[3]}; }
  friend Taylor operator-(const Taylor& a, const Taylor& b) { return a + (-b); }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor product;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; i + j < 4; ++j) product.c[i + j] += a.c[i] * b.c[j];
    }
    return product;
  }
  friend Taylor operator/(const Taylor& a, const Taylor& b) {
    Taylor quotient;
    for (std::size_t k = 0; k < 4; ++k) {
      double rest = a.c[k];
      for (std::size_t j = 0; j < k; ++j) rest -= quotient.c[j] * b.c[k - j];
      quotient.c[k] = rest / b.c[0];
    }
    return quotient;
  }
  friend Taylor sqrt(const Taylor& a) {
    Taylor root(std::sqrt(a.c[0]));
    for (std::size_t k = 1; k < 4; ++k) {
      double rest = a.c[k];
      for (std::size_t j = 1; j < k; ++j) rest -= root.c[j] * root.c[k - j];
      root.c[k] = rest / (2 * root.c[0]);
    }
    return root;
  }
};

/// The positions of all bodies as series in the drive coordinate about `at`.
inline std::vector<BodyMotion<Taylor, 0>> taylor_motion(const Mechanism<double>& mechanism,
                                                        double at) {
  const double c = std::cos(at), s = std::sin(at);
  DrivePosition<Taylor> drive{{{c, -s, -c / 2, s / 6}, {s, c, -s / 2, -c / 6}}, {at, 1, 0, 0}};
  const auto series = convert<Taylor>(mechanism);
  std::vector<Taylor> signs;
  for (const double side : sides(mechanism)) signs.emplace_back(side);
  std::vector<BodyMotion<Taylor, 0>> bodies(static_cast<std::size_t>(body_count(mechanism)));
  std::vector<DyadClosure<Taylor>> closures(mechanism.dyads.size());
  evaluate<0>(series, drive, signs, bodies, closures);
  return bodies;
}

}  // namespace cognate::test
