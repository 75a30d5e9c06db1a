/// @file Measures of a sampled closed curve: its length, the area that it encloses, its widths.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Sums over the samples of curves that stand side by side. The rule of equal steps converges with
/// a power of e where the curve is smooth and as the square of the step where it has a cusp.
struct CurveSums {
  std::vector<double> length;       ///< ∮ |P′|
  std::vector<double> half_length;  ///< the same by every second sample
  std::vector<double> area;         ///< ½ ∮ P × P′, positive where it runs counter-clockwise

  /// Of `curves` curves; sample j of curve i is at j·curves + i, and the samples are even in
  /// number.
  void add_up(const CurveSamples& samples, std::size_t curves);

  /// Whether the length of curve i is settled: by every second sample it is the same to 1e-6, and
  /// then the error of all samples, which of a smooth curve goes with the square of that, is 1e-11.
  bool is_settled(std::size_t i) const;
};

/// Numbers of samples to take, until the length is settled or the last is reached.
inline constexpr std::size_t kCurveSteps[] = {128, 512, 2048, 8192};

/// The extent of a curve between parallel lines: across which it is least, and its diameter.
struct CurveWidths {
  double least = 0;
  double greatest = 0;
};

/// Finds widths; keeps its room from curve to curve. Between samples the curve is taken for the
/// cubics through its points and derivatives.
class WidthFinder {
 public:
  /// The widths of a closed curve.
  CurveWidths operator()(const CurveSamples& curve);

 private:
  static constexpr std::size_t kDirections = 90;
  static constexpr double kStep = kPi / kDirections;

  static double sampled_width(const CurveSamples& curve, const Vec2d& direction);
  /// The greatest (`sense` = 1) or least (−1) width next to the direction at `angle`.
  double refined(const CurveSamples& curve, double angle, double diameter, double sense);
  void find_candidates(const CurveSamples& curve, double angle, double diameter);
  double candidates_width(const CurveSamples& curve, const Vec2d& direction) const;

  std::array<double, kDirections> widths_{};  ///< of the directions that are looked at
  std::vector<std::size_t> low_, high_;       ///< samples next to which the lines touch
};

/// The box, along the axes of the plane, that holds the moving pivots B and C over a circuit: its
/// diagonal. From the ranges of crank and rocker, which go through arcs of circles.
double moving_pivots_size(const FourBar& linkage, const CircuitChoice& circuit);

}  // namespace cognate
