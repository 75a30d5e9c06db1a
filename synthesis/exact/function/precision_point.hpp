/// @file Points at which a function generator is exact, and the power series behind them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

/// At most so many conditions can be met: a four-bar function generator has three ratios of lengths
/// and two start angles, a slider-crank three lengths, a start angle and a start displacement.
inline constexpr std::size_t kMostConditions = 5;

/// One position that is met, and how closely: with multiplicity k the output and its first k − 1
/// derivatives by the input are the desired ones, as if k precision points had run together there
/// (infinitesimally close positions). Angles in radians, counted from the start.
struct PrecisionPoint {
  double input = 0;
  /// The desired output and its derivatives by the input, `multiplicity` of them.
  std::array<double, kMostConditions> output{};
  std::size_t multiplicity = 1;
};

/// How many conditions `points` are: the sum of their multiplicities.
std::size_t condition_count(std::span<const PrecisionPoint> points);

/// Start angles (for a slider-crank a start angle and a start displacement) that are given; what is
/// empty is found.
struct GivenStart {
  std::optional<double> input, output;
};

/// Coefficients of a power series in the input's deviation, as many as the multiplicity.
using RealSeries = std::array<double, kMostConditions>;
/// As RealSeries, of complex numbers.
using ComplexSeries = std::array<Vec2d, kMostConditions>;

/// The series of the output: derivatives over factorials.
RealSeries output_series(const PrecisionPoint& point);

/// The series of e^{i·angle}, from E′ = i·angle′·E.
ComplexSeries direction_series(const RealSeries& angle, std::size_t count);

/// The series of a product.
RealSeries product(const RealSeries& a, const RealSeries& b, std::size_t count);
ComplexSeries product(const RealSeries& a, const ComplexSeries& b, std::size_t count);

}  // namespace cognate::synthesis
