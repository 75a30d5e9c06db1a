/// @file The four-bar linkage A–B–C–D as data.
#pragma once

#include <optional>

#include "analysis/mechanism/assembly.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The four link lengths: crank A–B, coupler B–C, rocker C–D, frame A–D. One unit of length for
/// all.
template <class T>
struct Lengths {
  T crank{};
  T coupler{};
  T rocker{};
  T frame{};
};

/// A four-bar in the plane. `coupler_point` is (u, v) in the coupler's frame: origin B, first axis
/// from B to C. Lengths are positive and in the unit of the pivots.
struct FourBar {
  Vec2d pivot_a;
  Vec2d pivot_d;
  double crank = 0;
  double coupler = 0;
  double rocker = 0;
  Assembly assembly = Assembly::open;
  std::optional<Vec2d> coupler_point;
};

/// The link lengths of `linkage`, the frame being |D − A|.
Lengths<double> lengths(const FourBar& linkage);

/// The direction of A→D as an angle from the x axis, in (−π, π].
double frame_angle(const FourBar& linkage);

template <class T>
struct Mechanism;

/// The four-bar as a crank and an RRR dyad: body 1 is the crank, 2 the coupler, 3 the rocker.
Mechanism<double> as_mechanism(const FourBar& linkage);

}  // namespace cognate
