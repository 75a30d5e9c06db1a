/// @file Single designs in boxes of proportions, evaluated on another way than their bounds: link
/// lengths by the definition of the coordinates, joints by intersecting circles in 113 bits, the
/// linear unknowns by a dense least-squares solver.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "synthesis/bounds/path_bound.hpp"
#include "synthesis/bounds/proportion_box.hpp"

namespace cognate::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Complex = std::complex<double>;
using BoxPoint = std::array<double, synthesis::kBoxSides>;

/// Links in units of frame + crank. Empty where coupler and rocker are infinite.
struct Links {
  Quad crank, coupler, rocker, frame;
};
inline std::optional<Links> links_at(const synthesis::ProportionBox& box, const BoxPoint& at) {
  const Quad k = at[0], second = at[2];
  Quad difference = at[1], inverse = second / (1 - second);
  if (box.proportions != synthesis::Proportions::any) {
    difference = abs(2 * k - 1) * cos(Quad(at[1]));
    inverse = cos(second);
  }
  if (inverse < 1e-6) return std::nullopt;
  const Quad sum = 1 / inverse;
  return Links{1 - k, (sum + difference) / 2, (sum - difference) / 2, k};
}

struct Direction {
  Complex coupler, rocker;
};
/// By intersecting the circles about B and D; empty where they do not meet.
inline std::optional<Direction> directions_at(const Links& links, int assembly, Quad angle) {
  const Quad bx = links.crank * cos(angle), by = links.crank * sin(angle);
  const Quad dx = links.frame - bx, dy = -by, square = dx * dx + dy * dy;
  if (square < 1e-24 || links.coupler < 1e-12 || links.rocker < 1e-12) return std::nullopt;
  const Quad along =
      (square + links.coupler * links.coupler - links.rocker * links.rocker) / (2 * square);
  Quad across = links.coupler * links.coupler / square - along * along;
  if (across < -1e-25) return std::nullopt;
  across = across > 0 ? Quad(sqrt(across)) : Quad(0);
  across *= assembly;
  const Quad cx = along * dx - across * dy, cy = along * dy + across * dx;  // C − B
  const auto unit = [](Quad x, Quad y) {
    const Quad length = sqrt(x * x + y * y);
    return Complex(double(x / length), double(y / length));
  };
  return Direction{unit(cx, cy), unit(cx - dx, cy - dy)};
}

/// The best complex t and q for given s, by QR in real numbers; s too where `free`, along the x
/// axis where the direction is fixed.
struct Fit {
  Complex t, s, q;
};
inline Fit best_fit(const synthesis::TimedPath& path, const std::vector<Complex>& u,
                    std::optional<Complex> s) {
  const int n = int(u.size());
  Eigen::MatrixXd a(2 * n, 6);
  Eigen::VectorXd b(2 * n);
  for (int j = 0; j < n; ++j) {
    const double w = std::sqrt(path.weights[j]);
    const Complex e = std::polar(1.0, path.crank_angles[j]);
    const Complex point = path.points[j] - (s ? *s * e : Complex());
    const Complex one = path.pivot_fixed ? 0.0 : 1.0, turn = s ? Complex() : e;
    const Complex across = path.direction_fixed ? Complex() : turn * Complex(0, 1);
    const Complex i(0, 1);
    const Complex columns[6] = {one, one * i, turn, across, u[j], u[j] * i};
    for (int c = 0; c < 6; ++c) {
      a(2 * j, c) = w * columns[c].real();
      a(2 * j + 1, c) = w * columns[c].imag();
    }
    b(2 * j) = w * point.real();
    b(2 * j + 1) = w * point.imag();
  }
  const Eigen::VectorXd x = a.completeOrthogonalDecomposition().solve(b);
  return {{x[0], x[1]}, s ? *s : Complex(x[2], x[3]), {x[4], x[5]}};
}

inline double error_of(const synthesis::TimedPath& path, const std::vector<Complex>& u,
                       const Fit& fit) {
  double sum = 0;
  for (std::size_t j = 0; j < u.size(); ++j) {
    const Complex at = fit.t + fit.s * std::polar(1.0, path.crank_angles[j]) + fit.q * u[j];
    sum += path.weights[j] * std::norm(at - path.points[j]);
  }
  return sum;
}

}  // namespace cognate::test
