/// @file The closure of the four-bar on given doubles with 237 bits, how sensitive it is to them,
/// and how far they are from where it stops closing.
///
/// The formula is the plain circle–circle intersection, not the kernel's: of 237 bits, 113 and more
/// are left after the worst cancellation that doubles can bring about.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "analysis/linkage/closure.hpp"

namespace cognate::stress {

using Exact = boost::multiprecision::cpp_bin_float_oct;

/// The unit roundoff of double: what rounding may change a number by, relative to it.
inline constexpr double kUnit = 0x1p-53;

/// A four-bar at a crank direction, in the frame's axes: exactly what the formulas are given.
struct Configuration {
  Lengths<double> links;
  Vec2d half_crank{1, 0};  ///< along e^{iθ/2}, of length one within rounding
  double assembly = 1;
  Vec2d coupler_point{};  ///< (u, v) from B, first axis B→C
};

/// Where the links point and the coupler point lies (from A), and the sum over the input doubles x
/// of |x·∂/∂x| of each: how much it changes when every input changes by its rounding, over that.
/// The points' numbers are relative to `size` = l₁ + |(u, v)|.
struct ExactClosure {
  bool closes = false;
  /// By how many units of rounding all inputs must change to reach the nearest place where the
  /// linkage stops (or begins) to close.
  double boundary_distance = 0;
  Vec2<Exact> coupler, rocker, point;
  double size = 0;
  double coupler_condition = 0, rocker_condition = 0, point_condition = 0;
};

ExactClosure exact_closure(const Configuration& at);

/// Cosine and sine of the crank angle, each rounded once: the best that a formula which takes
/// them can be given.
Vec2d rounded_crank(const Vec2d& half_crank);

/// The crank's half angle vector for which |B − D| = `diagonal` (0 < θ < π), rounded to double.
Vec2d half_crank_for(const Lengths<double>& links, const Exact& diagonal);

/// |a − b| in units of rounding.
double distance(const Vec2d& a, const Vec2<Exact>& b);

}  // namespace cognate::stress
