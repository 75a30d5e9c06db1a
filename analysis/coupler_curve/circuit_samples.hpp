/// @file A coupler curve over one circuit as a closed curve, sampled so that sums over the samples
/// are integrals.
///
/// The square δ of the diagonal |BD| settles both triangles A–B–D and B–C–D but for their sides. It
/// swings between the greater of |l₄ − l₁|, |l₂ − l₃| and the less of l₄ + l₁, l₂ + l₃, squared,
/// and at either end the triangle that is in line there passes to its other side. With
/// δ = m − h cos τ that root is smooth: the circuit is an analytic function of τ of period 2π where
/// the same triangle is in line at both ends (a crank that turns fully: τ is its angle from A→D; or
/// two ranges of the crank) and 4π where each is at one (one range of the crank). Of such functions
/// equal steps integrate with an error that falls as a power of e with their number (Trefethen &
/// Weideman 2014), dead points included.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/linkage/four_bar.hpp"

namespace cognate {

/// Which circuit of a linkage: the assembly distinguishes the two of a crank that turns fully,
/// `half` those of a crank with two ranges, +1 with B to the left of A→D.
struct CircuitChoice {
  Assembly assembly = Assembly::open;
  int half = 1;
};

/// The circuit that `linkage` is on with its crank at `crank_angle` from the x axis or, where it
/// does not close there, reaches first as that grows.
CircuitChoice circuit_at(const FourBar& linkage, double crank_angle);

/// Samples of a closed curve in equal steps of a parameter of period 2π, and the derivatives by it.
struct CurveSamples {
  std::span<const double> x, y, dx, dy;

  std::size_t size() const { return x.size(); }
};

/// Room for samples.
struct CurveRoom {
  std::vector<double> x, y, dx, dy;

  void resize(std::size_t count);
  CurveSamples samples() const { return {x, y, dx, dy}; }
};

/// The directions of a table of equal steps of a turn.
struct CycleTable {
  explicit CycleTable(std::size_t count);

  std::vector<double> cos, sin;
};

/// The curve of the linkage's coupler point over `circuit` at the steps of `table`, into `curve`.
/// It runs as the crank's angle grows while the linkage is in `circuit.assembly`. The linkage can
/// be assembled. At a change point circuits meet; each is here as if it had none, with a corner.
void sample_circuit(const FourBar& linkage, const CircuitChoice& circuit, const CycleTable& table,
                    CurveRoom& curve);

}  // namespace cognate
