#include "analysis/gear/involute.hpp"

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

/// (tan α − α)/α³ of t = α², α ≤ 1: from the tenth convergent of Lambert's fraction
/// tan α = α/(1 − t/(3 − t/(5 − …))), which is right to 1e-18 there; nothing cancels.
double reduced_involute(double t) {
  const double above = 218243025 + t * (-16081065 + t * (289575 + t * (-1430 + t)));
  const double below =
      654729075 + t * (-310134825 + t * (18918900 + t * (-315315 + t * (1485 - t))));
  return above / below;
}

/// α from w = (3 inv α)^(1/3): the first terms of the inverse series.
double series_angle(double w) {
  const double w2 = w * w;
  return w * (1 + w2 * (-2.0 / 15 + w2 * (3.0 / 175 - w2 * (2.0 / 1575))));
}

/// Halley's step for tan α − α = value.
double halley_step(double angle, double value) {
  const double excess = involute(angle);
  const double slope_root = excess + angle;  // tan α, whose square is the derivative
  const double miss = excess - value;
  const double square = slope_root * slope_root;
  return angle - miss * slope_root / (slope_root * square - miss * (1 + square));
}

/// Newton's step for α = atan(value + α), which keeps its digits where the tangent is large.
double arc_tangent_step(double angle, double value) {
  const double tangent = value + angle;
  return angle - (angle - std::atan(tangent)) * (1 + 1 / (tangent * tangent));
}

/// Of 1e-150 and more: below, the steps underflow.
double positive_involute_angle(double value) {
  constexpr double kLarge = 1.8;  // the angle is 1.26 there
  if (value < kLarge) {
    const double start = series_angle(std::cbrt(3 * value));
    return halley_step(halley_step(start, value), value);
  }
  double angle = std::atan(value + kRightAngle);
  for (int step = 0; step < 3; ++step) angle = arc_tangent_step(angle, value);
  return angle;
}

}  // namespace

double involute(double angle) {
  if (std::abs(angle) > 1) return std::tan(angle) - angle;
  const double square = angle * angle;
  return angle * (square * reduced_involute(square));
}

double involute_angle(double value) {
  const double size = std::abs(value);
  if (size == 0) return value;
  // The cube root is all there is of a tiny angle, and scales with the argument.
  const double angle = size < 1e-150 ? 0x1p-100 * positive_involute_angle(0x1p300 * size)
                                     : positive_involute_angle(size);
  return std::copysign(angle, value);
}

double involute_of_degrees(double degrees) {
  const double angle = degrees * (kPi / 180);
  if (std::abs(degrees) <= 45) return involute(angle);
  const double complement = (90 - std::abs(degrees)) * (kPi / 180);
  return std::copysign(1 / std::tan(complement), degrees) - angle;
}

double involute_angle_in_degrees(double value) {
  return involute_angle(value) * (180 / kPi);
}

}  // namespace cognate::gear
