/// @file Fits of Freudenstein's equation at many pairs of start angles at a time, one in each SIMD
/// lane. Include in kernels alone.
#pragma once

#include "synthesis/lanes/function_fit_kernel.hpp"
#include "synthesis/lanes/lane_directions.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// The fits of one pack of start angles; see `fit_freudenstein`.
class FreudensteinLanes {
 public:
  FreudensteinLanes(const FreudensteinTask& task, long first)
      : targets_(task.targets),
        input_start_{load(task.input_x + first), load(task.input_y + first)},
        output_start_{load(task.output_x + first), load(task.output_y + first)} {}

  /// Least squares of the equation's residual as it stands.
  void fit() {
    Sums sums;
    for (int j = 0; j < targets_.samples; ++j) sums.add(row(j), Real(1.0));
    sums.solve(p_);
  }

  /// Again, each residual over its slope in the output angle at the fit before.
  void fit_by_slopes() {
    Real mean(0.0);
    for (int j = 0; j < targets_.samples; ++j) mean = mean + squared_slope(row(j));
    mean = mean / Real(double(targets_.samples));
    Sums sums;
    for (int j = 0; j < targets_.samples; ++j) {
      const Row at = row(j);
      // Bounded where the slope vanishes.
      sums.add(at, mean / (squared_slope(at) + Real(1e-3) * mean));
    }
    sums.solve(p_);
  }

  const Real& ratio(int i) const { return p_[i]; }

 private:
  /// θ₁ and θ₃ of one pair, and θ₃ − θ₁.
  struct Row {
    Direction input, output, between;
  };

  /// The normal equations Σ w a aᵀ p = Σ w cos θ₁ a, a = (cos θ₃, cos(θ₃ − θ₁), 1).
  struct Sums {
    Real weight, a, b, aa, ab, bb, right, ra, rb;

    Sums() { weight = a = b = aa = ab = bb = right = ra = rb = Real(0.0); }

    void add(const Row& row, const Real& w) {
      const Real& x = row.output.x;
      const Real& y = row.between.x;
      const Real wx = w * x, wy = w * y;
      weight = weight + w;
      a = a + wx;
      b = b + wy;
      aa = aa + wx * x;
      ab = ab + wx * y;
      bb = bb + wy * y;
      right = right + w * row.input.x;
      ra = ra + wx * row.input.x;
      rb = rb + wy * row.input.x;
    }

    /// The constant is eliminated first; what has no solution comes out as no number.
    void solve(Real (&p)[3]) const {
      const Real inverse = Real(1.0) / weight;
      const Real xx = aa - inverse * a * a, xy = ab - inverse * a * b, yy = bb - inverse * b * b;
      const Real rx = ra - inverse * a * right, ry = rb - inverse * b * right;
      const Real over = Real(1.0) / (xx * yy - xy * xy);
      p[0] = over * (rx * yy - ry * xy);
      p[1] = over * (ry * xx - rx * xy);
      p[2] = inverse * (right - p[0] * a - p[1] * b);
    }
  };

  Row row(int j) const {
    const Direction half{Real(targets_.half_input_x[j]), Real(targets_.half_input_y[j])};
    const Direction wanted{Real(targets_.output_x[j]), Real(targets_.output_y[j])};
    const Direction input = half * half * input_start_, output = wanted * output_start_;
    return {input, output, conj(input) * output};
  }

  Real squared_slope(const Row& row) const {
    const Real slope = p_[0] * row.output.y + p_[1] * row.between.y;
    return slope * slope;
  }

  FunctionTargets targets_;
  Direction input_start_, output_start_;
  Real p_[3];
};

inline void fit_all(const FreudensteinTask& task) {
  for (long i = 0; i < task.count; i += kLanes) {
    FreudensteinLanes lanes(task, i);
    lanes.fit();
    for (int k = 0; k < task.reweightings; ++k) lanes.fit_by_slopes();
    for (int k = 0; k < 3; ++k) store(lanes.ratio(k), task.ratio[k] + i);
  }
}

}  // namespace cognate::synthesis::COGNATE_ISA
