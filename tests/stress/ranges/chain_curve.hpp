/// @file The configurations of a six-bar by brute force: a curve in the space of all its angles,
/// followed by its arc length with Newton's method, through dead points and over all branches.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cognate::stress {

/// A four-bar A–B–C–D driven at A, and a dyad from a point of its coupler to a pivot or a slide of
/// the frame. Angles in degrees.
struct SixBar {
  double crank = 1, coupler = 1, rocker = 1;
  std::array<double, 2> d{}, p{}, e{};  ///< D; the point in the coupler's axes; pivot, or on slide
  double first = 1, second = 1;         ///< of the dyad; a slide's `second` is its direction
  bool slides = false;
  int side = 1, dyad_side = 1;
  double start = 0, end = 360;
};

/// What its motion is. Angles in degrees.
struct SixBarTruth {
  double stroke = 0;                  ///< of the first range: degrees or length
  std::optional<double> circuit{};    ///< 360 where the output turns fully
  std::vector<double> dead_points{};  ///< of the first range
  double least_transmission = 180, greatest_transmission = 0;  ///< of both dyads in it
};

/// Empty where it closes nowhere in the drive, and where the curve comes so near to itself that it
/// is not followed.
std::optional<SixBarTruth> truth_of(const SixBar& chain);

/// The file that analyses it.
std::string file_of(const SixBar& chain);

}  // namespace cognate::stress
