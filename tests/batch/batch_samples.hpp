/// @file Random designs for the tests of batches, and the coupler point by another route.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"

namespace cognate {

/// A design by the order of DesignVariable, with its assembly.
struct SampleDesign {
  std::array<double, kDesignVariables> variables{};
  double assembly = 1;

  FourBar four_bar() const {
    const auto& v = variables;
    return {{v[0], v[1]},
            {v[2], v[3]},
            v[4],
            v[5],
            v[6],
            assembly > 0 ? Assembly::open : Assembly::crossed,
            Vec2d{v[7], v[8]}};
  }
};

template <class Real>
constexpr double unit_roundoff = std::numeric_limits<Real>::epsilon() / 2.0;

/// What Real makes of the design.
template <class Real>
SampleDesign rounded(SampleDesign design) {
  for (double& one : design.variables) one = static_cast<Real>(one);
  return design;
}

/// Lengths of 0.3 to 2 on pivots about as far apart: about half of the positions close.
inline std::vector<SampleDesign> sample_designs(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-1, 1), length(0.3, 2);
  std::vector<SampleDesign> designs(count);
  for (SampleDesign& one : designs) {
    auto& v = one.variables;
    v = {place(random),  place(random),  place(random), place(random), length(random),
         length(random), length(random), place(random), place(random)};
    one.assembly = random() % 2 ? 1 : -1;
  }
  return designs;
}

inline std::vector<double> sample_angles(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(-4, 4);
  std::vector<double> angles(count);
  for (double& one : angles) one = angle(random);
  return angles;
}

/// Designs as the structure of arrays that a batch takes.
template <class Real>
struct DesignArrays {
  std::array<std::vector<Real>, kDesignVariables> values;
  std::vector<Real> assembly;

  explicit DesignArrays(const std::vector<SampleDesign>& designs) {
    for (const SampleDesign& one : designs) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k].push_back(static_cast<Real>(one.variables[k]));
      }
      assembly.push_back(static_cast<Real>(one.assembly));
    }
  }
  FourBarArrays<Real> arrays() const {
    return {values[0], values[1], values[2], values[3], values[4],
            values[5], values[6], assembly,  values[7], values[8]};
  }
};

/// Memory for every column of a batch.
template <class Real>
struct AllColumns {
  std::array<std::vector<Real>, 9> motion;
  std::array<std::vector<Real>, kDesignVariables> by_x, by_y;

  explicit AllColumns(std::size_t size) {
    for (auto& one : motion) one.assign(size, Real(-7));
    for (auto& one : by_x) one.assign(size, Real(-7));
    for (auto& one : by_y) one.assign(size, Real(-7));
  }
  FourBarColumns<Real> columns() {
    FourBarColumns<Real> all{motion[0], motion[1], motion[2], motion[3], motion[4], motion[5],
                             motion[6], motion[7], motion[8], {},        {}};
    for (std::size_t k = 0; k < kDesignVariables; ++k) {
      all.gradient_x[k] = by_x[k];
      all.gradient_y[k] = by_y[k];
    }
    return all;
  }
  /// All values one after the other.
  std::vector<Real> values() const {
    std::vector<Real> all;
    for (const auto* group : {&by_x, &by_y}) {
      for (const auto& one : *group) all.insert(all.end(), one.begin(), one.end());
    }
    for (const auto& one : motion) all.insert(all.end(), one.begin(), one.end());
    return all;
  }
};

/// The coupler point by the textbook: the angles of the links, from the law of cosines. T needs
/// sqrt, cos, sin, acos and atan2.
template <class T>
Vec2<T> textbook_point(const std::array<T, kDesignVariables>& v, const T& theta, double assembly) {
  using std::acos;
  using std::atan2;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T fx = v[2] - v[0], fy = v[3] - v[1];
  const T frame = atan2(fy, fx);
  const Vec2<T> b{v[0] + v[4] * cos(T(frame + theta)), v[1] + v[4] * sin(T(frame + theta))};
  const T dx = v[2] - b.x, dy = v[3] - b.y;
  const T diagonal = sqrt(T(dx * dx + dy * dy));
  const T at_b = acos(T((v[5] * v[5] + diagonal * diagonal - v[6] * v[6]) / (2 * v[5] * diagonal)));
  const T phi = atan2(dy, dx) + T(assembly) * at_b;
  return {b.x + v[7] * cos(phi) - v[8] * sin(phi), b.y + v[7] * sin(phi) + v[8] * cos(phi)};
}

}  // namespace cognate
